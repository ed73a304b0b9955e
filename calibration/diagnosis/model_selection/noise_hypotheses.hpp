// Noise assumptions under which models compete: the stated noise, and a noise enlarged by the error that remains even
// with the largest discrepancy or the best model. Each assumption includes the columns of all causes and of the
// discrepancy at the measurements, linearised about the baseline.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Returns the log normalisation of the noise density at the measurements, -1/2 log det(2 pi Lambda).
[[nodiscard]] double logDensityOf(const MeasurementWeights& weights);

/// Linearises every cause and the discrepancy about the baseline, for each noise assumption. Returns false if the model
/// cannot be evaluated. Throws WorkStopped on a request to stop.
bool linearize(DiagnosisWork& work);

/// Returns the error of a coordinate [m] that remains with the best fitted model, in excess of the stated noise; 0 if
/// the stated noise explains the residuals. With few measurements an unknown discrepancy can absorb any noise, so the
/// evidence must decide between a discrepancy and a larger noise.
[[nodiscard]] double errorBeyondBest(const DiagnosisWork& work);

/// Adds the assumption that each coordinate has an error `model_error` [m] in addition to the stated noise. Returns
/// false if the model cannot be evaluated.
bool doubtNoise(DiagnosisWork& work, double model_error);

}  // namespace tubeplan::calibration
