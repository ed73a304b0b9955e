// Errors that repeat wherever the joints stand alike, under other loads, from other directions or at other times. What
// makes them follows the joints, though by no smooth function of few (discrepancy.hpp): it is no scatter.
#pragma once

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// One-way analysis of variance of the errors over postures (Fisher 1925; Searle, Casella and McCulloch 1992).
struct SamePosture {
  int postures = 0;            ///< at which two or more readings were made
  double share = 0;            ///< of the errors' variance, that is one for a posture
  double p_value = kNotKnown;  ///< of as much by chance; NaN: no posture was kept

  /// So that chance is no reason for it.
  [[nodiscard]] bool isSure() const { return p_value < 1e-4; }
};

/// Of places read in the world; `whitened` is the residual of a model.
[[nodiscard]] SamePosture judgeSamePosture(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                           const Eigen::VectorXd& whitened);

}  // namespace tubeplan::calibration
