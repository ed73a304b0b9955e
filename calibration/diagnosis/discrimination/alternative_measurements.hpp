// Alternative measurements for rival explanations that no posture can separate: another load, temperature or set-up, or
// a link measured in addition to the tip. Direct inspections of the components on which the effects act come last.
#pragma once

#include <vector>

#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"
#include "calibration/diagnosis/discrimination/rival_prediction.hpp"

namespace tubeplan::calibration {

/// Returns the alternative measurements that are expected to separate every pair of rivals well enough for a decision
/// (separationNeeded()), best first. Direct inspections follow, for which no criterion is computed.
[[nodiscard]] std::vector<AlternativeMeasurements> findAlternativeMeasurements(
    const std::vector<RivalModel>& rivals, const std::vector<Explanation>& explanations,
    const std::vector<MeasurementCandidate>& candidates, const std::vector<Measurement>& measurements,
    const DiscriminationOptions& options);

}  // namespace tubeplan::calibration
