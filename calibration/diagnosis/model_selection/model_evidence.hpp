// Evidence of a competing model: over noise assumptions, usual and unusual sizes, and a discrepancy of all terms
// together or of a single source.
#pragma once

#include <functional>

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Evidence with a discrepancy of all terms together, or of a single source.
struct WeighedDiscrepancy : Evidence {
  SourceEvidence source;  ///< `source` is -1 if it is less probable than all terms together
};

/// Returns the evidence including a discrepancy of a single source; `single` is that of the model without a
/// discrepancy.
[[nodiscard]] WeighedDiscrepancy withSources(const Evidence& evidence, const SourceEvidence& single,
                                             const EvidenceOptions& options);

/// Evidence of a model for one noise and one scale of its sizes.
using EvidenceOf = std::function<WeighedDiscrepancy(const NoiseHypothesis& noise, std::size_t index, double scale)>;

/// Sums the evidence of a model over noise assumptions and over usual and unusual sizes. Sets all of `model` but terms,
/// prior and fit.
void blendEvidence(const DiagnosisWork& work, bool has_effects, const EvidenceOf& of, CompetingModel& model);

/// Returns the model of some terms with its evidence about the baseline, over noise and sizes.
[[nodiscard]] CompetingModel weigh(const DiagnosisWork& work, std::vector<ModelTerm> terms, double log_share);

/// Returns an estimate of the log weight of some terms, for the most probable noise and discrepancy of `like` only.
[[nodiscard]] double lookAt(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, double log_share,
                            const CompetingModel& like);

}  // namespace tubeplan::calibration
