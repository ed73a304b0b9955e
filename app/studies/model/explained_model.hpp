// A model with what a diagnosis found: effects of the catalogue, and numbers of the arm's file that were held.
#pragma once

#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

struct AddedCauses {
  std::vector<std::string> names;  ///< backlash@tool.z, free@latch-link.beam.Iz
  std::vector<std::string> freed;  ///< the numbers that the cell's `identify` has now too
  std::vector<deflection::Effect> formulas;
};

/// Adds an effect and the numbers of it that a fit shall find. False where the model has it already: nothing is
/// changed.
[[nodiscard]] bool addEffect(const deflection::Effect& effect, const std::vector<std::string>& freed, CellModel& cell,
                             AddedCauses& added);

/// Puts what is freed into `identify`; leaves in `freed` what was not there, each once.
void freeAdded(CellModel& cell, AddedCauses& added);

/// Adds a diagnosis's explanation, its numbers where it found them; an effect that the model has already is left.
AddedCauses addExplanation(const calibration::Explanation& found, CellModel& cell);

}  // namespace tubeplan::app
