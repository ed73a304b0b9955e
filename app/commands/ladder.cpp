// tubeplan ladder: the error of each model in turn, fitted and held-out, against the noise floor.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/atomic_file.hpp"
#include "app/command.hpp"
#include "app/command_inputs.hpp"
#include "app/input_error.hpp"
#include "app/ladder_steps.hpp"
#include "app/readers/measurements_reader.hpp"
#include "app/reading_input.hpp"
#include "app/report/diagnosis_report.hpp"
#include "app/version.hpp"

namespace tubeplan::app {

namespace {

struct LadderOptions {
  std::string measurements, json, report;
  std::vector<std::string> cells;
  double sigma = 0;
  LadderStepOptions steps;
  bool with_rigid = false;
};

/// What the page wants of the figures.
nlohmann::json ladderPage(const nlohmann::json& figures, const LadderOptions& options) {
  nlohmann::json page = {{"title", "Ladder of models"}, {"measurements", options.measurements},
                         {"seed", options.steps.seed},  {"version", kVersion},
                         {"units", figures["units"]},   {"models", nlohmann::json::array()}};
  for (const auto& rung : figures["rungs"]) {
    page["noise_floor"] = rung["rms"]["noise_floor"];
    page["models"].push_back({{"name", rung["name"]},
                              {"rms", rung["rms"]["fitted"]},
                              {"heldout_rms", rung["rms"]["heldout"]},
                              {"chi2_per_dof", rung["chi2_per_dof"]},
                              {"numbers", rung["fitted_numbers"]}});
    if (rung.contains("steps") && rung["steps"].is_object()) page["models"].back()["steps"] = rung["steps"]["counts"];
  }
  page["step_table"] = figures["step_table"];
  return page;
}

/// The first cell's arm taken as rigid: only its base is fitted.
Cell rigidOf(Cell cell) {
  cell.arm = deflection::rigidCopy(cell.arm);
  cell.identify.clear();
  return cell;
}

std::vector<Cell> cellsOf(const LadderOptions& options, std::vector<std::string>& names) {
  std::vector<Cell> cells;
  for (const auto& path : options.cells) {
    cells.push_back(readCell(path));
    names.push_back(path);
  }
  if (!options.with_rigid) return cells;
  cells.insert(cells.begin(), rigidOf(cells.front()));
  names.insert(names.begin(), names.front() + ", rigid");
  return cells;
}

int run(const LadderOptions& options) {
  std::vector<Rung> rungs;
  checkJsonTarget(options.json);
  if (!options.report.empty()) checkWritableFile(options.report, "--report");
  std::vector<std::string> names;
  const std::vector<Cell> cells = cellsOf(options, names);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Cell& cell = cells[k];
    auto readings = readMeasurements(options.measurements, cell.arm, cell.sheet ? &*cell.sheet : nullptr);
    stateSigma(readings, cell, options.measurements, options.sigma);
    requireDefinedFormulas(readings, cell, options.measurements);
    rungs.push_back(rungOf(names[k], cell, readings, options.steps.seed));
  }
  const Units& units = cells.front().units;
  const LadderSteps steps = addSteps(options.steps, cells, rungs);
  auto json = ladderJson(rungs, units);
  json["step_table"] = ladderStepsJson(steps, options.steps, units);
  writeJson(options.json, json);
  if (!options.report.empty())
    writeFileAtomically(options.report, renderLadderReport(ladderPage(json, options)), "--report");
  if (printsText(options.json)) fmt::print("{}{}", ladderText(rungs, units), ladderStepsText(steps, units));
  return kDone;
}

}  // namespace

Run configureLadder(CLI::App& cli) {
  const auto options = std::make_shared<LadderOptions>();
  cli.add_option("MEASUREMENTS", options->measurements, "readings of any kind (CSV)")->required();
  cli.add_option("CELL", options->cells, "models, one cell file each, in the order of the ladder")->required();
  cli.add_option("--sigma", options->sigma, "noise of a coordinate where the file states none");
  cli.add_option("--report", options->report, "write the ladder as a page to this file (HTML)");
  cli.add_flag("--rigid", options->with_rigid, "begin with the first model's arm taken as rigid");
  cli.add_option("--truth", options->steps.truth,
                 "the cell that stands for the real arm in the step table (else the best model of the ladder, with an "
                 "unmodelled error as large as the noise floor)");
  cli.add_option("--sheet", options->steps.sheet, "a cell whose tube sheet and calibration tool the step table is for");
  cli.add_option("--holes", options->steps.holes, "random holes of the step table")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  cli.add_option("--seed", options->steps.seed, "seed of the folds and the holes");
  cli.add_option("--json", options->json, "write the figures as JSON to this file, or - for standard output");
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
