// Identification options for tests: free parameters by name, without cross-validation and profile intervals.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

inline IdentificationOptions freeing(const std::vector<std::string>& names) {
  IdentificationOptions options;
  options.free.names = names;
  options.folds = 0;
  options.intervals_by_profile = false;
  return options;
}

/// Returns options that free the named parameters without priors, for exact measurements of an arm that differs much
/// from its file.
inline IdentificationOptions freeingBlindly(const std::vector<std::string>& names) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  IdentificationOptions options = freeing(names);
  options.free.priors = {kNone, kNone, kNone, kNone, kNone, {}};
  return options;
}

}  // namespace tubeplan::calibration
