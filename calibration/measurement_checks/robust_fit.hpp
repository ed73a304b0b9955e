// A small fit that gross errors of single readings do not carry away: what readings leave of a model within its priors,
// in milliseconds. Errors are taken as Student's t of four degrees of freedom about an unknown scale, at least that of
// the noise (Lange, Little and Taylor 1989, "Robust statistical modeling using the t distribution"); the maximum by
// weighted Gauss-Newton steps.
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
  double lack_of_fit = std::numeric_limits<double>::infinity();  ///< -log of likelihood and priors, but for constants
  double error = std::numeric_limits<double>::infinity();  ///< m, root mean square of the nine tenths that fit best
  double whole_error = error;                              ///< m, root mean square of all
  double chi2_per_freedom = kNotKnown;                     ///< of these by the stated noise
};

struct RobustFitOptions {
  FreeChoice free;
  int most_steps = 8;
  bool judges_noise = false;  ///< whether chi2_per_freedom is asked for
  StopQuestion stop = {};
};

/// Returns the weight of a reading by Student's t, from the square of its whitened error and the scale's variance.
[[nodiscard]] inline double studentWeight(double square, int rows, double variance) {
  return (kStudentFreedom + rows) / (kStudentFreedom + square / variance);
}

/// From the bases that align the tips best; unwinds where it is stopped.
[[nodiscard]] RobustFit fitRobustly(PlacedArm start, const std::vector<Measurement>& readings,
                                    const RobustFitOptions& options);

}  // namespace tubeplan::calibration
