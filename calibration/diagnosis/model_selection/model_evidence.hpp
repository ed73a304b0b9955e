// Evidence of a competing model, summed over noise assumptions, over priors for usual and unusual sizes of effects, and
// over discrepancies that have all terms, a single source or no term.
#pragma once

#include <functional>

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Evidence of a model, summed over discrepancies with all terms and with a single source.
struct WeighedDiscrepancy : Evidence {
  /// Most probable single source; its index `source` is -1 if all terms or no discrepancy are more probable.
  SourceEvidence source;
};

/// Returns `evidence` extended by discrepancies with a single source. `single` is the evidence of these sources
/// relative to the model without a discrepancy.
[[nodiscard]] WeighedDiscrepancy withSources(const Evidence& evidence, const SourceEvidence& single,
                                             const EvidenceOptions& options);

/// Function that returns the evidence of a model for one noise assumption and one prior scale of its effects' sizes.
using EvidenceOf = std::function<WeighedDiscrepancy(const NoiseHypothesis& noise, std::size_t index, double scale)>;

/// Sums the evidence of a model over noise assumptions and over usual and unusual sizes. Sets all members of `model`
/// except terms, prior and fit.
void blendEvidence(const DiagnosisWork& work, bool has_effects, const EvidenceOf& of, CompetingModel& model);

/// Returns the model with these terms and its evidence, linearised about the baseline and summed over noise assumptions
/// and sizes.
[[nodiscard]] CompetingModel weigh(const DiagnosisWork& work, std::vector<ModelTerm> terms, double log_share);

/// Returns a quick estimate of the log weight of a model with these terms. It takes into account only the noise and the
/// size of the discrepancy that are most probable for the model `like`.
[[nodiscard]] double estimateLogWeight(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, double log_share,
                                       const CompetingModel& like);

}  // namespace tubeplan::calibration
