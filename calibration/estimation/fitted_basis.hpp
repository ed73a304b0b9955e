// A fit in the form needed by comparison, which examines the residual, and by diagnosis, which adds further causes.
#pragma once

#include <vector>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// The readings and the optimum of a fit, with derivatives.
struct FittedBasis {
  std::vector<Measurement> readings;  ///< fitted readings
  PlacedArm fitted;                   ///< placed arm at the optimum of the baseline fit
  std::vector<Unknown> unknowns;      ///< unknowns of the baseline fit, 0 at the optimum
  ReadingWeights weights;             ///< weights from the stated noise alone
  WhitenedResidual residual;          ///< residual at the optimum, with the Jacobian with respect to `unknowns`
  StopQuestion stop = {};             ///< called within fits, which throw WorkStopped once it returns true
};

/// Returns the basis of a baseline fit, with the variables shifted so that 0 is the optimum.
[[nodiscard]] FittedBasis basisOf(const Identification& baseline, const std::vector<Measurement>& readings,
                                  const StopQuestion& stop = {});

}  // namespace tubeplan::calibration
