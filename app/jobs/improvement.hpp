// Repeated diagnosis, addition and identification, until no further cause is certain: for a cell and its readings.
#pragma once

#include "app/formats/measurements/reading_input.hpp"
#include "app/studies/model/improvement.hpp"

namespace tubeplan::app {

/// Improves the model. Nothing is added while a mistake in the readings explains the error. Throws InputError for
/// readings from which nothing can be fitted, JobStopped.
[[nodiscard]] Improvement improveModel(const CellReadings& input, const ImprovementRequest& request,
                                       const WorkHooks& hooks = {});

}  // namespace tubeplan::app
