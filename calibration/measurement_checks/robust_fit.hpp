// Fit of a model within its priors that is robust against gross errors of single measurements and takes milliseconds.
// Errors have Student's t distribution with four degrees of freedom and an unknown scale, at least as large as the
// noise (Lange, Little and Taylor 1989, "Robust statistical modeling using the t distribution"). The maximum is found
// by weighted Gauss-Newton steps.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "calibration/hooks.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

inline constexpr double kStudentFreedom = 4;

struct RobustFit {
  bool ok = false;
  PlacedArm placed;
  double lack_of_fit = std::numeric_limits<double>::infinity();  ///< -log(likelihood x priors), without constants
  /// Root-mean-square error of the nine tenths of the measurements with the smallest errors [m].
  double error = std::numeric_limits<double>::infinity();
  double whole_error = error;  ///< root-mean-square error of all measurements [m]
  /// Chi-square per degree of freedom of the same nine tenths, relative to the stated noise; NaN if not computed.
  double chi2_per_freedom = kNotKnown;
};

struct RobustFitOptions {
  FreeChoice free;
  int most_steps = 8;
  bool judges_noise = false;  ///< true if chi2_per_freedom is computed
  StopQuestion stop = {};
};

/// Returns the weight of a measurement under Student's t distribution, from the squared length `square` of its whitened
/// error and the square `variance` of the scale.
[[nodiscard]] inline double studentWeight(double square, int rows, double variance) {
  return (kStudentFreedom + rows) / (kStudentFreedom + square / variance);
}

/// Fits the free parameters, starting from the base poses that best align the predicted tips with the measured
/// positions. Throws WorkStopped if `options.stop` requests a stop.
[[nodiscard]] RobustFit fitRobustly(PlacedArm start, const std::vector<Measurement>& measurements,
                                    const RobustFitOptions& options);

}  // namespace tubeplan::calibration
