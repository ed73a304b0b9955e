// Detection of outliers: measurements whose errors are too large to be noise.
#pragma once

#include <vector>

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// Compares each measurement with its prediction by a fit without that measurement. Returns the outliers, worst first.
/// The limit is chosen such that, with probability `level`, noise alone produces at least one outlier. If most errors
/// exceed the noise, the limit is relative to the typical error. Weight factors of a robust fit are removed first.
[[nodiscard]] std::vector<Outlier> findOutliers(const std::vector<Measurement>& measurements, const Fit& fit,
                                                double level);

}  // namespace tubeplan::calibration
