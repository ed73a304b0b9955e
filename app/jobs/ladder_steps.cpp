#include "app/jobs/ladder_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/files/input_error.hpp"
#include "app/files/units.hpp"
#include "app/files/workcell.hpp"

namespace tubeplan::app {

namespace {

/// A cell for its sheet and tool: the one that was named, else the first that has both.
std::optional<Cell> sheetCell(const LadderStepOptions& options, const std::vector<Cell>& cells) {
  for (const auto& path : {options.sheet, options.truth})
    if (!path.empty()) return readCell(path);
  const auto found = std::find_if(cells.begin(), cells.end(), [](const Cell& c) { return c.sheet && c.tool; });
  return found == cells.end() ? std::nullopt : std::optional(*found);
}

void requireOneSheet(const Cell& cell, const tubesheets::Sheet& sheet) {
  if (cell.sheet && cell.sheet->fingerprint() != sheet.fingerprint())
    throw InputError(cell.path, "another tube sheet", "the same for every model, fingerprint " + sheet.fingerprint());
}

/// The model whose held-out error is least.
const ModelComparisonRow* bestRow(const std::vector<ModelComparisonRow>& comparison) {
  const ModelComparisonRow* best = nullptr;
  for (const auto& compared : comparison)
    if (!compared.model.arm.rows.empty() && std::isfinite(compared.heldout.rms) &&
        (!best || compared.heldout.rms < best->heldout.rms))
      best = &compared;
  return best;
}

/// The best model for want of the real arm: what it leaves open is taken as large as the noise floor.
void standIn(const ModelComparisonRow& best, RealArm& real) {
  real.cell.arm = best.model.arm;
  real.cell.X_WB = best.model.base_poses.back().X_WB;
  real.name = best.name + ", with an unmodelled error as large as the noise floor";
  real.unmodelled = std::isfinite(best.noise_floor) ? best.noise_floor / std::sqrt(3.) : 0;
}

}  // namespace

LadderSteps addSteps(const LadderStepOptions& options, const std::vector<Cell>& cells,
                     std::vector<ModelComparisonRow>& comparison, const WorkHooks& hooks) {
  LadderSteps steps;
  const auto with_sheet = sheetCell(options, cells);
  const ModelComparisonRow* best = bestRow(comparison);
  if (!with_sheet)
    steps.reason = "no cell has a tube sheet and a calibration tool (--sheet CELL names one)";
  else if (!best && options.truth.empty())
    steps.reason = "no model could be fitted";
  if (!steps.reason.empty()) return steps;
  steps.real.cell = workcellOf(*with_sheet, "count the steps that go in");
  if (options.truth.empty()) {
    standIn(*best, steps.real);
  } else {
    const Cell truth = readCell(options.truth);
    requireOneSheet(truth, steps.real.cell.sheet);
    steps.real.cell.arm = truth.arm;
    steps.real.cell.X_WB = truth.X_WB;
    steps.real.name = options.truth;
  }
  steps.real.cell.arm.tool_axis_L = with_sheet->arm.tool_axis_L;  // a cell without a sheet may not tell it
  beginStep(hooks, "steps of the tool", 0, comparison.size() + 1);
  const StepHoles holes = drawStepHoles(steps.real, options.holes, options.seed, hooks.stop);
  steps.holes = static_cast<int>(holes.holes.size());
  steps.out_of_reach = holes.out_of_reach;
  if (holes.holes.empty()) steps.reason = "the real arm reaches no hole of the sheet";
  for (std::size_t k = 0; k < comparison.size() && steps.reason.empty(); ++k) {
    requireOneSheet(cells[k], steps.real.cell.sheet);
    beginStep(hooks, "steps of the tool", k + 1, comparison.size() + 1);
    auto& table = comparison[k].steps.emplace();
    if (comparison[k].model.arm.rows.empty())
      table.reason = "the model could not be fitted";
    else
      table = stepTableOf(comparison[k].model.arm, comparison[k].model.base_poses.back().X_WB, steps.real, holes,
                          hooks.stop);
  }
  requireGoingOn(hooks);
  return steps;
}

nlohmann::json ladderStepsJson(const LadderSteps& steps, const LadderStepOptions& options, const Units& units) {
  if (!steps.reason.empty()) return {{"reason", steps.reason}};
  return {{"real_arm", steps.real.name},
          {"unmodelled_sigma", lengthOf(steps.real.unmodelled, units)},
          {"holes", steps.holes},
          {"out_of_reach", steps.out_of_reach},
          {"seed", options.seed}};
}

std::string ladderStepsText(const LadderSteps& steps, const Units& units) {
  if (!steps.reason.empty()) return "no step table: " + steps.reason + "\n";
  std::string text = fmt::format("for the real arm stands {}", steps.real.name);
  if (steps.real.unmodelled > 0)
    text +=
        fmt::format(" (sigma {:.3g} {} of a coordinate)", lengthOf(steps.real.unmodelled, units), units.length().name);
  return text +
         fmt::format("; {} random holes within its reach ({} drawn beyond it)\n", steps.holes, steps.out_of_reach);
}

}  // namespace tubeplan::app
