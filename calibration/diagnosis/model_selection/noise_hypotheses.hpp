// Noise assumptions under which models compete: the stated noise, and a noise enlarged by the error that remains with
// even the largest discrepancy or the best model. Each assumption includes the columns of all causes and of the
// discrepancy at the readings, linearised about the baseline.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Returns the log normalisation of the noise density at the readings, -1/2 log det(2 pi Lambda).
[[nodiscard]] double logDensityOf(const ReadingWeights& weights);

/// Linearises every cause about the baseline. Returns false if the model cannot be evaluated. Throws WorkStopped on a
/// request to stop.
bool linearize(DiagnosisWork& work);

/// Returns the error of a coordinate [m] that the best fitted model leaves beyond the stated noise; 0 if the noise
/// suffices. With few readings an unknown discrepancy absorbs any noise; their evidence has to decide between the two.
[[nodiscard]] double errorBeyondBest(const DiagnosisWork& work);

/// Adds the assumption that the noise of each coordinate is larger than stated by this error [m]. Returns false if the
/// model cannot be evaluated.
bool doubtNoise(DiagnosisWork& work, double model_error);

}  // namespace tubeplan::calibration
