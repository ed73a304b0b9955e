// The 95 % interval of one variable by its profile: the range within which chi-square, with everything else fitted
// again, rises by no more than 3.84.
#pragma once

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

struct ProfileInterval {
  /// Lower end for the variable; infinite if the rise is not reached.
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

/// Returns the interval. `best` is a fit of all unknowns; `sigma` the variable's own at it. The chi-square is that of
/// readings and priors.
[[nodiscard]] ProfileInterval profileInterval(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                              const std::vector<Measurement>& readings, const Fit& best, int variable,
                                              double sigma, const StopQuestion& stop = {});

}  // namespace tubeplan::calibration
