// `tubeplan score`: computes the centring of a true arm and the number of tool steps that enter, without compensation,
// with goal-point and with via-point compensation.
#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/commands/score_runs.hpp"
#include "app/documents/calibration_json.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/pose_json.hpp"
#include "app/documents/segments_warning.hpp"
#include "app/formats/cell/command_inputs.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/formats/sheet/touched_base.hpp"
#include "app/formats/units.hpp"
#include "app/formats/units_json.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/measurements/simulated_calibration.hpp"
#include "app/studies/positioning/step_score.hpp"
#include "planner/reach/tube_reach.hpp"

namespace tubeplan::app {

namespace {

struct ScoreOptions : ScoredRunsOptions {
  std::string cell, truth, tubes;
  std::vector<std::string> columns;
};

/// Default numbers of tubes spread over the sheet, without and with --runs.
constexpr std::size_t kTubes = 60, kTubesOfRuns = 80;

struct ScoredTube {
  int tube;
  std::string reason;  ///< reason why the tube was not scored; empty for a scored tube
  ModeScores scores;
  Eigen::VectorXd q = {};  ///< posture of the model on its calibrated base; empty if the tube is unreachable
};

struct Scored {
  BothCalibrations calibration;
  std::vector<ScoredTube> tubes;
  std::vector<std::string> warnings;  ///< warnings of too few beam segments and of an unreliable base
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

/// Returns the results over all tubes for each compensation mode. Errors are null if a mode has no posture at any tube.
nlohmann::json compensationsJson(const std::vector<ModeScores>& scores, std::size_t steps, const Units& units) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto counts = countByMode(scores, static_cast<int>(steps));
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t mode = 0; mode < kCompensations.size(); ++mode) {
    double sum = 0, worst = kNone, approach = kNone;
    std::size_t found = 0;
    for (const auto& score : scores) {
      if (!score[mode]) continue;
      ++found;
      sum += score[mode]->error;
      worst = std::fmax(worst, score[mode]->error);
      approach = std::fmax(approach, score[mode]->approach_deviation);
    }
    list.push_back({{"name", planner::nameOf(kCompensations[mode])},
                    {"counts", counts[mode]},
                    {"mean_centring_error", lengthJson(sum / static_cast<double>(found), units)},
                    {"worst_centring_error", lengthJson(worst, units)},
                    {"worst_approach_deviation", lengthJson(approach, units)},
                    {"no_posture", scores.size() - found}});
  }
  return list;
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
  const auto scores = modeScores(scored);
  const auto counts = countByMode(scores, static_cast<int>(cell.tool.steps.size()));
  const auto& base = scored.calibration.flexible;
  return {{"units", unitsJson(units)},
          {"base", placedBaseJson(base.X_WB, standingOf(nominal, &base), units)},
          {"calibration", calibrationJson(base, nominal)},
          {"tubes", tubes},
          {"scored", scores.size()},
          {"unreachable", scored.tubes.size() - scores.size()},
          {"by_compensation", compensationsJson(scores, cell.tool.steps.size(), units)},
          {"warnings", scored.warnings},
          {"counts", {{kModeKeys[0], counts[0]}, {kModeKeys[1], counts[1]}, {kModeKeys[2], counts[2]}}}};
}

constexpr TextLine kWithoutPosture[] = {{"no_posture", "   ({} without a posture)"}, {"", "\n"}};
constexpr TextLine kScoredWords[] = {
    {"warnings", "warning: {}\n"},
    {"", "{scored} tube(|s) scored {base/words}, {unreachable} unreachable\n"},
    {"",
     "tubes by number of inserted steps, from none; mean and worst centring error, worst deviation on approach, "
     "{units/length}\n"},
    {"by_compensation",
     "{name:<14}{counts:*7}   {mean_centring_error:>8l}  {worst_centring_error:>8l}  {worst_approach_deviation:>8l}",
     kWithoutPosture}};

std::string scoredText(const nlohmann::json& figures, const Scored& scored, const Cell& nominal) {
  return textOf(figures, "scored with the base from {#calibration/residuals} simulated touches of the true arm\n") +
         calibrationText(scored.calibration.flexible, nominal) + textOf(figures, kScoredWords);
}

int run(const ScoreOptions& options) {
  Cell cell = readCell(options.cell);
  forgetTouches(cell);  // discard the stored touches, because the true arm makes new ones
  const Cell true_cell = readCell(options.truth);
  const auto model = workcellOf(cell, "score positioning"), truth = workcellOf(true_cell, "score against it");
  if (model.sheet.fingerprint() != truth.sheet.fingerprint())
    throw InputError::problem(
        options.truth,
        fmt::format("this tube sheet (fingerprint {}) differs from that of the cell (fingerprint {})",
                    truth.sheet.fingerprint(), model.sheet.fingerprint()),
        "give a --truth cell with the same tube sheet");
  checkFigures(options.figures);
  const std::size_t spread = options.runs > 0 ? kTubesOfRuns : kTubes;
  requireWorkList(options.columns, {options.tubes});
  const auto selection = readTubes(tubesOrSpread(options.tubes, model.sheet, spread), model.sheet, options.columns);
  const auto& tubes = selection.tube_indices;
  for (const auto& note : listNotes(selection)) remark("note: {}\n", note);
  if (options.runs > 0) return scoreRuns(options, tubes, model, truth, cell);
  const Scored scored = scoreAll(model, truth, tubes, options.seed, cell);
  if (scored.calibration.flexible.status != calibration::CalibrationStatus::kDone) {
    remark("{}", calibrationText(scored.calibration.flexible, cell));
    return kNegativeAnswer;
  }
  const nlohmann::json figures = scoredJson(scored, model, cell);
  showFigures(options.figures, figures, scoredText(figures, scored, cell));
  return kDone;
}

}  // namespace

Run configureScore(CLI::App& cli) {
  const auto options = std::make_shared<ScoreOptions>();
  addCell(cli, options->cell);
  cli.add_option("--truth", options->truth, "the cell of the true arm")->required();
  cli.add_option(
      "--tubes", options->tubes,
      fmt::format("tubes, as for plan (spread:{}; with --runs, from which each run draws its holes, spread:{})", kTubes,
                  kTubesOfRuns));
  addListColumns(cli, options->columns);
  auto* runs = cli.add_option("--runs", options->runs,
                              "repeat the thesis's experiment N times, each with a true arm drawn about the given one")
                   ->check(within(0, 1000000));
  cli.add_option("--unmodelled", options->unmodelled,
                 "with --runs: standard deviation of the true arm's unmodelled error, per coordinate")
      ->type_name("LENGTH")
      ->needs(runs)
      ->check(notNegative());
  cli.add_option("--stiffness", options->stiffness,
                 "with --runs: relative standard deviation of the true arm's stiffnesses")
      ->needs(runs)
      ->check(notNegative());
  addSeed(cli, options->seed, "seed of the random numbers");
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
