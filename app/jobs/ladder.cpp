#include "app/jobs/ladder.hpp"

#include <algorithm>

#include "app/documents/ladder_json.hpp"
#include "app/files/workcell.hpp"

namespace tubeplan::app {

namespace {

/// A cell for its sheet and tool: the one that was named, else the first that has both.
std::optional<Cell> sheetCell(const LadderRequest& request, const std::vector<LadderModel>& models) {
  for (const auto& path : {request.sheet, request.truth})
    if (!path.empty()) return readCell(path);
  const auto found = std::find_if(models.begin(), models.end(),
                                  [](const auto& model) { return model.input.cell.sheet && model.input.cell.tool; });
  return found == models.end() ? std::nullopt : std::optional(found->input.cell);
}

void requireOneSheet(const Cell& cell, const tubesheets::Sheet& sheet) {
  if (cell.sheet && cell.sheet->fingerprint() != sheet.fingerprint())
    throw InputError(cell.path, "another tube sheet", "the same for every model, fingerprint " + sheet.fingerprint());
}

/// The arm of the truth, or the best model for want of it, under the sheet.
RealArm realArmOf(const LadderRequest& request, const Cell& with_sheet, const ModelComparisonRow* best) {
  RealArm real;
  real.cell = workcellOf(with_sheet, "count the steps that go in");
  if (request.truth.empty()) {
    standIn(*best, real);
  } else {
    const Cell truth = readCell(request.truth);
    requireOneSheet(truth, real.cell.sheet);
    real.cell.arm = truth.arm;
    real.cell.X_WB = truth.X_WB;
    real.name = request.truth;
  }
  real.cell.arm.tool_axis_L = with_sheet.arm.tool_axis_L;  // a cell without a sheet may not state it
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

}  // namespace

Cell rigidOf(Cell cell) {
  cell.arm = deflection::rigidCopy(cell.arm);
  cell.identify.clear();
  return cell;
}

LadderOutcome climbLadder(const std::vector<LadderModel>& models, const LadderRequest& request,
                          const WorkHooks& hooks) {
  LadderOutcome outcome;
  for (const auto& [name, input, fit] : models) {
    beginStep(hooks, "ladder: " + name, outcome.comparison.size(), models.size());
    const bool is_made = fit && fit->status != calibration::IdentificationStatus::kNotRun;
    outcome.comparison.push_back(
        is_made ? comparisonRowOf(name, *fit)
                : comparisonRowOf(name, input.cell, input.readings, request.seed, calibration::withoutProgress(hooks)));
  }
  outcome.steps = stepsOf(models, request, outcome.comparison, within(hooks, "ladder"));
  outcome.figures = ladderJson(outcome.comparison, outcome.steps, request.seed, models.front().input.cell.units);
  return outcome;
}

}  // namespace tubeplan::app
