// Whether readings say which sizes an effect has, or only that they are among several.
//
// Readings of steps, or of a distance, do not say on which side the tip is. The likelihood of an effect that moves it is
// then a ring, or has several minima, and a fit stops at one of them. The sizes are looked for in every direction anew:
// where others explain the readings as well, the answer is the set of them.
#pragma once

#include <vector>

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// A fit, and which of its unknowns are the sizes of one effect.
struct SizeModesQuestion {
  const PlacedArm& placed;
  const std::vector<Unknown>& unknowns;  ///< 0 at `placed`
  std::vector<std::size_t> sizes;        ///< places among them
  Eigen::VectorXd sigma;                 ///< of each size's variable: what other sizes must differ by thrice
  const std::vector<Measurement>& readings;
  double model_error = 0;  ///< m
  StopQuestion stop = {};
};

struct SizeModes {
  std::vector<PlacedArm> states;            ///< most probable first; fewer than two: the sizes are those that were found
  std::vector<MeasurementKind> decided_by;  ///< of which one reading would tell the first and the last apart
};

/// Unwinds where it was stopped.
[[nodiscard]] SizeModes findSizeModes(const SizeModesQuestion& question);

}  // namespace tubeplan::calibration
