// Repeated diagnosis, addition and identification for a cell and its readings, until no further cause is certain.
#pragma once

#include "app/formats/measurements/reading_input.hpp"
#include "app/studies/model/improvement.hpp"

namespace tubeplan::app {

/// Extends the model with the causes that explain the errors of its readings. Adds nothing if a mistake in the readings
/// explains them. Throws InputError for readings to which the model cannot be fitted, and JobStopped if a stop is
/// requested.
[[nodiscard]] Improvement improveModel(const CellReadings& input, const ImprovementRequest& request,
                                       const WorkHooks& hooks = {});

}  // namespace tubeplan::app
