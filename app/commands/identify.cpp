// tubeplan identify: the parameters of the model, and the base, from measurements.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/atomic_file.hpp"
#include "app/command.hpp"
#include "app/command_inputs.hpp"
#include "app/effect_warnings_json.hpp"
#include "app/identification_json.hpp"
#include "app/input_error.hpp"
#include "app/overlap_report.hpp"
#include "app/predicted_centring.hpp"
#include "app/readers/cell_writer.hpp"
#include "app/readers/measurements_reader.hpp"
#include "app/reading_input.hpp"
#include "app/suggestion.hpp"
#include "calibration/diagnosis/formula_overlap.hpp"

namespace tubeplan::app {

namespace {

using calibration::Identification, calibration::IdentificationOptions, calibration::IdentificationStatus;

struct IdentifyOptions {
  std::string cell, measurements, out, json, method = "ipopt", robust = "none";
  std::vector<std::string> free, stages;
  double sigma = 0, drop = 0;
  int starts = 1, folds = 5;
  std::uint64_t seed = 1;
};

calibration::RobustLoss lossOf(const std::string& name) {
  if (name == "huber") return calibration::RobustLoss::kHuber;
  return name == "cauchy" ? calibration::RobustLoss::kCauchy : calibration::RobustLoss::kNone;
}

IdentificationOptions identificationOptions(const IdentifyOptions& options, const Cell& cell) {
  IdentificationOptions result;
  result.free.names = options.free.empty() ? cell.identify : options.free;
  result.free.base = !cell.base_known;
  result.loss = lossOf(options.robust);
  result.starts = options.starts;
  result.folds = options.folds;
  result.seed = options.seed;
  result.drop_level = options.drop;
  for (const auto& method : calibration::leastSquaresMethods())
    if (method.name == options.method) result.solver.method = method.method;
  if (result.free.names.empty() && options.stages.empty() && cell.base_known)
    throw InputError(cell.path, "no free parameter", "a list `identify`, or --free NAME",
                     "`tubeplan identify --help` says what may be freed");
  return result;
}

/// Where a reading problem is: the file, with the line where one reading is to blame.
std::string placeOf(const calibration::ReadingProblem& problem, const std::vector<calibration::Measurement>& readings,
                    const std::string& file) {
  if (problem.reading < 0) return file;
  return fmt::format("{}:{}", file, readings.at(static_cast<std::size_t>(problem.reading)).line);
}

/// A refusal is bad input: names that are no parameters, readings that tell nothing.
void requireAccepted(const Identification& result, const std::vector<calibration::Measurement>& readings,
                     const IdentifyOptions& options, const Cell& cell) {
  if (result.status != IdentificationStatus::kRefused) return;
  if (const auto& problem = result.reading_problem)
    throw InputError(placeOf(*problem, readings, options.measurements), problem->found, problem->expected,
                     problem->advice);
  if (result.problems.empty())
    throw InputError(cell.path, result.reason, "something to find",
                     "`tubeplan identify --help` says what may be freed");
  const auto& problem = result.problems.front();
  std::vector<std::string> known{"geometry", "tool.tip"};
  for (const auto& parameter : deflection::parametersOf(cell.arm)) known.push_back(parameter.name);
  throw InputError(options.free.empty() ? cell.path + " (identify)" : "--free", problem.found, problem.expected,
                   suggestion(problem.name, known));
}

/// "a,b" or "a,b:SETUP".
calibration::IdentificationStage stageOf(const std::string& text) {
  calibration::IdentificationStage stage;
  const std::size_t colon = text.find(':');
  if (colon != std::string::npos) stage.setup = text.substr(colon + 1);
  const std::string names = text.substr(0, colon);
  for (std::size_t from = 0; from <= names.size();) {
    const std::size_t to = std::min(names.find(',', from), names.size());
    stage.names.push_back(names.substr(from, to - from));
    from = to + 1;
  }
  return stage;
}

Identification identifyAsAsked(const IdentifyOptions& options, const Cell& cell,
                               const std::vector<calibration::Measurement>& readings) {
  const auto start = calibration::placeForReadings(cell.arm, cell.X_WB, cell.base_known, readings);
  IdentificationOptions asked = identificationOptions(options, cell);
  if (options.stages.empty()) return calibration::identify(start, readings, asked);
  std::vector<calibration::IdentificationStage> stages;
  for (const auto& text : options.stages) stages.push_back(stageOf(text));
  auto results = calibration::identifyInStages(start, readings, stages, asked);
  if (printsText(options.json))
    for (std::size_t k = 0; k + 1 < results.size(); ++k)
      fmt::print("stage {}\n{}", k + 1, identificationText(results[k], readings, cell.units));
  return std::move(results.back());
}

/// Of the cell's effects as they were fitted; stages hold some of them, so theirs are not judged.
std::vector<calibration::EffectWarning> effectWarnings(const IdentifyOptions& options, const Cell& cell,
                                                       const std::vector<calibration::Measurement>& readings,
                                                       const Identification& result) {
  if (!options.stages.empty() || cell.arm.effects.empty()) return {};
  const auto start = calibration::placeForReadings(cell.arm, cell.X_WB, cell.base_known, readings);
  return calibration::warnOfEffects(start, readings, identificationOptions(options, cell), result);
}

int run(const IdentifyOptions& options) {
  const Cell cell = readCell(options.cell);
  auto readings = readMeasurements(options.measurements, cell.arm, cell.sheet ? &*cell.sheet : nullptr);
  stateSigma(readings, cell, options.measurements, options.sigma);
  requireDefinedFormulas(readings, cell, options.measurements);
  checkJsonTarget(options.json);
  if (!options.out.empty()) checkWritableFile(options.out, "--out");
  const auto result = identifyAsAsked(options, cell, readings);
  requireAccepted(result, readings, options, cell);
  const auto warnings = readingWarnings(result, readings, cell);
  if (!options.out.empty() && result.status == IdentificationStatus::kDone)
    for (const auto& file : identifiedCell(cell, result, options.out))
      writeFileAtomically(file.path, file.text, "--out");
  nlohmann::json json = identificationJson(result, readings, cell.units);
  json["warnings"] = warnings;
  const auto overlaps = calibration::findFormulaOverlaps(result, readings);
  if (!overlaps.empty()) json["overlap"] = overlapJson(overlaps);
  const auto centring = predictCentring(cell, result, options.stages.size() > 1);
  json["predicted_centring_error"] = predictedCentringJson(centring, cell.units);
  const auto of_effects = effectWarnings(options, cell, readings, result);
  for (const auto& warning : effectWarningsJson(of_effects, cell.units)) json["warnings"].push_back(warning);
  writeJson(options.json, json);
  if (printsText(options.json)) {
    fmt::print("{}{}{}", identificationText(result, readings, cell.units),
               predictedCentringText(centring, cell.units), overlapText(overlaps));
    for (const auto& warning : warnings) fmt::print("  warning: {}\n", warning);
    for (const auto& warning : of_effects) fmt::print("  warning: {}\n", warningText(warning, cell.units));
  }
  return result.status == IdentificationStatus::kDone ? kDone : kNegativeAnswer;
}

}  // namespace

Run configureIdentify(CLI::App& cli) {
  const auto options = std::make_shared<IdentifyOptions>();
  cli.add_option("CELL", options->cell, "the cell file")->required();
  cli.add_option("MEASUREMENTS", options->measurements, "readings of any kind (CSV)")->required();
  cli.add_option("--free", options->free,
                 "parameters to free instead of the cell's `identify`: dotted paths into the arm file "
                 "(tool.joint_stiffness.z), tool.tip, geometry")
      ->delimiter(',');
  cli.add_option("--out", options->out, "write the cell with what was found to this file, its arm beside it");
  cli.add_option("--sigma", options->sigma,
                 "noise of a coordinate where the file states none, in the cell's length unit");
  cli.add_option("--robust", options->robust, "loss that weakens outliers")
      ->check(CLI::IsMember({"none", "huber", "cauchy"}));
  std::vector<std::string> methods;
  for (const auto& method : calibration::leastSquaresMethods()) methods.emplace_back(method.name);
  cli.add_option("--method", options->method, "how to minimise; the last two are there for comparison")
      ->check(CLI::IsMember(methods))
      ->capture_default_str();
  cli.add_option("--stage", options->stages,
                 "NAMES[:SETUP]: free these numbers on that set-up's readings, those of the stages before held; repeat "
                 "for each stage")
      ->allow_extra_args(false);
  cli.add_option("--starts", options->starts, "starts, the others drawn around the given one")
      ->check(CLI::Range(1, 1000));
  cli.add_option("--folds", options->folds, "folds of the cross-validation by pose; 0 for none")
      ->check(CLI::Range(0, 100));
  cli.add_option("--drop", options->drop, "give up parameters that the readings do not need at this level (0.05)")
      ->check(CLI::Range(0., 0.5));
  cli.add_option("--seed", options->seed, "seed of drawn starts and folds");
  cli.add_option("--json", options->json, "write the figures as JSON to this file, or - for standard output");
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
