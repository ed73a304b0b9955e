// The evidence of a competing model: over views of the noise, usual and unusual sizes, and a discrepancy of all terms
// together or of a single source.
#pragma once

#include <functional>

#include "calibration/diagnosis/model_selection/competing_models.hpp"

namespace tubeplan::calibration {

/// Evidence with a discrepancy of all terms together, or of a single source.
struct WeighedDiscrepancy : Evidence {
  SourceEvidence source;  ///< `source` -1 where it is less probable than all terms together
};

/// Evidence that counts a discrepancy of a single source too; `single` is of the model without any discrepancy.
[[nodiscard]] WeighedDiscrepancy withSources(const Evidence& evidence, const SourceEvidence& single,
                                             const EvidenceOptions& options);

/// The evidence of a model whose terms have these sizes' priors, over noise and usual and unusual sizes: `of` gives it
/// for one noise and one scale of the sizes (EvidenceOf). Fills all but terms, prior and fit.
using EvidenceOf = std::function<WeighedDiscrepancy(const NoiseHypothesis& noise, std::size_t index, double scale)>;
void blendEvidence(const DiagnosisWork& work, bool has_effects, const EvidenceOf& of, CompetingModel& model);

/// The evidence of some terms about the baseline, over noise and sizes.
[[nodiscard]] CompetingModel weigh(const DiagnosisWork& work, std::vector<ModelTerm> terms, double log_share);

/// A quick look at some terms, their log weight: by the noise and the discrepancy that suited `like` best.
[[nodiscard]] double lookAt(const DiagnosisWork& work, const std::vector<ModelTerm>& terms, double log_share,
                            const CompetingModel& like);

}  // namespace tubeplan::calibration
