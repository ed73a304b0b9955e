// Losses that reduce the weight of readings with large errors: Huber's and Cauchy's (Holland and Welsch 1977, "Robust
// regression using iteratively reweighted least-squares").
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// Returns the weight of each reading by its whitened length relative to the spread of most readings: a model with
/// errors everywhere must not make every reading an outlier. `old`: the factors already included in `weights`; empty:
/// none.
[[nodiscard]] Eigen::VectorXd robustFactors(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                            const WhitenedResidual& residual, const Eigen::VectorXd& old,
                                            RobustLoss loss);

/// Returns the chi-square of a residual reduced by a loss, made comparable with its degrees of freedom.
[[nodiscard]] double comparableChi2(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                    const Eigen::VectorXd& r, RobustLoss loss);

}  // namespace tubeplan::calibration
