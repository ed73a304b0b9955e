// `tubeplan touches`: proposes the next holes to touch, or postures and loads to measure.
#include "app/jobs/touches.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.hpp"
#include "app/commands/measurement_answer.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/fill_in_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/documents/touch_proposals.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/storage/atomic_file.hpp"

namespace tubeplan::app {

namespace {

struct TouchesOptions {
  TouchRequest request;
  std::string optimality = "D", csv;
  FiguresTarget figures;
};

calibration::Optimality optimalityOf(const std::string& name) {
  if (name == "G") return calibration::Optimality::kWorstTip;
  return name == "V" ? calibration::Optimality::kMeanTip : calibration::Optimality::kDeterminant;
}

bool isProposed(const std::optional<TouchProposal>& proposal) { return !proposal || proposal->reason.empty(); }

void writeSheet(const std::string& file, const TouchOutcome& outcome) {
  writeFileAtomically(file, runSheetCsv(runSheetOf(outcome), outcome.cell.arm, outcome.cell.units), "--csv");
}

/// Returns a message that names the written run sheet and says how to fill it in.
std::string sheetText(const TouchesOptions& options, const TouchOutcome& outcome) {
  return fmt::format("wrote {}: {}\n", options.csv,
                     fillInText(runSheetOf(outcome), outcome.cell.arm, outcome.cell.units));
}

int run(const TouchesOptions& options) {
  TouchRequest request = options.request;
  request.optimality = optimalityOf(options.optimality);
  checkFigures(options.figures);
  if (!options.csv.empty()) checkWritableFile(options.csv, "--csv");
  const TouchOutcome outcome = proposeTouches(request);
  const ExitCode answer = answerOver(outcome.checks, isProposed(outcome.base) && isProposed(outcome.parameters));
  const bool is_written = answer == kDone && !options.csv.empty();
  if (is_written) writeSheet(options.csv, outcome);
  nlohmann::json json = proposalsJson(outcome);
  json["seed"] = request.seed;
  json["optimality"] = options.optimality;
  addChecks(outcome.checks, outcome.cell.units, json);
  showFigures(options.figures, json,
              checksText(outcome.checks, outcome.cell.units) + proposalsText(outcome) +
                  (is_written ? sheetText(options, outcome) : ""));
  return answer;
}

}  // namespace

Run configureTouches(CLI::App& cli) {
  const auto options = std::make_shared<TouchesOptions>();
  auto& request = options->request;
  addCell(cli, request.cell);
  cli.add_option("--readings", request.measurements, "existing readings (CSV), which the proposals complement");
  addAssumeOption(cli, request.assume);
  cli.add_option(
         "--free", request.free,
         "parameters to determine instead of the cell's `identify`: dotted paths into the arm file, tool.tip, geometry")
      ->delimiter(',');
  cli.add_option("--goal", request.goal,
                 "base: holes for its calibration; parameters: readings for their identification; default: whatever "
                 "the cell allows")
      ->check(oneOf({"base", "parameters", "both"}));
  cli.add_option("--tubes", request.tubes, "tubes at which the tip position must be known, as for plan (spread:60)");
  addListColumns(cli, request.columns);
  cli.add_option("--count", request.count, "readings to propose for each goal (3 touches, 10 readings)")
      ->check(within(1, 500));
  cli.add_option("--loads", request.loads,
                 "loads that can be applied, in the cell's unit of force (those of the readings, else none)")
      ->type_name("FORCE")
      ->delimiter(',');
  cli.add_option("--kind", request.kind, "touch or position (touch under a sheet, else position)")
      ->check(oneOf({"touch", "position"}));
  cli.add_option("--optimal", options->optimality,
                 "optimality criterion for the parameters: D, determinant of the covariance; G, largest standard "
                 "deviation of the tip; V, its average")
      ->check(oneOf({"D", "G", "V"}))
      ->capture_default_str();
  cli.add_option("--candidates", request.candidates, "number of candidate holes or postures (60 holes, 600 postures)")
      ->check(within(3, 100000));
  addSigma(cli, request.sigma, "instead of that of the readings, or of the tool");
  cli.add_option(
      "--csv", options->csv,
      "write the proposals as a run sheet (CSV): a measurement table whose measured values are to be filled in");
  addSeed(cli, request.seed, "seed of the random postures and draws");
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
