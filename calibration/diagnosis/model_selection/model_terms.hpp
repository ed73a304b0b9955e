// Variants of a cause in a model: at a level of its scanned parameter, with some or all of its other parameters.
#pragma once

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Variant of a cause, with its fraction of the cause's prior probability.
struct WeighedTerm {
  ModelTerm term;
  double log_share = 0;
};

inline constexpr std::size_t kManyTerms = 60;  ///< number of variants from which on only some are estimated

/// Returns every variant of a cause.
[[nodiscard]] std::vector<WeighedTerm> termsOf(const DiagnosisWork& work, int cause);

/// Returns the variants of a cause to estimate: all of them if there are fewer than kManyTerms, otherwise those at
/// every fourth level with one or with all parameters.
[[nodiscard]] std::vector<WeighedTerm> someTermsOf(const DiagnosisWork& work, int cause);

/// Returns the log prior fraction of these terms among all variants of their causes.
[[nodiscard]] double logShareOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms);

/// Returns the same terms, each with all parameters of its cause.
[[nodiscard]] std::vector<ModelTerm> fullTerms(const DiagnosisWork& work, std::vector<ModelTerm> terms);

/// Returns the priors of the terms' parameters, concatenated. For parameters of effects, the prior standard deviation
/// is `scale` times the largest usual size.
[[nodiscard]] std::vector<PriorSize> sizesOf(const DiagnosisWork& work, const std::vector<ModelTerm>& terms,
                                             double scale);

[[nodiscard]] bool hasEffects(const DiagnosisWork& work, const std::vector<ModelTerm>& terms);

/// Returns true if a cause at its largest usual size would change the readings visibly, beyond what the fitted
/// parameters absorb.
[[nodiscard]] bool isVisible(const DiagnosisWork& work, int cause);

[[nodiscard]] bool mayStandTogether(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, int cause);

/// Returns true if one of the terms stands for several single causes: an effect at every joint, or the whole geometry.
[[nodiscard]] bool saysManyAtOnce(const DiagnosisWork& work, const std::vector<ModelTerm>& terms);

}  // namespace tubeplan::calibration
