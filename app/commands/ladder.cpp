// `tubeplan ladder`: compares the fitted and held-out errors of several models with each other and with the noise
// floor.
#include "app/jobs/ladder.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/commands/measurement_answer.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/ladder_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/storage/atomic_file.hpp"

namespace tubeplan::app {

namespace {

struct LadderOptions {
  std::string measurement_file;
  FiguresTarget figures;
  ReportTarget report;
  std::vector<std::string> cells;
  MeasurementOptions given;
  LadderRequest request;
  bool with_rigid = false;
};

std::vector<LadderModel> modelsOf(const LadderOptions& options) {
  std::vector<LadderModel> models;
  for (const auto& path : options.cells)
    models.push_back({path, readCellMeasurements(path, {options.measurement_file}, options.given), nullptr});
  if (options.with_rigid)
    models.insert(models.begin(), {models.front().name + ", rigid",
                                   {rigidOf(models.front().input.cell), options.measurement_file,
                                    models.front().input.measurements, models.front().input.checks},
                                   nullptr});
  return models;
}

int run(const LadderOptions& options) {
  const auto models = modelsOf(options);
  checkFigures(options.figures);
  checkReportTarget(options.report);
  const auto outcome = runLadder(models, options.request, terminalWorkHooks());
  nlohmann::json figures = outcome.figures;
  addChecks(models.back().input.checks, models.front().input.cell.units, figures);
  if (options.report.isWanted())
    writeReport(options.report, ladderPage(outcome.figures, options.measurement_file, options.request.seed));
  showFigures(options.figures, figures,
              checksText(models.back().input.checks, models.front().input.cell.units) + ladderText(figures));
  return answerOver(models.back().input.checks, true);
}

}  // namespace

Run configureLadder(CLI::App& cli) {
  const auto options = std::make_shared<LadderOptions>();
  cli.add_option("MEASUREMENTS", options->measurement_file, "readings of any kind (CSV)")->required();
  cli.add_option("CELL", options->cells, "models, one cell file each, in the order of comparison")->required();
  addMeasurementOptions(cli, options->given);
  addReportOptions(cli, options->report, "write a report to this file (HTML)");
  cli.add_flag("--rigid", options->with_rigid, "begin with the first model as a rigid arm");
  cli.add_option("--truth", options->request.truth,
                 "the cell of the true arm for the step table (default: the best of the models, with an unmodelled "
                 "error as large as the noise floor)");
  cli.add_option("--sheet", options->request.sheet, "cell with the tube sheet and calibration tool for the step table");
  cli.add_option("--holes", options->request.holes, "number of random holes for the step table")
      ->check(within(1, 100000))
      ->capture_default_str();
  addSeed(cli, options->request.seed, "seed of the folds and the holes");
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
