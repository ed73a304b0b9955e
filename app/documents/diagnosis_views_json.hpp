// Pictures of a diagnosis as JSON: its readings, its ladder of errors and its added-variable plots.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

/// Returns the active joints in the notation of their readings: [{name, unit}, ...].
[[nodiscard]] nlohmann::json jointsJson(const deflection::Arm& arm, const Units& units);

/// Returns a reading without its errors, in the cell's units: {id, kind, point, joints: [...], load}, and if stated
/// setup, senses: [...], conditions by their names.
[[nodiscard]] nlohmann::json readingJson(const calibration::Measurement& reading, const deflection::Arm& arm,
                                         const Units& units);

/// Adds the numbers of the kind's own columns by their names, in the cell's units.
void addOwnNumbers(const calibration::Measurement& reading, const Units& units, nlohmann::json& entry);

/// Returns [{name, rms, heldout_rms}, ...]: the given model, the refitted model, and the model with each explanation
/// shown. Without a fit there is no held-out error.
[[nodiscard]] nlohmann::json modelComparisonJson(const calibration::Diagnosis& result, const Units& units);

/// Adds to a diagnosis: `joints`, `ladder`, `readings` (each as in readingJson() with position: [3], before: [3],
/// after: [3] by the leading explanation, and explained: [[3], ...] by each explanation shown; errors are measured less
/// predicted), `added_variable` ([{explanation, effect, at, slope, length, kept_fraction, points: [[reading, signature,
/// left], ...]}], where `reading` is an index into `readings`).
void addViews(const calibration::Diagnosis& result, const std::vector<calibration::Measurement>& readings,
              const Units& units, nlohmann::json& json);

}  // namespace tubeplan::app
