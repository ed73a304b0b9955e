// Errors that repeat at equal joint readings, under other loads, from other approach directions or at other times. Such
// errors depend on the joints, though not as a smooth function of a few of them (discrepancy.hpp), so they are not
// scatter.
#pragma once

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// One-way analysis of variance of the errors over postures (Fisher 1925; Searle, Casella and McCulloch 1992).
struct SamePosture {
  int postures = 0;  ///< number of postures with two or more measurements
  double share = 0;  ///< fraction of the errors' variance that is common to all measurements of a posture
  /// Probability that chance alone gives a fraction this large; NaN if fewer than two postures were repeated.
  double p_value = kNotKnown;

  /// Returns true if chance cannot explain the common fraction (p < 1e-4).
  [[nodiscard]] bool isSignificant() const { return p_value < 1e-4; }
};

/// Analyses the errors of positions measured in the world frame; `whitened` is the residual of a model.
[[nodiscard]] SamePosture judgeSamePosture(const std::vector<Measurement>& measurements,
                                           const MeasurementWeights& weights, const Eigen::VectorXd& whitened);

}  // namespace tubeplan::calibration
