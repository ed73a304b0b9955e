// The noise by what repeated readings differ, whatever the model: pure error, and the lack of fit beyond it.
//
// Repeats may say that the noise is another than was stated, by a factor of three at most: whoever states a noise knows
// it so well. Readings made alike that scatter more are off for another reason, a row logged twice or a joint with
// play, and excuse no model.
#pragma once

#include <limits>
#include <vector>

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

inline constexpr double kMostNoiseRatio = 3;  ///< of the noise by repeats over the stated noise

/// Chi-squares by the stated noise. NaN where nothing was read twice.
struct Repeats {
  int groups = 0;                                                ///< of readings made alike
  int readings = 0;                                              ///< in them
  double pure_error = std::numeric_limits<double>::quiet_NaN();  ///< chi-square about the groups' means
  int pure_freedom = 0;
  double noise_ratio = std::numeric_limits<double>::quiet_NaN();    ///< noise by repeats over the stated noise
  double noise_p_value = std::numeric_limits<double>::quiet_NaN();  ///< two-sided, that both are the same
  double lack_of_fit_F = std::numeric_limits<double>::quiet_NaN();  ///< by a noise of kMostNoiseRatio at most
  int lack_freedom = 0;
  double lack_of_fit_p_value = std::numeric_limits<double>::quiet_NaN();
};

/// Group of each reading: those of one set-up, point, place on the tool, load and approach, at one posture within what
/// encoders and a hand repeat. Readings of one point from different postures are no repeats.
[[nodiscard]] std::vector<int> groupRepeats(const std::vector<Measurement>& readings);

/// `error` [m] of the readings by a model whose lack of fit is `chi2` for `freedom` degrees.
[[nodiscard]] Repeats judgeRepeats(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                   const Eigen::VectorXd& error, double chi2, int freedom);

/// Returns whether the repeats say that the stated noise is wrong, at this level: then lack of fit is judged by them.
[[nodiscard]] bool disagreesWithStatedNoise(const Repeats& repeats, double level);

/// Returns whether repeated readings differ by more than any noise.
[[nodiscard]] inline bool areBeyondNoise(const Repeats& repeats) {
  return repeats.groups > 0 && repeats.noise_ratio > kMostNoiseRatio;
}

}  // namespace tubeplan::calibration
