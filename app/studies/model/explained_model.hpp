// A model with the findings of a diagnosis: effects of the catalogue, and numbers of the arm's file that were held.
#pragma once

#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

struct AddedCauses {
  std::vector<std::string> names;  ///< names of the causes: `backlash@tool.z`, `free@latch-link.beam.Iz`
  std::vector<std::string> freed;  ///< numbers added to the cell's `identify`
  std::vector<deflection::Effect> formulas;
};

/// Adds an effect, and frees those of its numbers that a fit must find. Returns false, without any change, if the model
/// has it already.
[[nodiscard]] bool addEffect(const deflection::Effect& effect, const std::vector<std::string>& freed, CellModel& cell,
                             AddedCauses& added);

/// Adds freed numbers to `identify`; keeps in `freed` those that were not there, each once.
void freeAdded(CellModel& cell, AddedCauses& added);

/// Adds a diagnosis's explanation with the numbers that it found; an effect that the model already has is left
/// unchanged.
AddedCauses addExplanation(const calibration::Explanation& found, CellModel& cell);

}  // namespace tubeplan::app
