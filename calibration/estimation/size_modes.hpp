// Search for all magnitudes ("sizes") of an effect that explain the measurements equally well.
//
// Measurements of kind `steps` do not reveal on which side of the hole axis the tip is. The likelihood of the sizes of
// an effect that moves the tip therefore has several maxima, or a ring of them, and a fit finds only one of these. To
// find the others, one or two sizes at a time are searched again in every direction.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// Input of the search: a fit, and which of its unknowns are sizes of the effect.
struct SizeModesQuestion {
  const PlacedArm& placed;
  const std::vector<Unknown>& unknowns;  ///< unknowns of the fit, whose variables are 0 at `placed`
  std::vector<std::size_t> sizes;        ///< indices of the effect's sizes in `unknowns`
  Eigen::VectorXd sigma;                 ///< standard deviation of each size in the fit; 0 if the size was held fixed
  const std::vector<Measurement>& measurements;
  double model_error = 0;  ///< standard deviation of the model error per coordinate [m]
  StopQuestion stop = {};
};

/// A set of sizes that explains the measurements, with limits. A step count limits the centring error to an interval,
/// within which all values are equally likely. Repeating the same count therefore does not shrink the limits.
struct SizeMode {
  PlacedArm state;
  /// Value and standard deviation of each size; the standard deviation is 0 for a size that was not searched.
  Eigen::VectorXd values, sigma;
  /// Limits of each size when all sizes are varied in proportion. If a value exceeds two sigmas, its limits are at
  /// least two sigmas away from it.
  Eigen::VectorXd lower, upper;
  double cost = std::numeric_limits<double>::infinity();  ///< chi-square including priors
  bool is_as_found = false;
};

struct SizeModes {
  /// Sets of sizes that explain the measurements equally well, most probable first; empty if the search was not run.
  std::vector<SizeMode> modes;
  /// Kinds of measurement for which a single measurement would distinguish the first mode from the last one.
  std::vector<MeasurementKind> decided_by;
};

/// Returns the modes of the effect's sizes. Searches only if there are measurements of kind `steps`, because no other
/// kind has this ambiguity. Throws WorkStopped if a stop is requested.
[[nodiscard]] SizeModes findSizeModes(const SizeModesQuestion& question);

/// Returns a phrase such as "one measurement of kind position or offset decides" for SizeModes::decided_by.
[[nodiscard]] std::string decidedByText(const std::vector<MeasurementKind>& kinds);

}  // namespace tubeplan::calibration
