// Readings that a job sets aside before it judges a model: one rule for comparisons, and for a ladder of models.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/formats/measurements/reading_input.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// Returns the indices of the readings with errors beyond the noise; none if the readings hold a mistake, which is to
/// be corrected first. `fit` is of all readings by `options`, or not run if nothing is free.
[[nodiscard]] std::vector<int> outliersOf(const CellReadings& input, const calibration::Identification& fit,
                                          const calibration::IdentificationOptions& options);

/// Returns the ids of the readings with these indices.
[[nodiscard]] std::vector<std::string> idsAt(const std::vector<int>& places,
                                             const std::vector<calibration::Measurement>& readings);

/// A fit to the readings that are no outliers.
struct RefitOfReadings {
  std::vector<calibration::Measurement> readings;  ///< all but those set aside
  std::vector<std::string> set_aside;              ///< ids of outliers
  calibration::Identification fit;                 ///< fit of `readings`; not run if nothing is free
};

/// Fits all readings and, if `outliers` finds indices of some by that fit, the others. A fit that is refused is the
/// result.
[[nodiscard]] RefitOfReadings fitWithoutOutliers(
    const std::vector<calibration::Measurement>& readings,
    const std::function<calibration::Identification(const std::vector<calibration::Measurement>&)>& fitted,
    const std::function<std::vector<int>(const calibration::Identification&)>& outliers);

}  // namespace tubeplan::app
