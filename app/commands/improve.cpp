// `tubeplan improve`: repeats diagnose, add and identify until no further cause is found.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/commands/measurement_answer.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/diagnosis_pages.hpp"
#include "app/documents/error_figures.hpp"
#include "app/documents/improvement_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/formats/cell/cell_places.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/jobs/improvement.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/count_text.hpp"

namespace tubeplan::app {

namespace {

struct ImproveOptions {
  std::string cell, out;
  FiguresTarget figures;
  ReportTarget report;
  MeasurementFiles measurement_files;
  MeasurementOptions given;
  ImprovementRequest request;
};

/// Returns a string such as ", without 2 measurements"; empty if `count` is 0.
std::string withoutText(std::size_t count) { return count == 0 ? "" : ", without " + countText(count, "reading"); }

/// Writes and prints each model as soon as it is found, so that completed steps survive a stop.
class Keeper {
 public:
  Keeper(const CellMeasurements& input, const ImproveOptions& options) : input_(input), options_(options) {}

  void keep(const ImprovedModel& model) {
    const auto used = calibration::withoutMeasurements(input_.measurements, model.set_aside);
    const auto files = improvedCell(input_.cell, model.cell, model.fit, used, options_.out);
    step_ = model.step;
    // Write the first fit only at the end, because the measurements may allow no verdict on it.
    if (step_ > 0)
      write(files);
    else
      first_ = files;
    if (printsText(options_.figures))
      output("{}{}: held-out error {}\n", model.name, withoutText(model.set_aside.size()),
             errorText(model.fit.heldout.rms, errorUnitOf(model.fit.after.are_angles, input_.cell.units)));
    std::fflush(stdout);
  }

  void finish(bool is_usable) {
    if (is_usable && step_ == 0) write(*first_);
  }

  [[nodiscard]] int steps() const { return step_; }

 private:
  static void write(const CellFiles& files) { writeFilesTogether(files.inOrder(), "--out"); }

  const CellMeasurements& input_;
  const ImproveOptions& options_;
  std::optional<CellFiles> first_;
  int step_ = 0;
};

/// Returns a text that states why the loop ended early, whether a model was written, and how to undo the last step.
std::string endText(const Improvement& result, const ImproveOptions& options) {
  std::string text;
  if (result.end == ImprovementEnd::kNotFitted)
    text += fmt::format("the model as given cannot be fitted: {}\n", result.models.front().fit.reason);
  if (result.end == ImprovementEnd::kMostSteps) text += fmt::format("ended after --steps {}\n", options.request.steps);
  text += result.isUsable() ? fmt::format("wrote {}\n", options.out) : "nothing was written\n";
  if (result.models.size() > 2) text += fmt::format("--steps {} leaves the last step out\n", result.models.size() - 2);
  return text;
}

int run(const ImproveOptions& options) {
  const CellMeasurements input = readCellMeasurements(options.cell, options.measurement_files, options.given);
  checkFigures(options.figures);
  checkReportTarget(options.report);
  checkWritableCellAndArm(input.cell, options.out, "--out");
  Keeper keeper(input, options);
  ImprovementRequest request = options.request;
  request.on_model = [&](const ImprovedModel& model) { keeper.keep(model); };
  try {
    const auto result = improveModel(input, request, terminalWorkHooks());
    keeper.finish(result.isUsable());
    nlohmann::json json = improvementJson(result, input.measurements, input.cell.units);
    addChecks(input.checks, input.cell.units, json);
    if (options.report.isWanted()) writeReport(options.report, improvementPage(input, options.request.seed, result));
    showFigures(options.figures, json,
                checksText(input.checks, input.cell.units) + improvementText(json) + endText(result, options));
    return answerOver(input.checks, result.isUsable());
  } catch (const JobStopped&) {
    if (keeper.steps() == 0) throw;
    throw JobStopped{fmt::format("{} contains the model of step {}", options.out, keeper.steps())};
  }
}

}  // namespace

Run configureImprove(CLI::App& cli) {
  const auto options = std::make_shared<ImproveOptions>();
  addCell(cli, options->cell);
  addMeasurements(cli, options->measurement_files);
  cli.add_option("--out", options->out, "write the improved cell to this file, and its arm file to the same folder")
      ->required();
  cli.add_option("--steps", options->request.steps, "largest number of causes to add, one per step")
      ->check(within(1, 20));
  addMeasurementOptions(cli, options->given);
  addSeed(cli, options->request.seed, "seed of the simulated noise and the folds");
  addReportOptions(cli, options->report, "write a self-contained report (HTML) to this file");
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
