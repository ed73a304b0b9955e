// Whether the readings need the effects that a model carries: each is taken out, and the rest fitted anew.
//
// All that could stand in its place competes with it, itself and nothing among them (competing_models.hpp): one that
// brings -2 log of the posterior down by less than the gap is one that no diagnosis would name; where another does
// better by the gap, the other is the one.
#pragma once

#include <string>
#include <vector>

#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::calibration {

enum class EffectWarningKind { kNotNeeded, kBetterExplainedBy, kBeyondPlausible, kLackOfFitRemains };

struct EffectWarning {
  EffectWarningKind kind = EffectWarningKind::kNotNeeded;
  std::string effect, at;
  double fall = kNotKnown;       ///< of chi-square by its numbers
  double p_value = kNotKnown;    ///< of that fall by noise; of the lack of fit that remains
  bool is_within_noise = false;  ///< the criterion is no better with it than without
  bool is_at_neutral = false;    ///< all its sizes are within two sigma of doing nothing
  ErrorSize heldout_with, heldout_without;
  FoundNumber number;  ///< the one beyond what any machine has
  double plausible = kNotKnown;
  FoundEffect better;     ///< what explains better, perhaps itself with another shape
  double by = kNotKnown;  ///< of -2 log of the posterior
};

/// Of the effects that an identification fitted. `options` and `start` are those it was made with. Empty unless it was
/// done, and where the options' hooks say stop.
[[nodiscard]] std::vector<EffectWarning> warnOfEffects(const PlacedArm& start, const std::vector<Measurement>& readings,
                                                       const IdentificationOptions& options,
                                                       const Identification& fitted);

/// Of all effects that a diagnosed model carries. Empty unless it was run, and where the hooks say stop.
[[nodiscard]] std::vector<EffectWarning> warnOfEffects(const PlacedArm& start, const std::vector<Measurement>& readings,
                                                       const DiagnosisOptions& options, const Diagnosis& diagnosis);

}  // namespace tubeplan::calibration
