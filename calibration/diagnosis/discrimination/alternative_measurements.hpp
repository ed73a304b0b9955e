// What else could be measured where no posture splits rival explanations: another load, temperature or set-up, a link
// watched beside the tip, by the same figures; last of all what each effect acts on, looked at by itself.
#pragma once

#include <vector>

#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"
#include "calibration/diagnosis/discrimination/rival_prediction.hpp"

namespace tubeplan::calibration {

/// The means that pass the gap, best first; then the direct checks, which need no figure.
[[nodiscard]] std::vector<AlternativeMeasurements> findAlternativeMeasurements(
    const std::vector<RivalModel>& rivals, const std::vector<Explanation>& explanations,
    const std::vector<ReadingCandidate>& candidates, const std::vector<Measurement>& readings,
    const DiscriminationOptions& options);

}  // namespace tubeplan::calibration
