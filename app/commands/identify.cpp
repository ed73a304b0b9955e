// `tubeplan identify`: determines the parameters of the model and the base pose from measurements.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/commands/measurement_answer.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/effect_warnings_json.hpp"
#include "app/documents/identification_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/documents/overlap_report.hpp"
#include "app/documents/predicted_centring_json.hpp"
#include "app/formats/cell/cell_places.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/jobs/identification.hpp"
#include "app/storage/atomic_file.hpp"
#include "calibration/diagnosis/judgement/verdict.hpp"

namespace tubeplan::app {

namespace {

using calibration::IdentificationStatus;

struct IdentifyOptions {
  std::string cell, out;
  FiguresTarget figures;
  MeasurementFiles measurement_files;
  MeasurementOptions given;
  bool verbose = false;
  IdentificationRequest request;
};

/// Prints one line about an iteration of the fit to `out`, preceded by headings for the first iteration of a method.
void printIteration(std::FILE* out, const calibration::LeastSquaresIteration& now) {
  if (now.iteration == 0)
    fmt::print(out, "  {}\n  {:>9} {:>15} {:>12} {:>12}\n", now.method, "iteration", "chi-square", "step", "damping");
  fmt::print(out, "  {:>9} {:>15.9g} {:>12.3g} {:>12.3g}\n", now.iteration, now.chi2, now.step, now.damping);
  std::fflush(out);
}

/// Prints the reason why there is no result, in the same form as `diagnose`.
void printWithheld(const IdentifyOptions& options, const IdentificationOutcome& outcome) {
  output("{}\n{}\n{}{}", nameOf(calibration::Verdict::kInconclusive), noVerdictSentence(outcome.fit.reason),
         options.out.empty() ? "" : "nothing was written\n", warningsText(outcome.warnings));
}

int run(const IdentifyOptions& options) {
  const CellMeasurements input = readCellMeasurements(options.cell, options.measurement_files, options.given);
  const auto& [cell, file, measurements, checks] = input;
  checkFigures(options.figures);
  if (!options.out.empty()) checkWritableCellAndArm(cell, options.out, "--out");
  IdentificationRequest request = options.request;
  if (printsText(options.figures)) output("{}", checksText(checks, cell.units));
  if (options.verbose)
    request.observe = [out = printsText(options.figures) ? stdout : stderr](const auto& now) {
      printIteration(out, now);
    };
  if (printsText(options.figures))
    request.stage_done = [&](int stage, const calibration::Identification& fit) {
      output("stage {}\n{}", stage + 1,
             identificationText(identificationJson(fit, input.measurements, 0, input.cell.units)));
    };
  const auto outcome = identifyModel(input, request, terminalWorkHooks());
  if (!options.out.empty() && outcome.fit.status == IdentificationStatus::kDone)
    writeFilesTogether(identifiedCell(cell, outcome.fit, outcome.measurements, options.out).inOrder(), "--out");
  writeFigures(options.figures, outcome.figures);
  if (printsText(options.figures) && outcome.fit.status == IdentificationStatus::kNotRun) {
    printWithheld(options, outcome);
  } else if (printsText(options.figures)) {
    output("{}{}{}{}{}", identificationText(outcome.figures),
           cell.sheet ? predictedCentringText(outcome.figures["predicted_centring_error"]) : "",
           overlapText(outcome.overlaps), warningsText(outcome.warnings),
           warningsText(warningTexts(outcome.of_effects, cell.units)));
  }
  return answerOver(checks, outcome.fit.status == IdentificationStatus::kDone && !outcome.is_base_refused);
}

}  // namespace

Run configureIdentify(CLI::App& cli) {
  const auto options = std::make_shared<IdentifyOptions>();
  addCell(cli, options->cell);
  addMeasurements(cli, options->measurement_files);
  cli.add_option("--free", options->request.free,
                 "parameters to free instead of the cell's `identify`: dotted paths into the arm file "
                 "(tool.joint_stiffness.z), tool.tip, geometry")
      ->delimiter(',');
  cli.add_option("--out", options->out, "write the identified cell to this file, and its arm file to the same folder");
  addMeasurementOptions(cli, options->given);
  cli.add_option("--robust", options->request.robust, "robust loss function")
      ->check(oneOf({"none", "huber", "cauchy"}));
  std::vector<std::string> methods;
  for (const auto& method : calibration::leastSquaresMethods()) methods.emplace_back(method.name);
  cli.add_option("--method", options->request.method, "least-squares method")
      ->check(oneOf(methods))
      ->capture_default_str();
  cli.add_option("--stage", options->request.stages,
                 "NAMES[:SETUP]: identify these parameters from that set-up's readings, those of earlier stages held "
                 "fixed; repeat for each stage")
      ->allow_extra_args(false);
  cli.add_option("--starts", options->request.starts,
                 "number of initial values; all but the first are drawn around the given one")
      ->check(within(1, 1000));
  cli.add_option("--folds", options->request.folds, "folds of the cross-validation by pose; 0 for none")
      ->check(within(0, kMostFolds));
  cli.add_option("--drop", options->request.drop, "drop parameters that are not significant at this level (0.05)")
      ->check(within(0., 0.5));
  addSeed(cli, options->request.seed, "seed of the initial values and the folds");
  cli.add_flag("-v,--verbose", options->verbose,
               "print every iteration of the fit: chi-square (with the priors' part), length of the step, damping");
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
