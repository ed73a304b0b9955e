// Evidence of a competing model, summed over noise assumptions, usual and unusual sizes, and a discrepancy of all terms
// together or of a single source.
#pragma once

#include <functional>

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Evidence with a discrepancy of all terms together, or of a single source.
struct WeighedDiscrepancy : Evidence {
  SourceEvidence source;  ///< most probable single source; its index `source` is -1 if a single source is less probable
};

/// Returns the evidence including a discrepancy of a single source. `single` is the source evidence relative to the
/// model without a discrepancy.
[[nodiscard]] WeighedDiscrepancy withSources(const Evidence& evidence, const SourceEvidence& single,
                                             const EvidenceOptions& options);

/// Function that returns the evidence of a model for one noise assumption and one scale of its sizes.
using EvidenceOf = std::function<WeighedDiscrepancy(const NoiseHypothesis& noise, std::size_t index, double scale)>;

/// Sums the evidence of a model over noise assumptions and over usual and unusual sizes. Sets all members of `model`
/// except terms, prior and fit.
void blendEvidence(const DiagnosisWork& work, bool has_effects, const EvidenceOf& of, CompetingModel& model);

/// Returns the model with these terms and its evidence about the baseline, summed over noise assumptions and sizes.
[[nodiscard]] CompetingModel weigh(const DiagnosisWork& work, std::vector<ModelTerm> terms, double log_share);

/// Returns a quick estimate of the log weight of a model with these terms, for only the most probable noise and
/// discrepancy of `like`.
[[nodiscard]] double lookAt(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, double log_share,
                            const CompetingModel& like);

}  // namespace tubeplan::calibration
