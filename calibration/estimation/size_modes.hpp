// All sizes of an effect that explain readings equally.
//
// Readings of steps do not say on which side the tip is. The likelihood of an effect that moves it is then a ring, or
// has several minima, and a fit stops at one of them. One or two sizes at a time are looked for in every direction
// anew: where others explain the readings as well, the answer is the set of them.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// A fit, and which of its unknowns are the sizes of one effect.
struct SizeModesQuestion {
  const PlacedArm& placed;
  const std::vector<Unknown>& unknowns;  ///< 0 at `placed`
  std::vector<std::size_t> sizes;        ///< places among them
  Eigen::VectorXd sigma;                 ///< of each size as found; 0 where it was held
  const std::vector<Measurement>& readings;
  double model_error = 0;  ///< m
  StopQuestion stop = {};
};

/// Sizes that explain the readings. A count of steps says between which tolerances a tip is, not that it is half way:
/// however often the same count is read, the sizes may be anything that leaves the tips between them.
struct SizeMode {
  PlacedArm state;
  Eigen::VectorXd values, sigma;                          ///< of each size; sigma is 0 where it does nothing
  Eigen::VectorXd lower, upper;                           ///< of each size, all in proportion; two sigmas at least
  double cost = std::numeric_limits<double>::infinity();  ///< chi-square with priors
  bool is_as_found = false;
};

struct SizeModes {
  std::vector<SizeMode> modes;              ///< most probable first, all as good as it; none: not asked
  std::vector<MeasurementKind> decided_by;  ///< of which one reading would tell the first and the last apart
};

/// Looks where readings of steps are among them: no other kind is even in the error. Unwinds where it was stopped.
[[nodiscard]] SizeModes findSizeModes(const SizeModesQuestion& question);

/// Returns "one reading of kind position or offset decides": what tells sizes apart that these kinds would.
[[nodiscard]] std::string decidedByText(const std::vector<MeasurementKind>& kinds);

}  // namespace tubeplan::calibration
