// `tubeplan bases`: chooses the base positions from which most tubes are reached, and the fewest positions that reach
// all.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/formats/cell/command_inputs.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/formats/units_json.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/named_entry.hpp"
#include "app/studies/positioning/base_choice.hpp"
#include "deflection/rotation.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

constexpr std::size_t kMostCandidates = 2000;
constexpr const char* kAxisForm = "x, y, z or turn, with FROM:TO:COUNT, such as x=-20:20:5";

struct BasesOptions {
  std::string cell, tubes;
  std::vector<std::string> along, moving, columns, mirrored;
  int most = 2;
  FiguresTarget figures;
};

/// Reads "x=-20:20:5": an axis with its first and last value in the cell's units, and the number of values.
BaseAxis parseAxis(const std::string& text, const Units& units) {
  const std::vector<std::string> names{"x", "y", "z", "turn"};
  const std::size_t equals = text.find('='), first = text.find(':', equals), second = text.find(':', first + 1);
  if (equals == std::string::npos || first == std::string::npos || second == std::string::npos)
    throw InputError("--along", inQuotes(text), kAxisForm);
  const auto axis = std::ranges::find(names, text.substr(0, equals));
  const auto from = tubesheets::parseNumber(text.substr(equals + 1, first - equals - 1));
  const auto to = tubesheets::parseNumber(text.substr(first + 1, second - first - 1));
  const auto count = tubesheets::parseInteger(text.substr(second + 1));
  if (axis == names.end() || !from || !to || !count || *count < 1)
    throw InputError("--along", inQuotes(text), kAxisForm);
  const auto dimension = *axis == "turn" ? dimension::kAngle : dimension::kLength;
  return {static_cast<int>(axis - names.begin()), units.toInternal(*from, dimension), units.toInternal(*to, dimension),
          *count};
}

BaseChoiceOptions choiceOptions(const BasesOptions& options, const Cell& cell, const planner::Workcell& work) {
  BaseChoiceOptions choice;
  std::size_t candidates = 1;
  for (const std::string& axis : options.mirrored) {
    choice.mirrored.push_back(axis == "x" ? 0 : 1);
    candidates *= 2;
  }
  for (const std::string& text : options.along) {
    choice.axes.push_back(parseAxis(text, cell.units));
    candidates *= static_cast<std::size_t>(choice.axes.back().count);
    if (candidates > kMostCandidates)
      throw InputError("--along", fmt::format("{} positions or more", candidates),
                       fmt::format("at most {}", kMostCandidates), "give fewer values");
  }
  choice.moving = options.moving;
  choice.cover.most = options.most;
  for (const std::string& name : options.moving) (void)entryNamed(work.scene.obstacles, name, "--moving");
  return choice;
}

nlohmann::json baseJson(const BaseChoice& choice, std::size_t c, const Units& units) {
  const Eigen::Isometry3d& X_WB = choice.bases[c];
  return {{"candidate", c + 1},
          {"position", placeJson(X_WB.translation(), units)},
          {"rpy", vectorJson(deflection::fixedAnglesOf(X_WB.linear()), units, dimension::kAngle)},
          {"reached", std::ranges::count(choice.reaches[c], true)}};
}

nlohmann::json chosenJson(const BaseChoice& choice, const std::vector<int>& chosen, const Units& units) {
  nlohmann::json list = nlohmann::json::array();
  for (const int c : chosen) list.push_back(baseJson(choice, static_cast<std::size_t>(c), units));
  return list;
}

nlohmann::json basesJson(const BaseChoice& choice, std::size_t tubes, const Units& units) {
  const planner::BaseCover& cover = choice.cover;
  nlohmann::json candidates = nlohmann::json::array();
  for (std::size_t c = 0; c < choice.bases.size(); ++c) candidates.push_back(baseJson(choice, c, units));
  return {{"tubes", tubes},
          {"candidates", candidates},
          {"best", chosenJson(choice, cover.best, units)},
          {"reached", cover.reached},
          {"reached_at_most", cover.at_most},
          {"fewest", chosenJson(choice, cover.all, units)},
          {"fewest_at_least", cover.at_least},
          {"reachable", cover.reachable},
          {"proved", cover.status == planner::BaseCoverStatus::kProved},
          {"units", unitsJson(units)}};
}

constexpr TextLine kBasesWords[] = {
    {"", "{#candidates} base position(|s), {tubes} tube(|s), {reachable} of them in reach of one or another\n"},
    {"", "the cell's own base reaches {candidates/0/reached}\n"},
    {"best", "  {position} {units/length}, rpy {rpy} {units/angle}: reaches {reached}\n"},
    {"reached", "together these reach {}, and no choice of as many reaches more than {reached_at_most}\n"},
    {"fewest_at_least",
     "{#fewest} (position reaches|positions reach) all {reachable}; fewer than {fewest_at_least} do not\n"},
};

int run(const BasesOptions& options) {
  const Cell cell = readCell(options.cell);
  const planner::Workcell work = workcellOf(cell, "choose base positions");
  checkFigures(options.figures);
  const auto tubes = readTubes(tubesOrSpread(options.tubes, work.sheet, 100), work.sheet, options.columns);
  const BaseChoice choice =
      chooseBases(work, tubes.tube_indices, choiceOptions(options, cell, work), terminalWorkHooks());
  if (choice.is_stopped) {
    remark("stopped before all base positions were tried\n");
    return kStoppedExitCode;
  }
  const nlohmann::json figures = basesJson(choice, tubes.tube_indices.size(), cell.units);
  showFigures(options.figures, figures, textOf(figures, kBasesWords));
  return choice.cover.reachable > 0 ? kDone : kNegativeAnswer;
}

}  // namespace

Run configureBases(CLI::App& cli) {
  const auto options = std::make_shared<BasesOptions>();
  addCell(cli, options->cell);
  cli.add_option("--tubes", options->tubes, "tubes to reach, as for plan (spread:100)");
  addListColumns(cli, options->columns);
  cli.add_option(
      "--along", options->along,
      "AXIS=FROM:TO:COUNT: values of x, y or z of the base, or of its turn about the vertical, in the cell's "
      "units; repeat for further axes");
  cli.add_option("--mirrored", options->mirrored,
                 "x or y: also try the mirror image of each position in the plane x = 0 or y = 0; x,y: both")
      ->delimiter(',')
      ->check(oneOf({"x", "y"}));
  cli.add_option("--moving", options->moving,
                 "obstacle that moves with the base and is not checked for collisions; may be repeated");
  cli.add_option("--most", options->most, "largest number of positions to choose")
      ->check(within(1, 10))
      ->capture_default_str();
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
