#include "app/studies/monte_carlo/step_experiment.hpp"

#include <algorithm>
#include <cmath>

#include "app/studies/measurements/simulated_calibration.hpp"
#include "app/studies/measurements/touched_holes.hpp"
#include "app/studies/monte_carlo/true_touches.hpp"

namespace tubeplan::app {

namespace {

using calibration::CalibrationStatus, calibration::TouchPlan;
using Eigen::Vector3d;

constexpr int kCandidates = 80;
constexpr int kTouchFits = 20;

std::vector<TrialHole> drawHoles(const planner::Workcell& cell, std::vector<TouchPlan> candidates, int count,
                                 double error_sigma, calibration::RandomStream& draw) {
  draw.shuffle(candidates);
  std::vector<TrialHole> holes;
  for (int k = 0; k < count; ++k) {
    const auto& plan = candidates[static_cast<std::size_t>(k)];
    holes.push_back({plan, tubeOf(plan, cell.sheet), draw.vector(error_sigma)});
  }
  return holes;
}

/// Mean error that a base fitted to many touches leaves at them.
double meanTouchError(const planner::Workcell& model, const TruthMaker& truths,
                      const std::vector<TouchPlan>& candidates, const StepExperimentOptions& options) {
  calibration::RandomStream draw(options.seed ^ 0x5bd1e995u);
  double sum = 0;
  int count = 0;
  for (int fit = 0; fit < kTouchFits; ++fit) {
    const auto drawn = truths.draw(draw);
    const auto holes = drawHoles(model, candidates, options.touch_fit_points, options.unmodelled_sigma, draw);
    const auto touches = touchHoles(drawn, holes, options.touch_fit_points, touchSigmaOf(model.tool), draw.seed());
    if (touches.empty()) continue;
    calibration::BaseCalibrationOptions usual;
    usual.neighbours = neighboursOn(model.sheet);
    const auto base = calibration::calibrateBase(model.arm, touches, model.X_WB, usual);
    if (base.status != CalibrationStatus::kDone) continue;
    for (const auto& residual : base.residuals) sum += residual.residual_W.norm(), ++count;
  }
  return count ? sum / count : std::numeric_limits<double>::quiet_NaN();
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

/// One calibration and its ten holes; the reason where the touches were refused.
std::string runOnce(const planner::Workcell& model, const TruthMaker& truths, const std::vector<TouchPlan>& candidates,
                    const StepExperimentOptions& options, std::uint64_t seed, StepExperiment& experiment) {
  calibration::RandomStream draw(seed);
  const planner::Workcell drawn = truths.draw(draw);
  std::vector<TrialHole> holes = drawHoles(model, candidates, options.test_holes, options.unmodelled_sigma, draw);
  for (int tries = 0; !areWellSpread(holes, options.calibration_holes); ++tries) {
    if (tries == kMostDraws) return "only nearly collinear holes were drawn: the sheet is too narrow";
    holes = drawHoles(model, candidates, options.test_holes, options.unmodelled_sigma, draw);
  }
  const auto touches = touchHoles(drawn, holes, options.calibration_holes, touchSigmaOf(model.tool), draw.seed());
  if (touches.empty()) return "the true arm cannot touch one of the calibration holes";
  const BothCalibrations base = calibrateBoth(model, touches);
  if (base.flexible.status != CalibrationStatus::kDone) return base.flexible.reason;
  if (base.rigid.status != CalibrationStatus::kDone) return "by the rigid model: " + base.rigid.reason;
  const ScoringModels models = scoringModels(model, base, drawn);
  std::vector<ModeScores> scores;
  for (const auto& hole : holes)
    scores.push_back(scoreModes(models, {hole.tube, hole.plan.q_start, hole.tip_error}, false));
  addRun(scores, static_cast<int>(model.tool.steps.size()), experiment);
  return {};
}

}  // namespace

StepExperiment runStepExperiment(const planner::Workcell& model, const planner::Workcell& truth,
                                 const StepExperimentOptions& options, const planner::PlanHooks& hooks) {
  StepExperiment experiment;
  const auto candidates = touchCandidates(model, kCandidates);
  if (static_cast<int>(candidates.size()) < std::max(options.test_holes, options.touch_fit_points)) {
    experiment.status = StepExperimentStatus::kTooFewHoles;
    experiment.reason = "only " + std::to_string(candidates.size()) + " holes spread over the sheet can be reached";
    return experiment;
  }
  const TruthMaker truths(truth, options);
  calibration::RandomStream seeds(options.seed);
  for (int run = 0; run < options.runs; ++run) {
    if (hooks.stop && hooks.stop()) break;
    if (hooks.progress)
      hooks.progress("runs", static_cast<std::size_t>(run) + 1, static_cast<std::size_t>(options.runs));
    const std::string reason = runOnce(model, truths, candidates, options, seeds.seed(), experiment);
    if (!reason.empty()) experiment.refused.push_back(reason);
  }
  for (std::size_t mode = 0; mode < kCompensations.size(); ++mode) {
    for (double& count : experiment.mean_counts[mode]) count /= std::max(1, experiment.runs);
    experiment.mean_error[mode] /= std::max(1, experiment.scored[mode]);
  }
  experiment.mean_touch_error = meanTouchError(model, truths, candidates, options);
  const bool complete = experiment.runs + static_cast<int>(experiment.refused.size()) == options.runs;
  experiment.status = complete ? StepExperimentStatus::kDone : StepExperimentStatus::kStopped;
  if (!complete) experiment.reason = "stopped after " + std::to_string(experiment.runs) + " runs, which are kept";
  return experiment;
}

}  // namespace tubeplan::app
