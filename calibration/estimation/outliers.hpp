// Readings with errors beyond what noise explains.
#pragma once

#include <vector>

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// Compares each reading with the fit without it, in noise sigmas, and returns those that chance exceeds less often
/// than `level` in the whole set, worst first, as indices of `readings`. If most readings have errors beyond their
/// noise, the scale is that of most errors. A robust fit's weights are removed first.
[[nodiscard]] std::vector<Outlier> findOutliers(const std::vector<Measurement>& readings, const Fit& fit, double level);

}  // namespace tubeplan::calibration
