// Readings that a job sets aside before it judges a model: one rule for what compares, and for a ladder of models.
#pragma once

#include <string>
#include <vector>

#include "app/files/reading_input.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// Returns the places of the readings that are off by more than noise explains; none of readings with a mistake in
/// them, which is to be mended first. `fit` is of all readings by `options`, or not run where nothing is free.
[[nodiscard]] std::vector<int> outliersOf(const CellReadings& input, const calibration::Identification& fit,
                                          const calibration::IdentificationOptions& options);

/// The ids of readings at these places.
[[nodiscard]] std::vector<std::string> idsAt(const std::vector<int>& places,
                                             const std::vector<calibration::Measurement>& readings);

}  // namespace tubeplan::app
