// Warnings about effects of a model that the readings do not support: each effect is removed in turn, and the remaining
// model is fitted again.
//
// Every possible replacement competes with the effect, including the effect itself and no replacement
// (competing_models.hpp). An effect that lowers -2 log of the posterior by less than a threshold is not needed: no
// diagnosis would name it. If another model is better by at least the threshold, that model explains the readings
// better.
#pragma once

#include <string>
#include <vector>

#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::calibration {

enum class EffectWarningKind { kNotNeeded, kBetterExplainedBy, kBeyondPlausible, kLackOfFitRemains };

struct EffectWarning {
  EffectWarningKind kind = EffectWarningKind::kNotNeeded;
  std::string effect, at;
  double fall = kNotKnown;  ///< decrease of chi-square due to the effect's parameters
  /// Probability that noise alone decreases chi-square by `fall`; p-value of the fit for kLackOfFitRemains.
  double p_value = kNotKnown;
  bool is_within_noise = false;  ///< true: `Explanation::criterion` is no better with the effect than without it
  bool is_at_neutral = false;    ///< true: all sizes of the effect are within two sigma of neutral
  ErrorSize heldout_with, heldout_without;
  FoundNumber number;  ///< parameter whose value exceeds the largest value of real machines
  double plausible = kNotKnown;
  FoundEffect better;     ///< better explanation, possibly the same effect with another shape
  double by = kNotKnown;  ///< advantage of the better explanation: difference of -2 log of the posterior
};

/// Returns warnings about the effects that an identification fitted from `start` with `options`. Empty if the
/// identification was not completed, or if the work was stopped on request.
[[nodiscard]] std::vector<EffectWarning> warnOfEffects(const PlacedArm& start, const std::vector<Measurement>& readings,
                                                       const IdentificationOptions& options,
                                                       const Identification& fitted);

/// Returns warnings about all effects of a diagnosed model. Empty if the diagnosis was not run, or if the work was
/// stopped on request.
[[nodiscard]] std::vector<EffectWarning> warnOfEffects(const PlacedArm& start, const std::vector<Measurement>& readings,
                                                       const DiagnosisOptions& options, const Diagnosis& diagnosis);

}  // namespace tubeplan::calibration
