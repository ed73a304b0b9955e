// Measurements proposed to decide between the explanations of a diagnosis, as JSON and as text.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"

namespace tubeplan::app {

/// Adds two entries to the JSON of a diagnosis: `next_readings`, the proposed measurements, and `splitting`, the
/// expected benefit of these measurements and of other remedies. Appends the advice to the `sentence` of the diagnosis.
void addNextMeasurements(const calibration::DiscriminatingMeasurements& result,
                         const std::vector<calibration::MeasurementCandidate>& candidates, const deflection::Arm& arm,
                         const Units& units, nlohmann::json& diagnosis);

/// Returns the advice in one sentence; empty if there are no explanations to decide between.
[[nodiscard]] std::string discriminationAdvice(const calibration::DiscriminatingMeasurements& result);

/// Returns the proposed measurements, each with an id that no measurement in `taken` has; the list is empty if none are
/// proposed.
[[nodiscard]] std::vector<calibration::ProposedMeasurement> runSheetOf(
    const calibration::DiscriminatingMeasurements& result,
    const std::vector<calibration::MeasurementCandidate>& candidates,
    const std::vector<calibration::Measurement>& taken);

/// Returns the proposed measurements and their benefit as short text.
[[nodiscard]] std::string discriminationText(nlohmann::json figures);

}  // namespace tubeplan::app
