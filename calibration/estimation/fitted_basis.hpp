// A completed fit with its residual and derivatives, from which models are compared and further causes of error are
// tested.
#pragma once

#include <vector>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// Measurements of a fit, its optimum, and the residual and derivatives at the optimum.
struct FittedBasis {
  std::vector<Measurement> measurements;  ///< fitted measurements
  PlacedArm fitted;                       ///< placed arm at the optimum of the baseline fit
  std::vector<Unknown> unknowns;          ///< unknowns of the baseline fit, 0 at the optimum
  MeasurementWeights weights;             ///< weights from the stated noise alone
  WhitenedResidual residual;              ///< residual at the optimum, with the Jacobian with respect to `unknowns`
  StopQuestion stop = {};  ///< polled during fits from this basis, which throw WorkStopped once it returns true
};

/// Returns the basis that belongs to the fit `baseline`, with its variables shifted so that they are 0 at the optimum.
[[nodiscard]] FittedBasis basisOf(const Identification& baseline, const std::vector<Measurement>& measurements,
                                  const StopQuestion& stop = {});

}  // namespace tubeplan::calibration
