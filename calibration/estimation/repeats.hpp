// The noise from differences of repeated readings, independent of the model: pure error, and the lack of fit beyond it.
//
// Repeats may correct the stated noise by a factor of three at most, because a stated noise is known that well.
// Repeated readings that scatter more have another error, such as a row logged twice or a joint with clearance, and do
// not excuse the model.
#pragma once

#include <vector>

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

inline constexpr double kMostNoiseRatio = 3;  ///< largest ratio of the noise by repeats to the stated noise

/// Statistics of repeated readings, with chi-squares by the stated noise. NaN if nothing was read twice.
struct Repeats {
  int groups = 0;                 ///< of readings made alike
  int readings = 0;               ///< in them
  double pure_error = kNotKnown;  ///< chi-square about the groups' means
  int pure_freedom = 0;
  double noise_ratio = kNotKnown;    ///< noise by repeats over the stated noise
  double noise_p_value = kNotKnown;  ///< two-sided, that both are the same
  double lack_of_fit_F = kNotKnown;  ///< by a noise of kMostNoiseRatio at most
  int lack_freedom = 0;
  double lack_of_fit_p_value = kNotKnown;
};

/// Returns the group of each reading. A group has the same set-up, point, place on the tool, load and approach, at one
/// posture within the repeatability of encoders and of manual work. Readings of one point from different postures are
/// no repeats.
[[nodiscard]] std::vector<int> groupRepeats(const std::vector<Measurement>& readings);

/// Judges repeats. `error` [m] are the readings' errors by a model whose lack of fit is `chi2` for `freedom` degrees.
[[nodiscard]] Repeats judgeRepeats(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                   const Eigen::VectorXd& error, double chi2, int freedom);

/// Returns true if the repeats reject the stated noise at this level; lack of fit is then judged by them.
[[nodiscard]] bool disagreesWithStatedNoise(const Repeats& repeats, double level);

/// Returns true if repeated readings differ by more than any noise.
[[nodiscard]] inline bool areBeyondNoise(const Repeats& repeats) {
  return repeats.groups > 0 && repeats.noise_ratio > kMostNoiseRatio;
}

}  // namespace tubeplan::calibration
