// Readings that are off by more than noise explains.
#pragma once

#include <vector>

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// Each reading against the fit without it, in noise sigmas; those that chance exceeds less often than `level` in the
/// whole set are named, the worst first, as indices of `readings`. Where most readings are off by more than their noise
/// the measure is what most are off by. A robust fit's weights are taken off.
[[nodiscard]] std::vector<Outlier> findOutliers(const std::vector<Measurement>& readings, const Fit& fit, double level);

}  // namespace tubeplan::calibration
