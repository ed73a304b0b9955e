// The thesis's experiment, repeated, as a campaign that touches three of the ten holes it visits: the number of the
// tool's steps that enter, run by run (Calkins 1994, section 5.5, table 5.7).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "app/studies/monte_carlo/centring_trial.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

struct StepExperimentOptions {
  calibration::DoubtBeside doubt;  ///< doubt with the meaning of CentringOptions::doubt
  std::vector<int> tubes;          ///< tubes of the model's sheet; each run touches and visits some of those in reach
  TruthSpread spread;
  int runs = 100;
  std::uint64_t seed = 1;
  int calibration_holes = 3, test_holes = 10;
  int touch_fit_points = 14;
};

enum class StepExperimentStatus { kNotRun, kDone, kTooFewHoles, kStopped };

struct StepExperiment {
  StepExperimentStatus status = StepExperimentStatus::kNotRun;
  std::string reason;
  int runs = 0;
  int misfits = 0;                   ///< runs with touches that do not fit
  std::vector<std::string> refused;  ///< reasons, one for each run that could not be calibrated
  /// Mean numbers of the test holes that took 0, 1, ... steps, by mode; and the same numbers by run.
  std::array<std::vector<double>, kCompensations.size()> mean_counts;
  std::array<std::vector<std::vector<int>>, kCompensations.size()> counts_by_run;
  std::array<int, kCompensations.size()> scored{};         ///< holes with a posture in that mode, over all runs
  std::array<double, kCompensations.size()> mean_error{};  ///< centring error [m]
  /// Mean residual of the base fit at touch_fit_points touches [m].
  double mean_touch_error = std::numeric_limits<double>::quiet_NaN();
};

[[nodiscard]] StepExperiment runStepExperiment(const planner::Workcell& model, const planner::Workcell& truth,
                                               const StepExperimentOptions& options, const planner::PlanHooks& hooks);

}  // namespace tubeplan::app
