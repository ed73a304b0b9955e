// Warnings for effects of a model that the readings do not need: each effect is taken out, and the rest is fitted
// again.
//
// Every possible replacement competes with it, including the effect itself and nothing (competing_models.hpp). An
// effect that lowers -2 log of the posterior by less than the gap is not needed: no diagnosis would name it. If another
// model is better by the gap, that one explains the readings better.
#pragma once

#include <string>
#include <vector>

#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::calibration {

enum class EffectWarningKind { kNotNeeded, kBetterExplainedBy, kBeyondPlausible, kLackOfFitRemains };

struct EffectWarning {
  EffectWarningKind kind = EffectWarningKind::kNotNeeded;
  std::string effect, at;
  double fall = kNotKnown;       ///< fall of chi-square by the effect's numbers
  double p_value = kNotKnown;    ///< probability of that fall by noise alone; for a remaining lack of fit, its p-value
  bool is_within_noise = false;  ///< true: the criterion is no better with the effect than without it
  bool is_at_neutral = false;    ///< true: all its sizes are within two sigma of neutral
  ErrorSize heldout_with, heldout_without;
  FoundNumber number;  ///< number beyond the size of any real machine
  double plausible = kNotKnown;
  FoundEffect better;     ///< better explanation, possibly the same effect with another shape
  double by = kNotKnown;  ///< difference of -2 log of the posterior
};

/// Returns warnings for the effects that an identification fitted from `start` with `options`. Empty if it was not
/// done, or on a request to stop.
[[nodiscard]] std::vector<EffectWarning> warnOfEffects(const PlacedArm& start, const std::vector<Measurement>& readings,
                                                       const IdentificationOptions& options,
                                                       const Identification& fitted);

/// Returns warnings for all effects of a diagnosed model. Empty if the diagnosis was not run, or on a request to stop.
[[nodiscard]] std::vector<EffectWarning> warnOfEffects(const PlacedArm& start, const std::vector<Measurement>& readings,
                                                       const DiagnosisOptions& options, const Diagnosis& diagnosis);

}  // namespace tubeplan::calibration
