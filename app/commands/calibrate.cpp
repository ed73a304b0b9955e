// `tubeplan calibrate`: determines the base pose from touched holes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/commands/measurement_answer.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/calibration_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/formats/cell/cell_places.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/jobs/calibration.hpp"
#include "app/storage/atomic_file.hpp"

namespace tubeplan::app {

namespace {

using calibration::CalibrationStatus;

struct CalibrateOptions {
  std::string cell, measurement_file, out, setup;
  FiguresTarget figures;
  std::vector<std::string> assume;
  double sigma = 0;
};

int run(const CalibrateOptions& options) {
  Cell cell = readCell(options.cell);
  cell.base_known = false;  // determine the base even if the cell states it as known
  const auto [measurements, checks] =
      readAndCheck({options.measurement_file}, cell, {options.sigma, {}, options.assume});
  const auto touches = touchesOf(measurements, cell, options.measurement_file, options.setup);
  checkFigures(options.figures);
  if (!options.out.empty()) checkWritableCell(cell, options.out, "--out");
  const CalibrationOutcome outcome = calibrateCell(cell, touches, options.measurement_file);
  const auto& result = outcome.calibration;
  const bool is_written = result.status == CalibrationStatus::kDone && !options.out.empty();
  if (is_written) writeFileAtomically(options.out, calibratedCellText(cell, outcome, options.out), "--out");
  nlohmann::json json = outcome.figures;
  addChecks(checks, cell.units, json);
  showFigures(options.figures, json, checksText(checks, cell.units) + calibrationText(result, cell));
  if (printsText(options.figures) && is_written)
    output("wrote {}{}\n", options.out, calibration::isFitRefused(result) ? ", with touches that do not fit" : "");
  return answerOver(checks, result.status == CalibrationStatus::kDone && !calibration::isFitRefused(result));
}

}  // namespace

Run configureCalibrate(CLI::App& cli) {
  const auto options = std::make_shared<CalibrateOptions>();
  addCell(cli, options->cell);
  cli.add_option("MEASUREMENTS", options->measurement_file, "touches (CSV): three or more holes, each once")
      ->required();
  cli.add_option("--out", options->out, "write the cell with the base found to this file");
  cli.add_option("--setup", options->setup, "set-up to use, if the file has several");
  addSigma(cli, options->sigma, "if neither file nor tool states one");
  addAssumeOption(cli, options->assume);
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
