// Robust losses of Huber and Cauchy, which reduce the weight of measurements with large errors (Holland and Welsch
// 1977, "Robust regression using iteratively reweighted least-squares").
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// Returns the weight factor of each measurement from the length of its whitened residual. Lengths are relative to
/// their typical value, so that a model with errors everywhere does not reduce the weight of every measurement. `old`
/// holds the factors already included in `weights`; empty if none.
[[nodiscard]] Eigen::VectorXd robustFactors(const std::vector<Measurement>& measurements,
                                            const MeasurementWeights& weights, const WhitenedResidual& residual,
                                            const Eigen::VectorXd& old, RobustLoss loss);

/// Returns the chi-square of a residual whose weights include those of a robust loss. It is rescaled so that its
/// expected value is again the number of degrees of freedom.
[[nodiscard]] double comparableChi2(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                                    const Eigen::VectorXd& r, RobustLoss loss);

}  // namespace tubeplan::calibration
