// Variants of a cause in a model: each has one level of the scanned parameter and some or all of the other parameters.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Variant of a cause, with its fraction of the cause's prior probability.
struct WeighedTerm {
  ModelTerm term;
  double log_share = 0;
};

inline constexpr std::size_t kManyTerms = 60;  ///< if a cause has this many variants or more, only some are estimated

/// Returns every variant of a cause.
[[nodiscard]] std::vector<WeighedTerm> termsOf(const DiagnosisWork& work, int cause);

/// Returns the variants of a cause to estimate: all of them if there are fewer than kManyTerms, otherwise those at
/// every fourth level with one or with all parameters.
[[nodiscard]] std::vector<WeighedTerm> someTermsOf(const DiagnosisWork& work, int cause);

/// Returns the log of the fraction of the causes' prior probability that goes to these terms.
[[nodiscard]] double logShareOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms);

/// Returns the same terms, each with all parameters of its cause.
[[nodiscard]] std::vector<ModelTerm> fullTerms(const DiagnosisWork& work, std::vector<ModelTerm> terms);

/// Returns the priors of the terms' parameters, concatenated. For parameters of effects, the prior standard deviation
/// is `scale` times the largest usual size.
[[nodiscard]] std::vector<PriorSize> sizesOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms,
                                             double scale);

[[nodiscard]] bool hasEffects(const DiagnosisWork& work, const std::vector<ModelTerm>& terms);

/// Returns true if a cause at its largest usual size would change the measurements by a visible amount that the fitted
/// parameters cannot absorb.
[[nodiscard]] bool isVisible(const DiagnosisWork& work, int cause);

[[nodiscard]] bool areCombinable(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, int cause);

/// Returns true if one of the terms represents several single causes: an effect at every joint, or the whole geometry.
[[nodiscard]] bool representsSeveralCauses(const DiagnosisWork& work, const std::vector<ModelTerm>& terms);

}  // namespace tubeplan::calibration
