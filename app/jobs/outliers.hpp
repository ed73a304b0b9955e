// Outliers that a job excludes before it judges a model; comparisons, fits and ladders use the same criterion.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/formats/measurements/measurement_input.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// Returns the indices of measurements whose errors exceed the noise. Returns none if the measurements contain a
/// mistake, which must be corrected first, or if the user accepts all measurements unchanged. `fit` is the fit of all
/// measurements with `options`, or has status "not run" if no parameter is free.
[[nodiscard]] std::vector<int> outliersOf(const CellMeasurements& input, const calibration::Identification& fit,
                                          const calibration::IdentificationOptions& options);

/// Returns the ids of the measurements with the indices `places`.
[[nodiscard]] std::vector<std::string> idsAt(const std::vector<int>& places,
                                             const std::vector<calibration::Measurement>& measurements);

/// A fit to the measurements without their outliers.
struct RefitOfMeasurements {
  std::vector<calibration::Measurement> measurements;  ///< measurements fitted: all except the outliers in `set_aside`
  std::vector<std::string> set_aside;                  ///< ids of the measurements excluded as outliers
  calibration::Identification fit;  ///< fit of `measurements`; has status "not run" if no parameter is free
};

/// Fits all measurements with the function `fitted`. If the fit is not refused, repeats it without the measurements
/// whose indices `outliers` returns, if there are any.
[[nodiscard]] RefitOfMeasurements fitWithoutOutliers(
    const std::vector<calibration::Measurement>& measurements,
    const std::function<calibration::Identification(const std::vector<calibration::Measurement>&)>& fitted,
    const std::function<std::vector<int>(const calibration::Identification&)>& outliers);

}  // namespace tubeplan::app
