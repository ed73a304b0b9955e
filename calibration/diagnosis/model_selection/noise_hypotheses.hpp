// Noise assumptions under which models compete: the stated noise, and one with the error that even the richest or the
// best model leaves. Each has the columns of all causes and of the discrepancy at the readings, linearised about the
// baseline.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Returns the log density of the whitening at the readings, -1/2 log det(2 pi Lambda).
[[nodiscard]] double logDensityOf(const ReadingWeights& weights);

/// Linearises every cause about the baseline. Returns false if the model cannot be evaluated. Throws WorkStopped on a
/// request to stop.
bool linearize(DiagnosisWork& work);

/// Returns the error of a coordinate [m] that the best fitted model leaves beyond the stated noise; 0 if the noise
/// suffices. With few readings an unknown discrepancy absorbs any noise; the evidence of both has to decide between
/// them.
[[nodiscard]] double errorBeyondBest(const DiagnosisWork& work);

/// Adds the assumption that the noise is larger than stated, by this error of each coordinate [m]. Returns false if the
/// model cannot be evaluated.
bool doubtNoise(DiagnosisWork& work, double model_error);

}  // namespace tubeplan::calibration
