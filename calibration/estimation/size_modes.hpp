// All sizes of an effect that explain the readings equally well.
//
// Readings of kind `steps` do not show on which side of the hole the tip is. If an effect moves the tip, the likelihood
// of the effect's sizes is a ring or has several maxima, and a fit stops at one of the maxima. One or two sizes at a
// time are therefore searched again in every direction. All sizes that explain the readings equally well are returned.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// A fit, and the unknowns of the fit that are the sizes of one effect.
struct SizeModesQuestion {
  const PlacedArm& placed;
  const std::vector<Unknown>& unknowns;  ///< variables that are 0 at `placed`
  std::vector<std::size_t> sizes;        ///< indices of the effect's sizes in `unknowns`
  Eigen::VectorXd sigma;                 ///< standard deviation of each size as found; 0 if the size was held
  const std::vector<Measurement>& readings;
  double model_error = 0;  ///< standard deviation of the model error per coordinate [m]
  StopQuestion stop = {};
};

/// Sizes that explain the readings. A step count limits the centring error to an interval whose middle is no likelier
/// than the rest. However often the same count is read, the sizes may lie anywhere within the intervals.
struct SizeMode {
  PlacedArm state;
  /// Value and standard deviation of each size; the latter is 0 for a size not searched.
  Eigen::VectorXd values, sigma;
  /// Limits of each size if all sizes vary in proportion; at least two sigmas from a value that exceeds two sigmas.
  Eigen::VectorXd lower, upper;
  double cost = std::numeric_limits<double>::infinity();  ///< chi-square including priors
  bool is_as_found = false;
};

struct SizeModes {
  std::vector<SizeMode> modes;  ///< most probable first; all explain the readings equally well; empty: not searched
  /// Kinds of measurement of which a single reading would distinguish the first from the last mode.
  std::vector<MeasurementKind> decided_by;
};

/// Searches only if readings of kind `steps` are present; no other kind has this ambiguity. Throws WorkStopped if
/// stopped.
[[nodiscard]] SizeModes findSizeModes(const SizeModesQuestion& question);

/// Returns a phrase such as "one reading of kind position or offset decides", for kinds that would distinguish the
/// sizes.
[[nodiscard]] std::string decidedByText(const std::vector<MeasurementKind>& kinds);

}  // namespace tubeplan::calibration
