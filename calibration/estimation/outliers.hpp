// Detection of outliers: readings whose errors are too large to be noise.
#pragma once

#include <vector>

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// Compares each reading with its prediction by a fit without that reading. Returns the outliers, worst first. The
/// limit is chosen such that noise alone produces an outlier anywhere in the set with probability `level`. If most
/// errors exceed the noise, the limit is relative to the typical error instead. Weight factors of a robust fit are
/// undone first.
[[nodiscard]] std::vector<Outlier> findOutliers(const std::vector<Measurement>& readings, const Fit& fit, double level);

}  // namespace tubeplan::calibration
