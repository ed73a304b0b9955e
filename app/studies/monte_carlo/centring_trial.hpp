// One run of a campaign: a true arm is drawn, touches holes, is calibrated by its touches, and is then sent to other
// holes; the same true arm under every setting, so that settings differ by themselves alone.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/studies/monte_carlo/true_arm.hpp"
#include "app/studies/monte_carlo/true_touches.hpp"
#include "app/studies/positioning/step_score.hpp"
#include "calibration/estimation/estimate.hpp"

namespace tubeplan::app {

/// Which holes are touched.
enum class TouchRule {
  kBest,    ///< those that place the base best, the same in every run
  kSpread,  ///< those furthest from each other, the same in every run
  kRandom,  ///< others in every run, well off a line
  kTested,  ///< the same, out of the holes that are then visited, as in the thesis's experiment
};

struct TouchRuleRow {
  TouchRule rule;
  std::string_view name, summary;
};
[[nodiscard]] std::span<const TouchRuleRow> touchRules();

/// How the base is calibrated.
struct CentringSetting {
  int touches = 3;
  TouchRule rule = TouchRule::kBest;
  double touch_sigma = 1.27e-4;  ///< m, centring noise of each coordinate; touches are weighed with 1e-6 m at least
};

/// Where the arm may be sent, and where it may touch where the best holes are asked for.
struct CentringHoles {
  std::vector<calibration::TouchPlan> visited, touchable;
};

struct CentringOptions {
  TruthSpread spread;
  calibration::DoubtBeside doubt;  ///< beside which touches are chosen and bases calibrated
  int holes = 10;                  ///< visited in a run, each time others
  std::uint64_t seed = 1;
  std::vector<CentringSetting> settings;
};

enum class TrialFailure { kNone, kTooNarrow, kUntouchable, kMistakenHole, kNotConverged, kRigidRefused };
inline constexpr std::size_t kTrialFailures = 6;

/// In a few words, "the true arm cannot touch one of the holes".
[[nodiscard]] std::string_view nameOf(TrialFailure failure);

/// Sent there with and without compensation; empty where that way finds no posture.
inline constexpr std::array<std::string_view, 2> kWays{"none", "compensated"};
inline constexpr std::array<std::string_view, kWays.size()> kWayWords{"without compensation", "with compensation"};
struct TrialVisit {
  int hole = -1;  ///< among those that may be visited
  std::array<std::optional<planner::Centring>, kWays.size()> centring;
};

/// Of one setting.
struct Trial {
  TrialFailure failure = TrialFailure::kNone;
  double touch_error = std::numeric_limits<double>::quiet_NaN();  ///< m, mean residual of the touches
  bool is_misfit = false;  ///< chi-square refuses the touches of the flexible arm
  std::vector<TrialVisit> visits;
};

/// Everything that no run changes.
class CentringTrials {
 public:
  /// There must be at least `options.holes` holes to visit and as many to touch as any setting asks for.
  CentringTrials(const planner::Workcell& model, const planner::Workcell& truth, const CentringHoles& holes,
                 const CentringOptions& options);

  /// Why no holes could be chosen for some setting, of whose runs there are none then; empty otherwise.
  [[nodiscard]] const std::string& problem() const { return problem_; }

  /// The run of that index under each setting. For any number of threads at once.
  [[nodiscard]] std::vector<Trial> run(std::uint64_t index) const;

  /// Its place in the sheet.
  [[nodiscard]] int tubeOfHole(std::size_t hole) const { return holes_[hole].tube; }

  /// Names of the holes that a setting touches in every run; empty where they differ.
  [[nodiscard]] std::vector<std::string> touchedHoles(std::size_t setting) const;

 private:
  struct Hole {
    calibration::TouchPlan plan;
    int tube;
  };
  struct Run;  ///< what settings share

  [[nodiscard]] std::vector<Hole> prepared(const std::vector<calibration::TouchPlan>& plans) const;
  [[nodiscard]] std::vector<Hole> fixedHoles(const planner::Workcell& model, const CentringHoles& holes,
                                             const CentringSetting& setting);
  [[nodiscard]] TrialHole trialHole(const Hole& hole, std::uint64_t run) const;
  [[nodiscard]] std::vector<const Hole*> drawnHoles(std::uint64_t key, int count, int well_spread) const;
  [[nodiscard]] Trial runSetting(const Run& run, std::size_t index) const;
  [[nodiscard]] std::vector<calibration::Measurement> touch(const Run& run, const std::vector<const Hole*>& holes,
                                                            const CentringSetting& setting) const;
  [[nodiscard]] std::vector<TrialVisit> visit(const Run& run, const std::vector<const Hole*>& holes,
                                              const BothCalibrations& base) const;

  CentringOptions options_;
  deflection::Arm flexible_, rigid_;
  Eigen::Isometry3d X_WB_;
  TruthMaker truths_;
  tubesheets::Sheet sheet_;
  std::vector<Hole> holes_;
  std::string problem_;
  std::vector<std::vector<Hole>> fixed_;  ///< touched, by setting; empty where drawn
};

}  // namespace tubeplan::app
