#include "app/commands/score_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/pose_json.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/formats/sheet/touched_base.hpp"
#include "app/formats/units_json.hpp"
#include "app/studies/measurements/touched_holes.hpp"
#include "app/studies/monte_carlo/centring_trial.hpp"

namespace tubeplan::app {

namespace {

/// Numbers of holes in the experiment of Calkins 1994 (section 5.5, table 5.7). The touched holes are the first of the
/// visited holes.
constexpr int kTouchedHoles = 3, kVisitedHoles = 10;
/// Number of touched holes, and number of repetitions, from which meanTouchError() is computed.
constexpr int kFittedHoles = 14;
constexpr std::uint64_t kBaseFits = 20;

struct ScoredRuns {
  std::vector<std::vector<ModeScores>> scores;  ///< scores of the completed runs, indexed [run][hole]
  std::vector<std::string> refused;             ///< reason for each run that could not be calibrated
  std::uint64_t misfits = 0;                    ///< number of scored runs whose touches do not fit
  bool is_stopped = false;
};

ScoredRuns scoredBy(const CentringTrials& trials, int runs, const planner::PlanHooks& hooks) {
  ScoredRuns scored;
  for (int run = 0; run < runs; ++run) {
    scored.is_stopped = hooks.stop && hooks.stop();
    if (scored.is_stopped) break;
    if (hooks.progress) hooks.progress("runs", static_cast<std::size_t>(run) + 1, static_cast<std::size_t>(runs));
    const Trial trial = trials.run(static_cast<std::uint64_t>(run)).front();
    if (trial.failure != TrialFailure::kNone) {
      scored.refused.emplace_back(nameOf(trial.failure));
      continue;
    }
    // Goal-point and via-point compensation have the same posture at the hole itself.
    auto& scores = scored.scores.emplace_back();
    for (const auto& [hole, centring] : trial.visits) scores.push_back({centring[0], centring[1], centring[1]});
    scored.misfits += trial.is_misfit ? 1 : 0;
  }
  return scored;
}

/// Returns the mean residual of many touches after a fit of only the base [m].
double meanTouchError(const CentringTrials& trials) {
  double sum = 0;
  int count = 0;
  for (std::uint64_t run = 0; run < kBaseFits; ++run) {
    const Trial trial = trials.run(run).front();
    if (trial.failure == TrialFailure::kNone) sum += trial.touch_error, ++count;
  }
  return count ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

nlohmann::json modeJson(const ScoredRuns& scored, std::size_t mode, int steps, const Units& units) {
  std::vector<std::vector<int>> counts_by_run;
  std::vector<double> mean_counts(static_cast<std::size_t>(steps) + 1);
  double error = 0;
  int found = 0;
  for (const auto& scores : scored.scores) {
    counts_by_run.push_back(countByMode(scores, steps)[mode]);
    for (std::size_t k = 0; k < mean_counts.size(); ++k) mean_counts[k] += counts_by_run.back()[k];
    for (const auto& score : scores)
      if (score[mode]) error += score[mode]->error, ++found;
  }
  for (double& count : mean_counts) count /= static_cast<double>(scored.scores.size());
  return {{"mean_counts", mean_counts},
          {"counts_by_run", counts_by_run},
          {"mean_centring_error", lengthOf(error / std::max(1, found), units)}};
}

nlohmann::json runsJson(const ScoredRuns& scored, double touch_error, int steps, const Units& units) {
  const auto base = eachRunJson(kTouchedHoles, scored.misfits);
  const auto warnings = misfitWarnings(scored.misfits, scored.scores.size());
  nlohmann::json json = {{"units", unitsJson(units)}, {"base", base},
                         {"warnings", warnings},      {"runs", scored.scores.size()},
                         {"refused", scored.refused}, {"mean_touch_error", lengthOf(touch_error, units)}};
  for (std::size_t mode = 0; mode < kCompensations.size(); ++mode)
    json[kModeKeys[mode]] = modeJson(scored, mode, steps, units);
  return json;
}

constexpr std::string_view kModeWords = "{@:<29}{mean_counts:*6.2f}   {mean_centring_error:l}\n";
constexpr TextLine kExperimentWords[] = {
    {"", "{runs} run(|s) of three calibration holes and ten test holes ({#refused} refused"},
    {"refused", ", first: {}", {}, {}, 1},
    {"", "), {base/words}\n"},
    {"warnings", "warning: {}\n"},
    {"mean_touch_error", "mean residual of a fit to 14 touched holes: {:l units/length}\n"},
    {"", "of ten holes, by number of inserted steps, from none; then the mean error, {units/length}\n"},
    {"none", kModeWords, {}, "none"},
    {"goal_point", kModeWords, {}, "goal-point"},
    {"via_point", kModeWords, {}, "via-point"},
    {"",
     "goal-point and via-point compensation share the posture at the hole: they differ during the approach, not in "
     "these counts\n"}};

}  // namespace

int scoreRuns(const ScoredRunsOptions& options, const std::vector<int>& tubes, const planner::Workcell& model,
              const planner::Workcell& truth, const Cell& cell) {
  const CentringHoles holes{touchCandidates(model, tubes), {}};
  if (std::ssize(holes.visited) < std::max(kVisitedHoles, kFittedHoles)) {
    remark("no run was scored: {} of the {} holes can be reached, and {} are needed\n", holes.visited.size(),
           tubes.size(), std::max(kVisitedHoles, kFittedHoles));
    return kNegativeAnswer;
  }
  TruthSpread spread;
  if (options.unmodelled >= 0) spread.unmodelled_sigma = cell.units.toInternal(options.unmodelled, dimension::kLength);
  if (options.stiffness >= 0) spread.stiffness_sigma = options.stiffness;
  const auto trialsOf = [&](const calibration::AdditionalUncertainty& additional, int touches, TouchRule rule) {
    const CentringSetting setting{touches, rule, touchSigmaOf(model.tool)};
    return CentringTrials(model, truth, holes, {spread, additional, kVisitedHoles, options.seed, {setting}});
  };
  const auto scored =
      scoredBy(trialsOf(additionalUncertainty(cell), kTouchedHoles, TouchRule::kTested), options.runs, terminalHooks());
  if (scored.scores.empty()) {
    remark("no run was scored: {}\n", scored.refused.empty() ? "stopped before the first" : scored.refused.front());
    return kNegativeAnswer;
  }
  const double touch_error = meanTouchError(trialsOf({}, kFittedHoles, TouchRule::kRandom));
  const auto figures = runsJson(scored, touch_error, static_cast<int>(model.tool.steps.size()), cell.units);
  showFigures(options.figures, figures, textOf(figures, kExperimentWords));
  return scored.is_stopped ? kStoppedExitCode : kDone;
}

}  // namespace tubeplan::app
