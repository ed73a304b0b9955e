#include "app/jobs/effect_addition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/documents/overlap_report.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/formats/cell/effects_reader.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "app/studies/model/cell_fit.hpp"
#include "calibration/diagnosis/causes/cause.hpp"
#include "calibration/diagnosis/causes/formula_overlap.hpp"

namespace tubeplan::app {

namespace {

using deflection::Effect;

constexpr const char* kWhere = "EFFECT@AT";
constexpr const char* kFormulaAt = "formula@";

void addOrRefuse(Addition& addition, const Effect& effect) {
  if (!addEffect(effect, freedNames(addition.cell.arm, effect), addition.cell, addition))
    throw InputError::problem(kWhere, "the cell already has " + deflection::textOf(addition.cell.arm, effect),
                              "name another effect or place");
}

/// Frees the parameters of a cause such as "free@latch-link.beam.Iz" or "free@geometry"; `name` follows the "@".
void freeNumbers(Addition& addition, const std::string& name) {
  const auto& arm = addition.cell.arm;
  const auto known = calibration::freeableNames(arm);
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw InputError(kWhere, inQuotes(name), "the path of a number in the arm file, or geometry",
                     suggestion(name, known));
  addition.names.push_back(fmt::format("{}@{}", calibration::kFreedNumbers, name));
  addition.freed.push_back(name);
}

/// Adds the effect at every joint where it can act.
void addAtAllJoints(Addition& addition, const std::string& effect) {
  const auto effects = calibration::effectsAtAllJoints(addition.cell.arm, effect);
  if (effects.empty())
    throw InputError::problem(kWhere, "there is no effect " + inQuotes(effect) + " that acts at each joint",
                              "`tubeplan effects CELL` lists the places of each effect");
  for (const Effect& joint_effect : effects) addOrRefuse(addition, joint_effect);
}

void addCause(Addition& addition, const std::string& text) {
  const std::size_t at = text.find('@');
  const std::string name = text.substr(0, at), place = at == std::string::npos ? "" : text.substr(at + 1);
  if (name == calibration::kFreedNumbers) return freeNumbers(addition, place);
  if (place == calibration::kAllJoints) return addAtAllJoints(addition, name);
  addOrRefuse(addition, parseEffect(text, addition.cell.arm, addition.cell.units, kWhere).effect);
}

/// Removes a cause from the cell: for "free@NAME" the name in `identify`, otherwise the effect with all its free
/// parameters. Throws InputError if the cell does not have the cause.
void removeOrRefuse(Cell& cell, const std::string& cause) {
  const std::string freed = fmt::format("{}@", calibration::kFreedNumbers);
  const bool is_name = cause.starts_with(freed);
  const std::string name = is_name ? cause.substr(freed.size()) : cause + ".";
  const auto is_gone = [&](const std::string& own) { return is_name ? own == name : own.starts_with(name); };
  std::size_t effects = 0;
  if (!is_name)
    effects =
        std::erase_if(cell.arm.effects, [&](const Effect& own) { return deflection::textOf(cell.arm, own) == cause; });
  const std::size_t names = std::erase_if(cell.identify, is_gone);
  if (effects + (is_name ? names : 0) == 0)
    throw InputError::problem(kWhere, "the model has no " + inQuotes(cause),
                              "name an effect or a free number of the model");
}

}  // namespace

Addition addToCell(const Cell& cell, const AdditionRequest& request) {
  if (request.causes.empty() && request.formula.empty())
    throw InputError::problem(kWhere, "no effect to add is named",
                              "name one, such as backlash@tool.z, or give --formula 'theta3 += c*sin(3*theta1)'");
  Addition addition{{}, cell};
  std::string target;
  for (const auto& cause : request.causes) {
    if (!request.formula.empty() && target.empty() && cause.starts_with(kFormulaAt))
      target = cause.substr(std::string(kFormulaAt).size());
    else
      addCause(addition, cause);
  }
  if (!request.formula.empty())
    addOrRefuse(addition, parseFormula(request.formula, addition.cell.arm, cell.units, "--formula", target));
  freeAdded(addition.cell, addition);
  return addition;
}

Cell withoutCauses(const Cell& cell, const std::vector<std::string>& causes) {
  if (causes.empty())
    throw InputError::problem(kWhere, "no cause to remove is named", "name EFFECT@AT or free@NAME of the model");
  Cell without = cell;
  for (const auto& cause : causes) removeOrRefuse(without, cause);
  return without;
}

std::string cellTextWith(const Cell& cell, const Addition& addition, const std::filesystem::path& out) {
  return cellTextWithEffects(cell, addition.cell.arm, addition.freed, out);
}

std::string overlapAt(const CellMeasurements& input) {
  const auto& cell = input.cell;
  const auto& measurements = input.measurements;
  calibration::IdentificationOptions options;
  options.free = freeNumbersOf(cell);
  options.folds = 0;
  options.intervals_by_profile = false;
  const auto result = calibration::identify(startOf(cell, measurements), measurements, options);
  if (result.status != calibration::IdentificationStatus::kDone)
    return "the overlap with the catalogue cannot be computed: " + result.reason + "\n";
  return overlapText(calibration::findFormulaOverlaps(result, measurements));
}

}  // namespace tubeplan::app
