// The ways that a model can say a cause: at a level of its shape, with some or all of its numbers.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// A way to say a cause, with its share of the cause's probability.
struct WeighedTerm {
  ModelTerm term;
  double log_share = 0;
};

inline constexpr std::size_t kManyTerms = 60;  ///< ways to say a cause, from which only some are looked at

/// Every way to say a cause.
[[nodiscard]] std::vector<WeighedTerm> termsOf(const DiagnosisWork& work, int cause);

/// Of very many ways to say a cause those at every fourth level, with one number or all.
[[nodiscard]] std::vector<WeighedTerm> someTermsOf(const DiagnosisWork& work, int cause);

/// Of all terms among all ways to say their causes.
[[nodiscard]] double logShareOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms);

/// The same causes with all their numbers.
[[nodiscard]] std::vector<ModelTerm> fullTerms(const DiagnosisWork& work, std::vector<ModelTerm> terms);

/// The prior sizes of the terms' numbers, one after another; those of effects `scale` times their largest usual.
[[nodiscard]] std::vector<PriorSize> sizesOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms,
                                             double scale);

[[nodiscard]] bool hasEffects(const DiagnosisWork& work, const std::vector<ModelTerm>& terms);

/// Whether a cause at the largest usual size would show at all beyond what the fitted numbers absorb.
[[nodiscard]] bool isVisible(const DiagnosisWork& work, int cause);

[[nodiscard]] bool mayStandTogether(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, int cause);

/// Says several single causes at once: one at all joints alike, or all of the geometry.
[[nodiscard]] bool saysManyAtOnce(const DiagnosisWork& work, const std::vector<ModelTerm>& terms);

}  // namespace tubeplan::calibration
