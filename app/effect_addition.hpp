// A cell with one more effect, of the catalogue or the user's own formula, to be fitted with the rest.
#pragma once

#include <string>
#include <vector>

#include "app/reading_input.hpp"

namespace tubeplan::app {

/// What is asked for: EFFECT@AT alone, or a formula with nothing or formula@TARGET beside it.
struct EffectRequest {
  std::string effect, formula;
};

/// Throws InputError for neither, both, or what the readers of effects refuse.
[[nodiscard]] deflection::Effect effectOf(const EffectRequest& request, const Cell& cell);

struct EffectAddition {
  Cell cell;                       ///< with the effect; its source as it was
  std::string name;                ///< backlash@tool.z
  std::vector<std::string> freed;  ///< the effect's numbers, which the cell's `identify` has now too
};

/// Throws InputError for an effect that the cell has already.
[[nodiscard]] EffectAddition addEffect(Cell cell, const deflection::Effect& effect);

/// In words: the overlap of the cell's formulas with the catalogue at these readings.
[[nodiscard]] std::string overlapAt(const CellReadings& input);

}  // namespace tubeplan::app
