#include "app/effect_addition.hpp"

#include "app/cell_fit.hpp"
#include "app/input_error.hpp"
#include "app/overlap_report.hpp"
#include "app/readers/cell_writer.hpp"
#include "app/readers/effects_reader.hpp"
#include "calibration/diagnosis/formula_overlap.hpp"

namespace tubeplan::app {

deflection::Effect effectOf(const EffectRequest& request, const Cell& cell) {
  const std::string prefix = "formula@";
  const bool is_named = request.effect.starts_with(prefix);
  if (request.formula.empty() && (request.effect.empty() || is_named))
    throw InputError("EFFECT@AT", request.effect.empty() ? "nothing" : inQuotes(request.effect) + " alone",
                     "EFFECT@AT, as backlash@tool.z, or --formula 'theta3 += c*sin(3*theta1)'");
  if (request.formula.empty()) return parseEffect(request.effect, cell.arm, cell.units, "EFFECT@AT").effect;
  if (!request.effect.empty() && !is_named)
    throw InputError("EFFECT@AT", inQuotes(request.effect) + " and a formula", "one of them, or formula@TARGET");
  return parseFormula(request.formula, cell.arm, cell.units, "--formula",
                      is_named ? request.effect.substr(prefix.size()) : "");
}

EffectAddition addEffect(Cell cell, const deflection::Effect& effect) {
  EffectAddition added{std::move(cell), "", {}};
  added.name = deflection::textOf(added.cell.arm, effect);
  for (const auto& present : added.cell.arm.effects)
    if (deflection::textOf(added.cell.arm, present) == added.name)
      throw InputError("EFFECT@AT", added.name + ", which the cell has already", "another effect or place", "");
  added.cell.arm.effects.push_back(effect);
  added.freed = freedNames(added.cell.arm, effect);
  added.cell.identify.insert(added.cell.identify.end(), added.freed.begin(), added.freed.end());
  return added;
}

std::string overlapAt(const CellReadings& input) {
  const auto& cell = input.cell;
  const auto& readings = input.readings;
  calibration::IdentificationOptions asked;
  asked.free = freeNumbersOf(cell);
  asked.folds = 0;
  asked.intervals_by_profile = false;
  const auto result = calibration::identify(startOf(cell, readings), readings, asked);
  if (result.status != calibration::IdentificationStatus::kDone)
    return "no overlap with the catalogue can be told: " + result.reason + "\n";
  return overlapText(calibration::findFormulaOverlaps(result, readings));
}

}  // namespace tubeplan::app
