// Variants of a cause in a model: at a level of its shape, with some or all of its numbers.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Variant of a cause, with its share of the cause's probability.
struct WeighedTerm {
  ModelTerm term;
  double log_share = 0;
};

inline constexpr std::size_t kManyTerms = 60;  ///< number of variants from which only some are estimated

/// Returns every variant of a cause.
[[nodiscard]] std::vector<WeighedTerm> termsOf(const DiagnosisWork& work, int cause);

/// Returns all variants of a cause; if there are very many, those at every fourth level, with one number or all.
[[nodiscard]] std::vector<WeighedTerm> someTermsOf(const DiagnosisWork& work, int cause);

/// Returns the log share of these terms among all variants of their causes.
[[nodiscard]] double logShareOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms);

/// Returns the same causes with all their numbers.
[[nodiscard]] std::vector<ModelTerm> fullTerms(const DiagnosisWork& work, std::vector<ModelTerm> terms);

/// Returns the prior sizes of the terms' numbers, one after another; those of effects are `scale` times their largest
/// usual size.
[[nodiscard]] std::vector<PriorSize> sizesOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms,
                                             double scale);

[[nodiscard]] bool hasEffects(const DiagnosisWork& work, const std::vector<ModelTerm>& terms);

/// Returns true if a cause at the largest usual size would be visible beyond what the fitted numbers absorb.
[[nodiscard]] bool isVisible(const DiagnosisWork& work, int cause);

[[nodiscard]] bool mayStandTogether(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, int cause);

/// Returns true if one of the terms represents several single causes: an effect at every joint, or all of the geometry.
[[nodiscard]] bool saysManyAtOnce(const DiagnosisWork& work, const std::vector<ModelTerm>& terms);

}  // namespace tubeplan::calibration
