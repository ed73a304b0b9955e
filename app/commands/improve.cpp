// tubeplan improve: diagnose, add, identify, until nothing more is shown.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/atomic_file.hpp"
#include "app/command.hpp"
#include "app/command_inputs.hpp"
#include "app/commands/option_groups.hpp"
#include "app/diagnosis_json.hpp"
#include "app/improvement_job.hpp"
#include "app/measurement_checks_json.hpp"
#include "app/planning_hooks.hpp"
#include "app/readers/cell_writer.hpp"

namespace tubeplan::app {

namespace {

struct ImproveOptions {
  std::string cell, measurements, out, json;
  MeasurementOptions given;
  ImprovementRequest request;
};

/// Nothing is added to a model while a mistake with the readings explains its error.
int refuse(const CellReadings& input, const calibration::MeasurementCheck& mistake, const ImproveOptions& options) {
  const Units& units = input.cell.units;
  nlohmann::json json = {{"units", unitsJson(units)},
                         {"rungs", nlohmann::json::array()},
                         {"steps",
                          {{{"verdict", nameOf(calibration::Verdict::kInconclusive)},
                            {"sentence", checkText(mistake, units)},
                            {"added", nlohmann::json::array()}}}}};
  addChecks(input.checks, units, json);
  writeJson(options.json, json);
  if (printsText(options.json))
    fmt::print("{}not improved: {}\n", checksText(input.checks, units), checkText(mistake, units));
  return kNegativeAnswer;
}

int run(const ImproveOptions& options) {
  const CellReadings input = readCellReadings(options.cell, options.measurements, options.given);
  checkJsonTarget(options.json);
  checkWritableFile(options.out, "--out");
  if (const auto* mistake = calibration::grossMistake(input.checks)) return refuse(input, *mistake, options);
  const auto result = improveModel(input, options.request, terminalWorkHooks());
  for (const auto& file : improvedCell(input.cell, result.cell, result.last, input.readings, options.out).inOrder())
    writeFileAtomically(file.path, file.text, "--out");
  nlohmann::json json = improvementJson(result);
  addChecks(input.checks, input.cell.units, json);
  writeJson(options.json, json);
  if (!printsText(options.json)) return kDone;
  fmt::print("{}", checksText(input.checks, input.cell.units));
  for (std::size_t k = 0; k < result.steps.size(); ++k)
    fmt::print("step {}: {}: {}\n", k + 1, nameOf(result.steps[k].verdict), result.steps[k].sentence);
  fmt::print("{}wrote {}\n", ladderText(result.rungs, result.cell.units), options.out);
  return kDone;
}

}  // namespace

Run configureImprove(CLI::App& cli) {
  const auto options = std::make_shared<ImproveOptions>();
  cli.add_option("CELL", options->cell, "the cell file")->required();
  cli.add_option("MEASUREMENTS", options->measurements, "readings of any kind (CSV)")->required();
  cli.add_option("--out", options->out, "write the improved cell to this file, its arm beside it")->required();
  cli.add_option("--steps", options->request.steps, "the most rounds of diagnosing and adding")
      ->check(CLI::Range(1, 20));
  addMeasurementOptions(cli, options->given);
  cli.add_option("--seed", options->request.seed, "seed of the simulated noise and the folds");
  cli.add_option("--json", options->json, "write the figures as JSON to this file, or - for standard output");
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
