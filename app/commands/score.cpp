// tubeplan score: centring and steps inserted by the true arm, without compensation, with goal-point and with via-point
// compensation.
#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.hpp"
#include "app/cli/json_target.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/calibration_json.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/pose_json.hpp"
#include "app/documents/segments_warning.hpp"
#include "app/files/command_inputs.hpp"
#include "app/files/input_error.hpp"
#include "app/files/touch_input.hpp"
#include "app/files/touched_base.hpp"
#include "app/files/units.hpp"
#include "app/files/units_json.hpp"
#include "app/files/workcell.hpp"
#include "app/studies/measurements/simulated_calibration.hpp"
#include "app/studies/measurements/touched_holes.hpp"
#include "app/studies/monte_carlo/step_experiment.hpp"
#include "planner/reach/tube_reach.hpp"

namespace tubeplan::app {

namespace {

struct ScoreOptions {
  std::string cell, truth, tubes, json;
  std::vector<std::string> columns;
  int runs = 0;
  double unmodelled = -1, stiffness = -1;
  std::uint64_t seed = 1;
};

/// Spread over the sheet, where none are named.
constexpr std::size_t kTubes = 60, kTubesOfRuns = 80;

struct ScoredTube {
  int tube;
  std::string reason;  ///< why it could not be scored
  ModeScores scores;
  Eigen::VectorXd q = {};  ///< of the model with its base as calibrated; empty where it could not be scored
};

struct Scored {
  BothCalibrations calibration;
  std::vector<ScoredTube> tubes;
  std::vector<std::string> warnings;  ///< of too few segments, and of the base
};

Scored scoreAll(const planner::Workcell& nominal, const planner::Workcell& truth, const std::vector<int>& tubes,
                std::uint64_t seed, const Cell& cell) {
  Scored result;
  result.calibration = calibrateBoth(nominal, cell, touchesByTrueArm(nominal, cell, truth, seed));
  if (result.calibration.flexible.status != calibration::CalibrationStatus::kDone) return result;
  const ScoringModels models = scoringModels(nominal, result.calibration, truth);
  const planner::ArmClearance clearance(models.flexible);
  result.tubes.resize(tubes.size());
  oneapi::tbb::parallel_for(std::size_t{0}, tubes.size(), [&](std::size_t k) {
    const auto reach = planner::reachTube(clearance, tubes[k]);
    result.tubes[k] = {tubes[k], reach.reason, {}};
    if (reach.status != planner::ReachStatus::kReachable) return;
    result.tubes[k].q = reach.branches.front().q;
    result.tubes[k].scores = scoreModes(models, {tubes[k], result.tubes[k].q});
  });
  std::vector<Eigen::VectorXd> postures;
  for (const auto& tube : result.tubes)
    if (tube.reason.empty()) postures.push_back(tube.q);
  for (auto& warning :
       {segmentsWarning(cell, models.flexible, postures), warningOf(standingOf(cell, &result.calibration.flexible))})
    if (!warning.empty()) result.warnings.push_back(warning);
  return result;
}

nlohmann::json scoresJson(const ModeScores& scores, const Units& units) {
  nlohmann::json json;
  for (std::size_t mode = 0; mode < scores.size(); ++mode) {
    const auto& score = scores[mode];
    json[kModeKeys[mode]] = score ? nlohmann::json{{"centring_error", lengthOf(score->error, units)},
                                                   {"dx", lengthOf(score->offset.x(), units)},
                                                   {"dy", lengthOf(score->offset.y(), units)},
                                                   {"approach_deviation", lengthOf(score->approach_deviation, units)},
                                                   {"steps", score->steps}}
                                  : nlohmann::json();
  }
  return json;
}

std::vector<ModeScores> modeScores(const Scored& scored) {
  std::vector<ModeScores> scores;
  for (const auto& tube : scored.tubes)
    if (tube.reason.empty()) scores.push_back(tube.scores);
  return scores;
}

nlohmann::json scoredJson(const Scored& scored, const planner::Workcell& cell, const Cell& nominal) {
  const Units& units = nominal.units;
  nlohmann::json tubes = nlohmann::json::array();
  for (const auto& scored_tube : scored.tubes) {
    const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(scored_tube.tube)];
    nlohmann::json entry = {{"row", tube.row}, {"column", tube.column}};
    if (scored_tube.reason.empty())
      entry.update(scoresJson(scored_tube.scores, units));
    else
      entry["unreachable"] = scored_tube.reason;
    if (scored_tube.q.size() > 0) entry["joints"] = jointValuesJson(scored_tube.q, nominal);
    tubes.push_back(entry);
  }
  const auto counts = countByMode(modeScores(scored), static_cast<int>(cell.tool.steps.size()));
  const auto& base = scored.calibration.flexible;
  return {{"units", unitsJson(units)},
          {"base", placedBaseJson(base.X_WB, standingOf(nominal, &base), units)},
          {"calibration", calibrationJson(base, nominal)},
          {"tubes", tubes},
          {"warnings", scored.warnings},
          {"counts", {{kModeKeys[0], counts[0]}, {kModeKeys[1], counts[1]}, {kModeKeys[2], counts[2]}}}};
}

void printScored(const Scored& scored, const planner::Workcell& cell, const Cell& nominal) {
  const Units& units = nominal.units;
  fmt::print("scored with the base that {} simulated touches of the true arm give\n",
             scored.calibration.flexible.residuals.size());
  fmt::print("{}", calibrationText(scored.calibration.flexible, nominal));
  for (const auto& warning : scored.warnings) fmt::print("warning: {}\n", warning);
  const auto scores = modeScores(scored);
  fmt::print("{} tubes scored {}, {} unreachable\n", scores.size(),
             wordsOf(standingOf(nominal, &scored.calibration.flexible)), scored.tubes.size() - scores.size());
  const auto counts = countByMode(scores, static_cast<int>(cell.tool.steps.size()));
  fmt::print("{:<14}", "compensation");
  for (std::size_t steps = 0; steps <= cell.tool.steps.size(); ++steps)
    fmt::print("{:>7}", steps == 0 ? "steps 0" : std::to_string(steps));
  fmt::print("   mean error  worst, {0}   worst on approach, {0}\n", units.length().name);
  for (std::size_t mode = 0; mode < kCompensations.size(); ++mode) {
    double sum = 0, worst = 0, approach = 0;
    int found = 0;
    for (const auto& score : scores)
      if (score[mode]) {
        sum += score[mode]->error;
        ++found;
        worst = std::max(worst, score[mode]->error);
        approach = std::max(approach, score[mode]->approach_deviation);
      }
    fmt::print("{:<14}", planner::nameOf(kCompensations[mode]));
    for (int count : counts[mode]) fmt::print("{:7}", count);
    const double unit = units.factor(dimension::kLength);
    const int decimals = lengthDecimals(units.length());
    const auto none = static_cast<int>(scores.size()) - found;
    fmt::print("   {:8.{}f}  {:8.{}f}  {:8.{}f}{}\n", sum / unit / std::max(1, found), decimals, worst / unit, decimals,
               approach / unit, decimals, none > 0 ? fmt::format("   ({} without a posture)", none) : "");
  }
}

std::vector<std::string> warningsOf(const StepExperiment& experiment) {
  if (experiment.misfits == 0) return {};
  return {fmt::format(
      "in {} of {} runs the touches do not fit: `tubeplan calibrate` would say so; their steps are counted as well",
      experiment.misfits, experiment.runs)};
}

nlohmann::json experimentJson(const StepExperiment& experiment, const BaseStanding& standing, const Units& units) {
  nlohmann::json base = standingJson(standing);
  base["misfits"] = experiment.misfits;
  nlohmann::json json = {
      {"units", unitsJson(units)},          {"base", base},
      {"warnings", warningsOf(experiment)}, {"runs", experiment.runs},
      {"refused", experiment.refused},      {"mean_touch_error", lengthOf(experiment.mean_touch_error, units)}};
  for (std::size_t mode = 0; mode < kCompensations.size(); ++mode)
    json[kModeKeys[mode]] = {{"mean_counts", experiment.mean_counts[mode]},
                             {"counts_by_run", experiment.counts_by_run[mode]},
                             {"mean_centring_error", lengthOf(experiment.mean_error[mode], units)}};
  return json;
}

constexpr std::string_view kModeWords = "{@:<29}{mean_counts:*6.2f}   {mean_centring_error:l}\n";
constexpr TextLine kExperimentWords[] = {
    {"", "{runs} runs of three calibration holes and ten test holes ({#refused} refused"},
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

int runExperiment(const ScoreOptions& options, const std::vector<int>& tubes, const planner::Workcell& model,
                  const planner::Workcell& truth, const Cell& cell) {
  const Units& units = cell.units;
  StepExperimentOptions settings;
  settings.doubt = doubtBeside(cell);
  settings.tubes = tubes;
  settings.runs = options.runs;
  settings.seed = options.seed;
  if (options.unmodelled >= 0)
    settings.spread.unmodelled_sigma = units.toInternal(options.unmodelled, dimension::kLength);
  if (options.stiffness >= 0) settings.spread.stiffness_sigma = options.stiffness;
  const auto experiment = runStepExperiment(model, truth, settings, terminalHooks());
  if (experiment.runs == 0) {
    fmt::print(stderr, "no run was scored: {}\n", experiment.reason);
    return kNegativeAnswer;
  }
  const nlohmann::json figures = experimentJson(experiment, standingOfEachRun(settings.calibration_holes), units);
  writeJson(options.json, figures);
  if (printsText(options.json)) fmt::print("{}", textOf(figures, kExperimentWords));
  return experiment.status == StepExperimentStatus::kStopped ? kStoppedExitCode : kDone;
}

int run(const ScoreOptions& options) {
  Cell cell = readCell(options.cell);
  forgetTouches(cell);  // the true arm touches anew
  const Cell true_cell = readCell(options.truth);
  const auto model = workcellOf(cell, "score positioning"), truth = workcellOf(true_cell, "score against it");
  if (model.sheet.fingerprint() != truth.sheet.fingerprint())
    throw InputError(options.truth, "another tube sheet", "the cell's, fingerprint " + model.sheet.fingerprint());
  checkJsonTarget(options.json);
  const std::size_t spread = options.runs > 0 ? kTubesOfRuns : kTubes;
  requireWorkList(options.columns, {options.tubes});
  const auto selection = readTubes(tubesOrSpread(options.tubes, model.sheet, spread), model.sheet, options.columns);
  const auto& tubes = selection.tube_indices;
  for (const auto& note : listNotes(selection)) fmt::print(stderr, "note: {}\n", note);
  if (options.runs > 0) return runExperiment(options, tubes, model, truth, cell);
  const Scored scored = scoreAll(model, truth, tubes, options.seed, cell);
  if (scored.calibration.flexible.status != calibration::CalibrationStatus::kDone) {
    fmt::print(stderr, "{}", calibrationText(scored.calibration.flexible, cell));
    return kNegativeAnswer;
  }
  writeJson(options.json, scoredJson(scored, model, cell));
  if (printsText(options.json)) printScored(scored, model, cell);
  return kDone;
}

}  // namespace

Run configureScore(CLI::App& cli) {
  const auto options = std::make_shared<ScoreOptions>();
  addCell(cli, options->cell);
  cli.add_option("--truth", options->truth, "the cell of the true arm")->required();
  cli.add_option(
      "--tubes", options->tubes,
      fmt::format("which tubes, as for plan (spread:{}; with --runs, each of which draws from them, spread:{})", kTubes,
                  kTubesOfRuns));
  addListColumns(cli, options->columns);
  auto* runs = cli.add_option("--runs", options->runs,
                              "repeat the thesis's experiment N times, each with a true arm drawn about the given one")
                   ->check(CLI::Range(0, 1000000));
  cli.add_option("--unmodelled", options->unmodelled,
                 "with --runs: standard deviation of the true arm's unmodelled error, per coordinate")
      ->needs(runs)
      ->check(CLI::NonNegativeNumber);
  cli.add_option("--stiffness", options->stiffness,
                 "with --runs: relative standard deviation of the true arm's stiffnesses")
      ->needs(runs)
      ->check(CLI::NonNegativeNumber);
  addSeed(cli, options->seed, "seed of the random numbers");
  addJson(cli, options->json);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
