// Other measurements for rival explanations that no posture can separate: another load, temperature or set-up, or a
// link measured beside the tip. The last ones are direct inspections of the part that each effect acts on.
#pragma once

#include <vector>

#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"
#include "calibration/diagnosis/discrimination/rival_prediction.hpp"

namespace tubeplan::calibration {

/// Returns the measurements with which the least expected criterion passes the needed gap, best first, then the direct
/// inspections, which have no figure.
[[nodiscard]] std::vector<AlternativeMeasurements> findAlternativeMeasurements(
    const std::vector<RivalModel>& rivals, const std::vector<Explanation>& explanations,
    const std::vector<ReadingCandidate>& candidates, const std::vector<Measurement>& readings,
    const DiscriminationOptions& options);

}  // namespace tubeplan::calibration
