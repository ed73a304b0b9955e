// Model-independent estimate of the noise from the scatter of repeated measurements, and a test of whether the model's
// errors exceed this noise.
//
// The estimate may correct the stated noise by a factor of three at most, because users can state their noise to that
// accuracy. A larger scatter must have another cause, such as clearance in a joint; the model's errors are then
// compared with three times the stated noise.
#pragma once

#include <vector>

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// Largest accepted ratio of the noise estimated from repeats to the stated noise.
inline constexpr double kMostNoiseRatio = 3;

/// Statistics of repeated measurements. Chi-squares are relative to the stated noise; values are NaN if no measurement
/// was repeated.
struct Repeats {
  int groups = 0;                 ///< number of groups of repeated measurements
  int measurements = 0;           ///< number of measurements in the groups
  double pure_error = kNotKnown;  ///< chi-square of the repeated measurements relative to the means of their groups
  int pure_freedom = 0;
  double noise_ratio = kNotKnown;    ///< noise estimated from repeats divided by the stated noise
  double noise_p_value = kNotKnown;  ///< two-sided p-value of the hypothesis that the stated noise is right
  /// F statistic of the lack of fit, relative to a noise of at most kMostNoiseRatio times the stated noise.
  double lack_of_fit_F = kNotKnown;
  int lack_freedom = 0;
  double lack_of_fit_p_value = kNotKnown;
};

/// Returns the group number of each measurement. Measurements are repeats, and share a group, if they agree in kind,
/// set-up, point, position on the tool, load and approach, and if their joint readings agree as closely as a posture
/// can be repeated by hand. Measurements of the same point in different postures are not repeats.
[[nodiscard]] std::vector<int> groupRepeats(const std::vector<Measurement>& measurements);

/// Compares the scatter of repeated measurements with the stated noise and with the measurements' errors `error` [m]
/// relative to a fitted model, whose chi-square is `chi2` with `freedom` degrees of freedom.
[[nodiscard]] Repeats judgeRepeats(const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                                   const Eigen::VectorXd& error, double chi2, int freedom);

/// Returns true if, at this significance level, the scatter of the repeats contradicts the stated noise. The lack of
/// fit is then tested against the noise estimated from the repeats.
[[nodiscard]] bool disagreesWithStatedNoise(const Repeats& repeats, double level);

/// Returns true if repeated measurements scatter by more than kMostNoiseRatio times the stated noise, so that noise
/// cannot be the cause.
[[nodiscard]] inline bool areBeyondNoise(const Repeats& repeats) {
  return repeats.groups > 0 && repeats.noise_ratio > kMostNoiseRatio;
}

}  // namespace tubeplan::calibration
