// From competing models to what may be said: their probabilities, causes that are the same under several names, and the
// verdict.
#pragma once

#include "calibration/diagnosis/competing_models.hpp"

namespace tubeplan::calibration {

/// Models with the same causes, whatever noise and discrepancy they have beside; causes that no reading could tell
/// apart count as the same.
struct ModelClass {
  Explanation explanation;  ///< of its most probable model
  std::vector<int> causes;
  double probability = 0;
  double remainder_probability = 0;
  double scatter_probability = 0;         ///< that the noise is larger than stated, and nothing else remains
  const CompetingModel* model = nullptr;  ///< the most probable
};

struct Posterior {
  double nothing = 0;               ///< that nothing is missing
  double unknown = 0;               ///< that something is that follows the readings, and no cause is part of it
  double scatter = 0;               ///< that something is, and follows nothing that the readings state
  std::vector<ModelClass> classes;  ///< with causes, most probable first; those that were fitted
  std::vector<ModelClass> others;   ///< the less probable ones that were not
  ModelClass sure;                  ///< the causes that are sure, whatever there is beside; empty where none is
  CompetingModel sure_model;        ///< of `sure`
};

/// `work.models` must be found. Fits the model of the causes that are sure. Unwinds where it was stopped.
[[nodiscard]] Posterior posteriorOf(const DiagnosisWork& work);

/// Fills verdict and alternatives.
void decide(const DiagnosisOptions& options, const Posterior& posterior, Diagnosis& result);

/// Fills `ranking`.
void rankCauses(const DiagnosisWork& work, Diagnosis& result);

/// Fills `detectable`.
void listDetectable(const DiagnosisWork& work, Diagnosis& result);

/// What is left beside a model's causes, and what it follows.
[[nodiscard]] Remainder remainderOf(const DiagnosisWork& work, const CompetingModel& model);

}  // namespace tubeplan::calibration
