// Extension of a model by the findings of a diagnosis: adds effects of the catalogue, and frees parameters of the arm
// file that were held fixed.
#pragma once

#include <string>
#include <vector>

#include "app/studies/cell_model.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

struct AddedCauses {
  std::vector<std::string> names;  ///< names of the causes, such as `backlash@tool.z` or `free@latch-link.beam.Iz`
  std::vector<std::string> freed;  ///< parameters added to the cell's `identify`
  std::vector<deflection::Effect> formulas;
};

/// Adds an effect to the cell's arm, and its name and the names of its parameters to free (`freed`) to `added`. Returns
/// false, and changes nothing, if the arm already has the effect.
[[nodiscard]] bool addEffect(const deflection::Effect& effect, const std::vector<std::string>& freed, CellModel& cell,
                             AddedCauses& added);

/// Adds `added.freed` to the cell's `identify`. Afterwards `added.freed` has only the names that `identify` did not
/// contain, without duplicates.
void freeAdded(CellModel& cell, AddedCauses& added);

/// Adds the effects of an explanation, with their fitted values, to the cell's arm, and frees the parameters that the
/// explanation frees. An effect that the model already has is not changed.
AddedCauses addExplanation(const calibration::Explanation& found, CellModel& cell);

}  // namespace tubeplan::app
