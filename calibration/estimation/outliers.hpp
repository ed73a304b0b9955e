// Detection of readings with larger errors than noise explains.
#pragma once

#include <vector>

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// Compares each reading with the fit without that reading, in units of noise. Returns the readings with errors so
/// large that noise would cause one anywhere in the set with a probability below `level`; worst first, as indices into
/// `readings`. If most errors exceed the noise, they are compared with the typical error instead. The weights of a
/// robust fit are removed first.
[[nodiscard]] std::vector<Outlier> findOutliers(const std::vector<Measurement>& readings, const Fit& fit, double level);

}  // namespace tubeplan::calibration
