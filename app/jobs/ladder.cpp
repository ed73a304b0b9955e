#include "app/jobs/ladder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/documents/ladder_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/jobs/outliers.hpp"
#include "app/studies/model/cell_fit.hpp"

namespace tubeplan::app {

namespace {

std::vector<calibration::Measurement> without(const CellMeasurements& input, const std::vector<std::string>& ids) {
  auto measurements = input.measurements;
  std::erase_if(measurements, [&](const auto& measurement) {
    return std::find(ids.begin(), ids.end(), measurement.id) != ids.end();
  });
  return measurements;
}

/// Returns the cell that provides the sheet and the tool: the cell named in the request, else the cell of the first
/// model that has both. std::nullopt if there is none.
std::optional<Cell> sheetCell(const LadderRequest& request, const std::vector<LadderModel>& models) {
  for (const auto& path : {request.sheet, request.truth})
    if (!path.empty()) return readCell(path);
  const auto found = std::find_if(models.begin(), models.end(),
                                  [](const auto& model) { return model.input.cell.sheet && model.input.cell.tool; });
  return found == models.end() ? std::nullopt : std::optional(found->input.cell);
}

void requireOneSheet(const Cell& cell, const tubesheets::Sheet& sheet) {
  if (cell.sheet && cell.sheet->fingerprint() != sheet.fingerprint())
    throw InputError::problem(
        cell.path,
        fmt::format("this tube sheet (fingerprint {}) differs from that of the step table (fingerprint {})",
                    cell.sheet->fingerprint(), sheet.fingerprint()),
        "give cells with the same tube sheet");
}

/// Returns the real arm for the step tables: the arm of the truth, or of the best model if no truth is named. The sheet
/// and the tool are taken from `with_sheet`.
RealArm realArmOf(const LadderRequest& request, const Cell& with_sheet, const ModelComparisonRow* best) {
  RealArm real;
  real.cell = workcellOf(with_sheet, "count the inserted steps");
  if (request.truth.empty()) {
    takeAsRealArm(*best, real);
  } else {
    const Cell truth = readCell(request.truth);
    requireOneSheet(truth, real.cell.sheet);
    real.cell.arm = truth.arm;
    real.cell.X_WB = truth.X_WB;
    real.name = request.truth;
  }
  real.cell.arm.tool_axis_L = with_sheet.arm.tool_axis_L;  // the true arm's cell may lack a tool axis
  return real;
}

LadderSteps stepsOf(const std::vector<LadderModel>& models, const LadderRequest& request,
                    std::vector<ModelComparisonRow>& comparison, const WorkHooks& hooks) {
  LadderSteps none;
  const auto with_sheet = sheetCell(request, models);
  const ModelComparisonRow* best = bestRow(comparison);
  if (!with_sheet)
    none.reason = "no cell has a tube sheet and a calibration tool (--sheet CELL names one)";
  else if (!best && request.truth.empty())
    none.reason = "no model could be fitted";
  if (!none.reason.empty()) return none;
  RealArm real = realArmOf(request, *with_sheet, best);
  for (const auto& model : models) requireOneSheet(model.input.cell, real.cell.sheet);
  return addStepTables(std::move(real), request.holes, request.seed, comparison, hooks);
}

bool isMade(const calibration::Identification* fit) {
  return fit && fit->status != calibration::IdentificationStatus::kNotRun;
}

/// Fits a model and returns the ids of its outliers, followed by the ids that were already set aside.
std::vector<std::string> setAsideBy(const LadderModel& model, const LadderRequest& request, const WorkHooks& hooks) {
  beginStep(hooks, "fit");
  CellMeasurements input = model.input;
  input.measurements = without(input, request.set_aside);
  calibration::IdentificationOptions options;
  options.free = freeNumbersOf(input.cell);
  options.seed = request.seed;
  options.hooks = hooks;
  const auto fit = fitForLadder(input.cell, input.measurements, request.seed, calibration::withoutProgress(hooks));
  std::vector<std::string> ids = idsAt(outliersOf(input, fit, options), input.measurements);
  ids.insert(ids.end(), request.set_aside.begin(), request.set_aside.end());
  return ids;
}

}  // namespace

Cell rigidOf(Cell cell) {
  cell.arm = deflection::rigidCopy(cell.arm);
  cell.identify.clear();
  return cell;
}

LadderOutcome runLadder(const std::vector<LadderModel>& models, const LadderRequest& request, const WorkHooks& hooks) {
  LadderOutcome outcome;
  const bool is_top_made = isMade(models.back().fit);
  outcome.set_aside = is_top_made ? request.set_aside : setAsideBy(models.back(), request, hooks);
  for (const auto& [name, input, fit] : models) {
    beginStep(hooks, "ladder: " + name, outcome.comparison.size(), models.size());
    outcome.comparison.push_back(isMade(fit) ? comparisonRowOf(name, *fit)
                                             : comparisonRowOf(name, input.cell, without(input, outcome.set_aside),
                                                               request.seed, calibration::withoutProgress(hooks)));
  }
  outcome.steps = stepsOf(models, request, outcome.comparison, within(hooks, "ladder"));
  const Units& units = models.front().input.cell.units;
  outcome.figures = ladderJson(outcome.comparison, outcome.steps, outcome.set_aside, request.seed, units);
  if (const auto mistake = mistakeText(models.back().input.checks, units); !mistake.empty())
    outcome.figures["sentence"] = noVerdictSentence(mistake);
  return outcome;
}

}  // namespace tubeplan::app
