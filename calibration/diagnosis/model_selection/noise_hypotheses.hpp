// Views of the noise under which models compete: the stated one, and one with the error that even the richest or the
// best model leaves. Each has the columns of all causes and of the discrepancy at the readings, linearised about the
// baseline.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Of the noise at the readings: -1/2 log det(2 pi Lambda).
[[nodiscard]] double logDensityOf(const ReadingWeights& weights);

/// Linearises every cause about the baseline. False where the model cannot be evaluated. Unwinds where it was stopped.
bool linearize(DiagnosisWork& work);

/// The error of a coordinate [m] that the best fitted model leaves beyond the stated noise; 0 where the noise is
/// enough. Of few readings an unknown discrepancy takes whatever noise there is: whether it is one, the evidence of
/// both has to say.
[[nodiscard]] double errorBeyondBest(const DiagnosisWork& work);

/// Takes in that the noise may be larger than stated, by this error of each coordinate [m]. False where the model
/// cannot be evaluated.
bool doubtNoise(DiagnosisWork& work, double model_error);

}  // namespace tubeplan::calibration
