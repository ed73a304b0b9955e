// Detection of readings with larger errors than noise explains.
#pragma once

#include <vector>

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// Compares each reading with the fit without that reading, in units of noise. Returns the readings whose error chance
/// would exceed with a probability below `level` in the whole set, worst first, as indices into `readings`. If most
/// readings have errors beyond their noise, the errors are scaled by the typical error. The weights of a robust fit are
/// removed first.
[[nodiscard]] std::vector<Outlier> findOutliers(const std::vector<Measurement>& readings, const Fit& fit, double level);

}  // namespace tubeplan::calibration
