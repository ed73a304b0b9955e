// Fit that is robust against gross errors of single readings and takes milliseconds: the errors of a model within its
// priors. Errors have Student's t distribution with four degrees of freedom about an unknown scale, at least that of
// the noise (Lange, Little and Taylor 1989, "Robust statistical modeling using the t distribution"). The maximum is
// found by weighted Gauss-Newton steps.
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
  double lack_of_fit = std::numeric_limits<double>::infinity();  ///< -log of likelihood and priors, without constants
  double error = std::numeric_limits<double>::infinity();        ///< root mean square of the best nine tenths [m]
  double whole_error = error;                                    ///< root mean square of all [m]
  /// Chi-square per degree of freedom of the best nine tenths, for the stated noise.
  double chi2_per_freedom = kNotKnown;
};

struct RobustFitOptions {
  FreeChoice free;
  int most_steps = 8;
  bool judges_noise = false;  ///< true: chi2_per_freedom is computed
  StopQuestion stop = {};
};

/// Returns the weight of a reading by Student's t, from the square of its whitened error and the variance of the scale.
[[nodiscard]] inline double studentWeight(double square, int rows, double variance) {
  return (kStudentFreedom + rows) / (kStudentFreedom + square / variance);
}

/// Fits from the bases that align the tips best. Throws WorkStopped on a request to stop.
[[nodiscard]] RobustFit fitRobustly(PlacedArm start, const std::vector<Measurement>& readings,
                                    const RobustFitOptions& options);

}  // namespace tubeplan::calibration
