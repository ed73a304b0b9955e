// Errors that repeat at equal joint readings, under other loads, from other directions or at other times. Their cause
// follows the joints, though by no smooth function of a few (discrepancy.hpp): they are not scatter.
#pragma once

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// One-way analysis of variance of the errors over postures (Fisher 1925; Searle, Casella and McCulloch 1992).
struct SamePosture {
  int postures = 0;            ///< number of postures with two or more readings
  double share = 0;            ///< share of the errors' variance that is common to a posture
  double p_value = kNotKnown;  ///< probability of such a share by chance; NaN: no posture was repeated

  /// Returns true if chance is no explanation (p < 1e-4).
  [[nodiscard]] bool isSure() const { return p_value < 1e-4; }
};

/// Judges the errors of positions read in the world frame; `whitened` is the residual of a model.
[[nodiscard]] SamePosture judgeSamePosture(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                           const Eigen::VectorXd& whitened);

}  // namespace tubeplan::calibration
