// A fit in the form that comparison and diagnosis need: one examines its residual, the other adds to it.
#pragma once

#include <vector>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// The readings and the optimum of a fit, with its derivatives.
struct FittedBasis {
  std::vector<Measurement> readings;  ///< readings in use
  PlacedArm fitted;                   ///< the baseline at its optimum
  std::vector<Unknown> unknowns;      ///< unknowns of the baseline, 0 at its optimum
  ReadingWeights weights;             ///< weights from the stated noise
  WhitenedResidual residual;          ///< residual at the optimum, with the Jacobian by `unknowns`
  StopQuestion stop = {};             ///< called within fits, which throw WorkStopped if it returns true
};

/// Returns the basis of a baseline fit, with its variables shifted so that 0 is the optimum.
[[nodiscard]] FittedBasis basisOf(const Identification& baseline, const std::vector<Measurement>& readings,
                                  const StopQuestion& stop = {});

}  // namespace tubeplan::calibration
