// Diagnose, add, identify, until nothing more is sure: of a cell and its readings.
#pragma once

#include "app/files/reading_input.hpp"
#include "app/studies/model/improvement.hpp"

namespace tubeplan::app {

/// Nothing is added while a mistake with the readings explains the error. Throws InputError for readings from which
/// nothing can be fitted, JobStopped.
[[nodiscard]] Improvement improveModel(const CellReadings& input, const ImprovementRequest& request,
                                       const WorkHooks& hooks = {});

}  // namespace tubeplan::app
