// Whether a misfit still follows the joints smoothly, whatever the law: a test that has power where chi-square over all
// readings has none.
#pragma once

#include "calibration/fit.hpp"

namespace tubeplan::calibration {

struct SmoothMisfit {
  double fall = 0;  ///< of chi-square, by the smooth functions together
  int degrees_of_freedom = 0;
  double p_value = 1;
};

/// Fits what a fit left over (`residual`, with its Jacobian by everything that was free) by errors of each joint that
/// are second and third harmonics of any joint, products of two joints, or a joint's own motion under load, and tells
/// how likely noise alone falls as much.
[[nodiscard]] SmoothMisfit findSmoothMisfit(const PlacedArm& placed, const std::vector<Measurement>& readings,
                                            const ReadingWeights& weights, const WhitenedResidual& residual);

}  // namespace tubeplan::calibration
