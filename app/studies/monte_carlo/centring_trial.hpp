// One run of a campaign: a true arm is drawn, touches holes, is calibrated by its touches, and is then sent to other
// holes. The same true arm is used under every setting, so that results differ by the settings alone.
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

/// Choice of the touched holes.
enum class TouchRule {
  kBest,    ///< holes that place the base best, the same in every run
  kSpread,  ///< holes furthest from each other, the same in every run
  kRandom,  ///< others in every run, well off a line
  kTested,  ///< holes like those of kRandom, but out of the ones that are then visited, as in the thesis's experiment
};

struct TouchRuleRow {
  TouchRule rule;
  std::string_view name, summary;
};
[[nodiscard]] std::span<const TouchRuleRow> touchRules();

/// Setting of the base's calibration.
struct CentringSetting {
  int touches = 3;
  TouchRule rule = TouchRule::kBest;
  double touch_sigma = 1.27e-4;  ///< centring noise of each coordinate [m]; touches are weighed with 1e-6 m at least
};

/// Holes that may be visited, and holes that may be touched if the best are asked for.
struct CentringHoles {
  std::vector<calibration::TouchPlan> visited, touchable;
};

struct CentringOptions {
  TruthSpread spread;
  calibration::DoubtBeside doubt;  ///< doubt with which touches are chosen and bases calibrated
  int holes = 10;                  ///< number visited in a run, each time others
  std::uint64_t seed = 1;
  std::vector<CentringSetting> settings;
};

enum class TrialFailure { kNone, kTooNarrow, kUntouchable, kMistakenHole, kNotConverged, kRigidRefused };
inline constexpr std::size_t kTrialFailures = 6;

/// Returns a phrase, "the true arm cannot touch one of the holes".
[[nodiscard]] std::string_view nameOf(TrialFailure failure);

/// Ways of compensation; a visit's centring is empty if that way finds no posture.
inline constexpr std::array<std::string_view, 2> kWays{"none", "compensated"};
inline constexpr std::array<std::string_view, kWays.size()> kWayWords{"without compensation", "with compensation"};
struct TrialVisit {
  int hole = -1;  ///< index among those that may be visited
  std::array<std::optional<planner::Centring>, kWays.size()> centring;
};

/// Result of a run under one setting.
struct Trial {
  TrialFailure failure = TrialFailure::kNone;
  double touch_error = std::numeric_limits<double>::quiet_NaN();  ///< mean residual of the touches [m]
  bool is_misfit = false;  ///< true: chi-square rejects the touches of the flexible arm
  std::vector<TrialVisit> visits;
};

/// Runs of a campaign, with everything prepared that does not depend on the run.
class CentringTrials {
 public:
  /// There must be at least `options.holes` holes to visit, and as many to touch as any setting asks for.
  CentringTrials(const planner::Workcell& model, const planner::Workcell& truth, const CentringHoles& holes,
                 const CentringOptions& options);

  /// Returns why no holes could be chosen for some setting, which then has no runs; otherwise empty.
  [[nodiscard]] const std::string& problem() const { return problem_; }

  /// Returns the run of that index under each setting. Safe from any number of threads at once.
  [[nodiscard]] std::vector<Trial> run(std::uint64_t index) const;

  /// Returns the hole's index in the sheet.
  [[nodiscard]] int tubeOfHole(std::size_t hole) const { return holes_[hole].tube; }

  /// Returns the names of the holes that a setting touches in every run; empty if they differ.
  [[nodiscard]] std::vector<std::string> touchedHoles(std::size_t setting) const;

 private:
  struct Hole {
    calibration::TouchPlan plan;
    int tube;
  };
  struct Run;  ///< part that settings share

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
  std::vector<std::vector<Hole>> fixed_;  ///< touched holes by setting; empty if drawn
};

}  // namespace tubeplan::app
