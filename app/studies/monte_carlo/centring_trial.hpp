// One run of a campaign: draws a true arm, lets it touch holes, calibrates its base from the touches, and sends it to
// other holes. All settings use the same true arm, so that results differ only because of the settings.
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

/// Rule for choosing the touched holes.
enum class TouchRule {
  kBest,    ///< holes that minimize the tip's uncertainty, the same in every run
  kSpread,  ///< holes farthest from one another, the same in every run
  kRandom,  ///< random holes far from collinear, different in every run
  kTested,  ///< as kRandom, but drawn from the holes visited later, as in Calkins 1994
};

struct TouchRuleRow {
  TouchRule rule;
  std::string_view name, summary;
};
[[nodiscard]] std::span<const TouchRuleRow> touchRules();

/// One setting of the base calibration.
struct CentringSetting {
  int touches = 3;
  TouchRule rule = TouchRule::kBest;
  /// Centring noise of each coordinate [m]; a value below 1e-6 is raised to that when touches are weighted.
  double touch_sigma = 1.27e-4;
};

/// Holes that may be visited, and holes that may be touched under the rule kBest.
struct CentringHoles {
  std::vector<calibration::TouchPlan> visited, touchable;
};

struct CentringOptions {
  TruthSpread spread;
  calibration::AdditionalUncertainty
      additional;  ///< uncertainties considered in choosing touches and calibrating bases
  int holes = 10;  ///< number of holes visited in a run; each run draws its own holes
  std::uint64_t seed = 1;
  std::vector<CentringSetting> settings;
};

enum class TrialFailure { kNone, kTooNarrow, kUntouchable, kMistakenHole, kNotConverged, kRigidRefused };
inline constexpr std::size_t kTrialFailures = 6;

/// Returns a phrase such as "the true arm cannot touch one of the holes".
[[nodiscard]] std::string_view nameOf(TrialFailure failure);

/// Methods of compensation.
inline constexpr std::array<std::string_view, 2> kWays{"none", "compensated"};
inline constexpr std::array<std::string_view, kWays.size()> kWayWords{"without compensation", "with compensation"};
struct TrialVisit {
  int hole = -1;  ///< index among the holes that may be visited
  std::array<std::optional<planner::Centring>, kWays.size()> centring;
};

/// Result of one run under one setting.
struct Trial {
  TrialFailure failure = TrialFailure::kNone;
  /// Mean residual of the touches [m]; NaN if the run failed.
  double touch_error = std::numeric_limits<double>::quiet_NaN();
  bool is_misfit = false;  ///< true if chi-square rejects the touches for the flexible arm
  std::vector<TrialVisit> visits;
};

/// A run of one setting after its calibration and before its visits.
struct CalibratedRun {
  TrialFailure failure = TrialFailure::kNone;
  planner::Workcell truth;  ///< true arm on its true base, without sheet and scene
  BothCalibrations base;
  std::vector<TrialHole> visited;  ///< holes to visit, with the unmodelled error of the true arm there
};

/// Simulated runs of a campaign; holds everything that does not depend on the run.
class CentringTrials {
 public:
  /// `holes` must have at least `options.holes` holes to visit, and as many holes to touch as any setting requires.
  CentringTrials(const planner::Workcell& model, const planner::Workcell& truth, const CentringHoles& holes,
                 const CentringOptions& options);

  /// Returns the reason if no holes could be chosen for some setting, which then has no runs; otherwise empty.
  [[nodiscard]] const std::string& problem() const { return problem_; }

  /// Returns the results of the run with this index, one for each setting. Thread-safe.
  [[nodiscard]] std::vector<Trial> run(std::uint64_t index) const;

  /// Returns the run with this index after its calibration under one setting. Thread-safe.
  [[nodiscard]] CalibratedRun calibrate(std::uint64_t index, std::size_t setting = 0) const;

  /// Returns the sheet's index of the tube that is visited as hole number `hole`.
  [[nodiscard]] int tubeOfHole(std::size_t hole) const { return holes_[hole].tube; }

  /// Returns the names of the holes that a setting touches in every run; empty if they differ between runs.
  [[nodiscard]] std::vector<std::string> touchedHoles(std::size_t setting) const;

 private:
  struct Hole {
    calibration::TouchPlan plan;
    int tube;
  };
  struct Run;  ///< data of a run that all settings share
  /// Base of a run, and the holes that it visits.
  struct Calibrated {
    TrialFailure failure = TrialFailure::kNone;
    BothCalibrations base;
    std::vector<const Hole*> visited;
  };

  [[nodiscard]] std::vector<Hole> prepared(const std::vector<calibration::TouchPlan>& plans) const;
  [[nodiscard]] std::vector<Hole> fixedHoles(const planner::Workcell& model, const CentringHoles& holes,
                                             const CentringSetting& setting);
  [[nodiscard]] TrialHole trialHole(const Hole& hole, std::uint64_t run) const;
  [[nodiscard]] std::vector<const Hole*> drawnHoles(std::uint64_t key, int count, int well_spread) const;
  [[nodiscard]] Run drawnRun(std::uint64_t index) const;
  [[nodiscard]] Calibrated calibrated(const Run& run, std::size_t index) const;
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
  /// Touched holes of each setting; empty for a setting that draws them in each run.
  std::vector<std::vector<Hole>> fixed_;
};

}  // namespace tubeplan::app
