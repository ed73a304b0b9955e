#include "app/studies/monte_carlo/step_experiment.hpp"

#include <algorithm>

#include "app/studies/measurements/touched_holes.hpp"

namespace tubeplan::app {

namespace {

constexpr std::uint64_t kTouchFits = 20;

CentringTrials trialsOf(const planner::Workcell& model, const planner::Workcell& truth, const CentringHoles& holes,
                        const StepExperimentOptions& options, const calibration::DoubtBeside& doubt, int touches,
                        TouchRule rule) {
  return {model,
          truth,
          holes,
          {options.spread, doubt, options.test_holes, options.seed, {{touches, rule, touchSigmaOf(model.tool)}}}};
}

/// Returns the scores by mode; at the hole goal-point and via-point compensation are the same.
std::vector<ModeScores> modeScoresOf(const std::vector<TrialVisit>& visits) {
  std::vector<ModeScores> scores;
  for (const auto& [hole, centring] : visits) scores.push_back({centring[0], centring[1], centring[1]});
  return scores;
}

void addRun(const std::vector<ModeScores>& scores, int steps, StepExperiment& experiment) {
  const auto counts = countByMode(scores, steps);
  for (std::size_t mode = 0; mode < counts.size(); ++mode) {
    experiment.counts_by_run[mode].push_back(counts[mode]);
    experiment.mean_counts[mode].resize(counts[mode].size(), 0);
    for (std::size_t k = 0; k < counts[mode].size(); ++k) experiment.mean_counts[mode][k] += counts[mode][k];
    for (const auto& score : scores) {
      if (!score[mode]) continue;
      experiment.mean_error[mode] += score[mode]->error;
      ++experiment.scored[mode];
    }
  }
  ++experiment.runs;
}

/// Returns the mean residual of a base alone, fitted to many touches.
double meanTouchError(const CentringTrials& trials) {
  double sum = 0;
  int count = 0;
  for (std::uint64_t run = 0; run < kTouchFits; ++run) {
    const Trial trial = trials.run(run).front();
    if (trial.failure == TrialFailure::kNone) sum += trial.touch_error, ++count;
  }
  return count ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

StepExperiment runStepExperiment(const planner::Workcell& model, const planner::Workcell& truth,
                                 const StepExperimentOptions& options, const planner::PlanHooks& hooks) {
  StepExperiment experiment;
  const CentringHoles holes{touchCandidates(model, options.tubes), {}};
  if (static_cast<int>(holes.visited.size()) < std::max(options.test_holes, options.touch_fit_points)) {
    experiment.status = StepExperimentStatus::kTooFewHoles;
    experiment.reason = std::to_string(holes.visited.size()) + " of the " + std::to_string(options.tubes.size()) +
                        " holes can be reached, and " +
                        std::to_string(std::max(options.test_holes, options.touch_fit_points)) + " are needed";
    return experiment;
  }
  const auto trials =
      trialsOf(model, truth, holes, options, options.doubt, options.calibration_holes, TouchRule::kTested);
  const auto steps = static_cast<int>(model.tool.steps.size());
  const auto runs = static_cast<std::size_t>(options.runs);
  for (std::size_t run = 0; run < runs; ++run) {
    if (hooks.stop && hooks.stop()) break;
    if (hooks.progress) hooks.progress("runs", run + 1, runs);
    const Trial trial = trials.run(run).front();
    if (trial.failure != TrialFailure::kNone) {
      experiment.refused.emplace_back(nameOf(trial.failure));
      continue;
    }
    addRun(modeScoresOf(trial.visits), steps, experiment);
    experiment.misfits += trial.is_misfit ? 1 : 0;
  }
  for (std::size_t mode = 0; mode < kCompensations.size(); ++mode) {
    for (double& count : experiment.mean_counts[mode]) count /= std::max(1, experiment.runs);
    experiment.mean_error[mode] /= std::max(1, experiment.scored[mode]);
  }
  experiment.mean_touch_error = meanTouchError(
      trialsOf(model, truth, holes, options, calibration::DoubtBeside{}, options.touch_fit_points, TouchRule::kRandom));
  const bool complete = experiment.runs + static_cast<int>(experiment.refused.size()) == options.runs;
  experiment.status = complete ? StepExperimentStatus::kDone : StepExperimentStatus::kStopped;
  if (!complete) experiment.reason = "stopped after " + std::to_string(experiment.runs) + " runs, which are kept";
  return experiment;
}

}  // namespace tubeplan::app
