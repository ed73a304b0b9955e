// Readings that a job sets aside before it judges a model: one rule for what compares, and for a ladder of models.
#pragma once

#include <functional>
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

/// A fit to the readings that are no outliers.
struct RefitOfReadings {
  std::vector<calibration::Measurement> readings;  ///< all but those set aside
  std::vector<std::string> set_aside;              ///< ids of outliers
  calibration::Identification fit;                 ///< of `readings`; not run where nothing is free
};

/// Fits all readings and, where `outliers` finds places of some by that fit, the others. A fit that is refused is the
/// result.
[[nodiscard]] RefitOfReadings fitWithoutOutliers(
    const std::vector<calibration::Measurement>& readings,
    const std::function<calibration::Identification(const std::vector<calibration::Measurement>&)>& fitted,
    const std::function<std::vector<int>(const calibration::Identification&)>& outliers);

}  // namespace tubeplan::app
