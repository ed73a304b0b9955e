// Losses that weigh readings down which are far off: Huber's and Cauchy's (Holland and Welsch 1977, "Robust regression
// using iteratively reweighted least-squares").
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// Weight of each reading by its whitened length, against the spread of most readings: a model that is off everywhere
/// must not make every reading an outlier. `old`: the weights that are within `weights` already; empty: none.
[[nodiscard]] Eigen::VectorXd robustFactors(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                            const WhitenedResidual& residual, const Eigen::VectorXd& old,
                                            RobustLoss loss);

/// Chi-square of a whitened residual of which a loss has left a share, made comparable with its degrees of freedom.
[[nodiscard]] double comparableChi2(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                    const Eigen::VectorXd& r, RobustLoss loss);

}  // namespace tubeplan::calibration
