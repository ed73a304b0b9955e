// The 95 % likelihood-profile interval of one variable: the range within which chi-square, with all other variables
// fitted again, rises by no more than 3.84.
#pragma once

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

struct ProfileInterval {
  /// Ends of the interval of the variable; infinite where chi-square never rises that far.
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

/// Returns the profile interval of `variable`, an index among the unknowns. `best` is a fit of all unknowns, and
/// `sigma` the variable's standard deviation in that fit. The chi-square includes readings and priors.
[[nodiscard]] ProfileInterval profileInterval(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                              const std::vector<Measurement>& readings, const Fit& best, int variable,
                                              double sigma, const StopQuestion& stop = {});

}  // namespace tubeplan::calibration
