// Repeated diagnosis, addition and identification for a cell and its measurements, until no further cause is certain.
#pragma once

#include "app/formats/measurements/measurement_input.hpp"
#include "app/studies/model/improvement.hpp"

namespace tubeplan::app {

/// Extends the model with the causes that explain the errors of its measurements. Adds nothing if a mistake in the
/// measurements explains them. Throws InputError for measurements to which the model cannot be fitted, and JobStopped
/// if a stop is requested.
[[nodiscard]] Improvement improveModel(const CellMeasurements& input, const ImprovementRequest& request,
                                       const WorkHooks& hooks = {});

}  // namespace tubeplan::app
