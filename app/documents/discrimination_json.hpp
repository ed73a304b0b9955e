// Readings that would split what a diagnosis leaves open, as JSON and in words.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/discrimination/discriminating_measurements.hpp"

namespace tubeplan::app {

/// Puts `next_readings` (a list), and `discrimination` (what they would do, what else to do) into a diagnosis; its
/// sentence gets the advice.
void addNextReadings(const calibration::DiscriminatingMeasurements& result,
                     const std::vector<calibration::ReadingCandidate>& candidates, const deflection::Arm& arm,
                     const Units& units, nlohmann::json& diagnosis);

/// One plain sentence; empty where there is nothing to split.
[[nodiscard]] std::string discriminationAdvice(const calibration::DiscriminatingMeasurements& result);

/// Returns the proposed readings, each with an id that the readings taken do not have; none where nothing is proposed.
[[nodiscard]] std::vector<calibration::ProposedMeasurement> runSheetOf(
    const calibration::DiscriminatingMeasurements& result, const std::vector<calibration::ReadingCandidate>& candidates,
    const std::vector<calibration::Measurement>& taken);

/// A few lines for people.
[[nodiscard]] std::string discriminationText(nlohmann::json figures);

}  // namespace tubeplan::app
