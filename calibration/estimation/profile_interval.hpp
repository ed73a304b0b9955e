// The 95 % likelihood-profile interval of one variable: the range over which it can be moved, with all other variables
// refitted, before chi-square rises by more than 3.84.
#pragma once

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

struct ProfileInterval {
  /// Ends of the interval, as values of the variable; an end is infinite if chi-square never rises that far.
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

/// Returns the profile interval of `variable`, an index among the unknowns. `best` is a fit of all unknowns, and
/// `sigma` the variable's standard deviation in that fit. The chi-square includes measurements and priors.
[[nodiscard]] ProfileInterval profileInterval(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                              const std::vector<Measurement>& measurements, const Fit& best,
                                              int variable, double sigma, const StopQuestion& stop = {});

}  // namespace tubeplan::calibration
