#include "app/studies/model/explained_model.hpp"

#include <algorithm>
#include <cmath>

namespace tubeplan::app {

namespace {

/// Returns the names of an effect's parameters that a fit must free: those that the diagnosis could determine, and
/// shape parameters except times.
std::vector<std::string> freedOf(const deflection::Arm& arm, const calibration::FoundEffect& effect) {
  std::vector<std::string> freed;
  const auto& numbers = deflection::numbersOf(effect.fitted);
  for (std::size_t v = 0; v < numbers.size(); ++v)
    if (std::isfinite(effect.numbers[v].sigma) ||
        (numbers[v].is_shape && numbers[v].quantity != deflection::Quantity::kTime))
      freed.push_back(deflection::textOf(arm, effect.fitted) + "." + numbers[v].name);
  return freed;
}

}  // namespace

bool addEffect(const deflection::Effect& effect, const std::vector<std::string>& freed, CellModel& cell,
               AddedCauses& added) {
  const std::string name = deflection::textOf(cell.arm, effect);
  for (const auto& present : cell.arm.effects)
    if (deflection::textOf(cell.arm, present) == name) return false;
  cell.arm.effects.push_back(effect);
  added.names.push_back(name);
  added.freed.insert(added.freed.end(), freed.begin(), freed.end());
  if (effect.formula) added.formulas.push_back(effect);
  return true;
}

void freeAdded(CellModel& cell, AddedCauses& added) {
  std::vector<std::string> more;
  for (const auto& name : added.freed)
    if (std::find(cell.identify.begin(), cell.identify.end(), name) == cell.identify.end())
      cell.identify.push_back(name), more.push_back(name);
  added.freed = std::move(more);
}

AddedCauses addExplanation(const calibration::Explanation& found, CellModel& cell) {
  AddedCauses added;
  for (const auto& effect : found.effects) {
    if (effect.frees.empty()) {
      (void)addEffect(effect.fitted, freedOf(cell.arm, effect), cell, added);
      continue;
    }
    added.names.push_back(effect.effect + "@" + effect.at);
    added.freed.insert(added.freed.end(), effect.frees.begin(), effect.frees.end());
  }
  freeAdded(cell, added);
  return added;
}

}  // namespace tubeplan::app
