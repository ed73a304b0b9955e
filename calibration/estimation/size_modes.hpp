// All sizes of an effect that explain readings equally.
//
// Readings of steps do not show on which side the tip is. The likelihood of an effect that moves it is then a ring, or
// has several minima, and a fit stops at one of them. One or two sizes at a time are searched in every direction
// again: if others explain the readings as well, the answer is the set of them.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// A fit, and those of its unknowns that are the sizes of one effect.
struct SizeModesQuestion {
  const PlacedArm& placed;
  const std::vector<Unknown>& unknowns;  ///< variables that are 0 at `placed`
  std::vector<std::size_t> sizes;        ///< indices in `unknowns`
  Eigen::VectorXd sigma;                 ///< sigma of each size as found; 0 if it was held
  const std::vector<Measurement>& readings;
  double model_error = 0;  ///< [m]
  StopQuestion stop = {};
};

/// Sizes that explain the readings. A count of steps limits the centring error to an interval, and does not mean its
/// middle: however often the same count is read, the sizes may be anything within the intervals.
struct SizeMode {
  PlacedArm state;
  Eigen::VectorXd values, sigma;  ///< value and sigma of each size; sigma is 0 if it has no effect
  Eigen::VectorXd lower, upper;   ///< limits of each size, all in proportion; two sigmas at least
  double cost = std::numeric_limits<double>::infinity();  ///< chi-square with priors
  bool is_as_found = false;
};

struct SizeModes {
  std::vector<SizeMode> modes;              ///< most probable first, all equally good; none: not searched
  std::vector<MeasurementKind> decided_by;  ///< kinds of which one reading would distinguish the first and the last
};

/// Searches if readings of steps are present; no other kind has this ambiguity. Throws WorkStopped if it was stopped.
[[nodiscard]] SizeModes findSizeModes(const SizeModesQuestion& question);

/// Returns "one reading of kind position or offset decides", for kinds that would distinguish the sizes.
[[nodiscard]] std::string decidedByText(const std::vector<MeasurementKind>& kinds);

}  // namespace tubeplan::calibration
