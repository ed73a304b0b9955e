// Outliers that a job excludes before it judges a model; comparisons, fits and ladders use the same criterion.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/formats/measurements/reading_input.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// Returns the indices of readings whose errors exceed the noise. Returns none if the readings contain a mistake, which
/// must be corrected first, or if the user accepts all readings as they are. `fit` is the fit of all readings with
/// `options`, or has status "not run" if no parameter is free.
[[nodiscard]] std::vector<int> outliersOf(const CellReadings& input, const calibration::Identification& fit,
                                          const calibration::IdentificationOptions& options);

/// Returns the ids of the readings with the indices `places`.
[[nodiscard]] std::vector<std::string> idsAt(const std::vector<int>& places,
                                             const std::vector<calibration::Measurement>& readings);

/// A fit to the readings without their outliers.
struct RefitOfReadings {
  std::vector<calibration::Measurement> readings;  ///< readings fitted: all except the outliers in `set_aside`
  std::vector<std::string> set_aside;              ///< ids of the readings excluded as outliers
  calibration::Identification fit;                 ///< fit of `readings`; has status "not run" if no parameter is free
};

/// Fits all readings with the function `fitted`. Returns this fit if it is refused; otherwise fits again without the
/// readings whose indices `outliers` returns, if any.
[[nodiscard]] RefitOfReadings fitWithoutOutliers(
    const std::vector<calibration::Measurement>& readings,
    const std::function<calibration::Identification(const std::vector<calibration::Measurement>&)>& fitted,
    const std::function<std::vector<int>(const calibration::Identification&)>& outliers);

}  // namespace tubeplan::app
