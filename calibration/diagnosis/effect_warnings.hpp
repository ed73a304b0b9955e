// Warnings about effects of a model that the measurements do not support. Each effect is removed, one at a time, and
// the remaining model is refitted.
//
// The model without the effect competes with models that contain the effect itself, or another cause in its place
// (competing_models.hpp). An effect that lowers -2 log of the posterior by less than a threshold is not needed. If the
// model with another cause is better by at least the threshold, that cause explains the measurements better.
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
  bool is_within_noise = false;  ///< true if `Explanation::criterion` is no better with the effect than without it
  bool is_at_neutral = false;    ///< true if all parameters are within two standard deviations of neutral
  ErrorSize heldout_with, heldout_without;
  FoundNumber number;  ///< parameter that exceeds the largest value found on real machines
  double plausible = kNotKnown;
  FoundEffect better;  ///< better explanation, possibly the same effect with another scanned value
  /// Advantage of the better explanation: difference of -2 log of the posterior, or of chi-square for the same effect.
  double by = kNotKnown;
};

/// Returns warnings about the effects that an identification fitted from `start` with `options`. Empty if the
/// identification was not completed, or if the work was stopped on request.
[[nodiscard]] std::vector<EffectWarning> warnOfEffects(const PlacedArm& start,
                                                       const std::vector<Measurement>& measurements,
                                                       const IdentificationOptions& options,
                                                       const Identification& fitted);

/// Returns warnings about all effects of a diagnosed model. Empty if the diagnosis was not run, or if the work was
/// stopped on request.
[[nodiscard]] std::vector<EffectWarning> warnOfEffects(const PlacedArm& start,
                                                       const std::vector<Measurement>& measurements,
                                                       const DiagnosisOptions& options, const Diagnosis& diagnosis);

}  // namespace tubeplan::calibration
