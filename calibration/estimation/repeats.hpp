// The noise estimated from the scatter of repeated readings, which does not depend on the model, and a test of whether
// the model's errors exceed this noise.
//
// Repeats may correct the stated noise by a factor of three at most, because a stated noise is known to that accuracy.
// A larger scatter has another cause, such as a row logged twice or a joint with clearance. The model's errors are then
// compared with three times the stated noise.
#pragma once

#include <vector>

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// Largest accepted ratio of the noise estimated from repeats to the stated noise.
inline constexpr double kMostNoiseRatio = 3;

/// Statistics of repeated readings; chi-squares are relative to the stated noise. NaN if nothing was read twice.
struct Repeats {
  int groups = 0;                 ///< number of groups of repeated readings
  int readings = 0;               ///< number of readings in the groups
  double pure_error = kNotKnown;  ///< chi-square of the repeated readings relative to the means of their groups
  int pure_freedom = 0;
  double noise_ratio = kNotKnown;    ///< noise estimated from repeats divided by the stated noise
  double noise_p_value = kNotKnown;  ///< two-sided p-value of the hypothesis that both noises are equal
  /// F statistic of the lack of fit, relative to a noise of at most kMostNoiseRatio times the stated noise.
  double lack_of_fit_F = kNotKnown;
  int lack_freedom = 0;
  double lack_of_fit_p_value = kNotKnown;
};

/// Returns the group number of each reading. Readings of a group have the same set-up, point, position on the tool,
/// load and approach. Their postures agree within the repeatability of encoders and of manual work. Readings of the
/// same point from different postures are no repeats.
[[nodiscard]] std::vector<int> groupRepeats(const std::vector<Measurement>& readings);

/// Evaluates repeats. `error` [m] holds the readings' errors relative to a model; their chi-square is `chi2` with
/// `freedom` degrees of freedom.
[[nodiscard]] Repeats judgeRepeats(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                   const Eigen::VectorXd& error, double chi2, int freedom);

/// Returns true if the repeats reject the stated noise at this significance level. The lack of fit is then tested
/// against the noise of the repeats.
[[nodiscard]] bool disagreesWithStatedNoise(const Repeats& repeats, double level);

/// Returns true if repeated readings differ by more than any plausible noise.
[[nodiscard]] inline bool areBeyondNoise(const Repeats& repeats) {
  return repeats.groups > 0 && repeats.noise_ratio > kMostNoiseRatio;
}

}  // namespace tubeplan::calibration
