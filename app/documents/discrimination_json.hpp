// Readings that would decide between the explanations of a diagnosis, as JSON and in words.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"

namespace tubeplan::app {

/// Adds `next_readings` (a list) and `discrimination` (their expected effect, other remedies) to a diagnosis, and the
/// advice to its sentence.
void addNextReadings(const calibration::DiscriminatingMeasurements& result,
                     const std::vector<calibration::ReadingCandidate>& candidates, const deflection::Arm& arm,
                     const Units& units, nlohmann::json& diagnosis);

/// Returns the advice in one plain sentence; empty if there is nothing to decide.
[[nodiscard]] std::string discriminationAdvice(const calibration::DiscriminatingMeasurements& result);

/// Returns the proposed readings, each with an id that the existing readings do not have; none if nothing is proposed.
[[nodiscard]] std::vector<calibration::ProposedMeasurement> runSheetOf(
    const calibration::DiscriminatingMeasurements& result, const std::vector<calibration::ReadingCandidate>& candidates,
    const std::vector<calibration::Measurement>& taken);

/// Returns a short text.
[[nodiscard]] std::string discriminationText(nlohmann::json figures);

}  // namespace tubeplan::app
