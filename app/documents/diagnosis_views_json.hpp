// What a diagnosis can show, as JSON: its readings, its ladder of errors and its added-variable plots.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

/// The active joints as their readings are written: [{name, unit}, ...].
[[nodiscard]] nlohmann::json jointsJson(const deflection::Arm& arm, const Units& units);

/// A reading without its errors, in the cell's units: {id, kind, point, joints: [...], load}, and where stated setup,
/// senses: [...], conditions by their names.
[[nodiscard]] nlohmann::json readingJson(const calibration::Measurement& reading, const deflection::Arm& arm,
                                         const Units& units);

/// Adds the numbers of a kind's own columns by their names, in the cell's units.
void addOwnNumbers(const calibration::Measurement& reading, const Units& units, nlohmann::json& entry);

/// [{name, rms, heldout_rms}, ...]: the model as it stands, refitted, and with each explanation that is shown. What
/// nothing was fitted for has no held-out error of its own.
[[nodiscard]] nlohmann::json modelComparisonJson(const calibration::Diagnosis& result, const Units& units);

/// Adds to a diagnosis: `joints`, `ladder`, `readings` (each as above with position: [3], before: [3], after: [3] by
/// the leading explanation, and explained: [[3], ...] by each that is shown; errors are measured less predicted),
/// `added_variable` ([{explanation, effect, at, slope, length, kept_fraction, points: [[reading, signature, left],
/// ...]}], where `reading` is an index into `readings`).
void addViews(const calibration::Diagnosis& result, const std::vector<calibration::Measurement>& readings,
              const Units& units, nlohmann::json& json);

}  // namespace tubeplan::app
