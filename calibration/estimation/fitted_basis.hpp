// A fit as others go on from it: a comparison looks at what it leaves, a diagnosis adds to it.
#pragma once

#include <vector>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// The readings and the optimum, with its derivatives.
struct FittedBasis {
  std::vector<Measurement> readings;  ///< those in use
  PlacedArm fitted;                   ///< the baseline at its optimum
  std::vector<Unknown> unknowns;      ///< of the baseline, 0 at its optimum
  ReadingWeights weights;             ///< by the stated noise
  WhitenedResidual residual;          ///< at the optimum, with the Jacobian by `unknowns`
  StopQuestion stop = {};             ///< asked within fits, which unwind where the answer is yes
};

/// The variables of a baseline's unknowns, moved so that 0 is its optimum.
[[nodiscard]] FittedBasis basisOf(const Identification& baseline, const std::vector<Measurement>& readings,
                                  const StopQuestion& stop = {});

}  // namespace tubeplan::calibration
