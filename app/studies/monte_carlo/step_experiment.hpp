// The thesis's experiment, many times over, as a campaign that touches three of the ten holes it visits: the steps of
// the tool that go in, run by run (Calkins 1994, section 5.5, table 5.7).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "app/studies/monte_carlo/centring_trial.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

struct StepExperimentOptions {
  calibration::DoubtBeside doubt;  ///< as CentringOptions has it
  std::vector<int> tubes;          ///< of the model's sheet; each run touches and visits some of those in reach
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
  int misfits = 0;                   ///< of them, with touches that do not fit
  std::vector<std::string> refused;  ///< why, for each run that could not be calibrated
  /// Mean number of the test holes that took 0, 1, ... steps, by mode; and the same by run.
  std::array<std::vector<double>, kCompensations.size()> mean_counts;
  std::array<std::vector<std::vector<int>>, kCompensations.size()> counts_by_run;
  std::array<int, kCompensations.size()> scored{};         ///< holes with a posture in that mode, over all runs
  std::array<double, kCompensations.size()> mean_error{};  ///< m, centring
  double mean_touch_error =
      std::numeric_limits<double>::quiet_NaN();  ///< m, left at touch_fit_points touches by the base fit
};

[[nodiscard]] StepExperiment runStepExperiment(const planner::Workcell& model, const planner::Workcell& truth,
                                               const StepExperimentOptions& options, const planner::PlanHooks& hooks);

}  // namespace tubeplan::app
