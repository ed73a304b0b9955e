// Data of a diagnosis for plots, as JSON: measurements, errors of several models, and added-variable plots.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

/// Returns the active joints in the order of the measurements' joint values: [{name, unit, row}, ...].
[[nodiscard]] nlohmann::json jointsJson(const deflection::Arm& arm, const Units& units);

/// Returns a measurement without its errors, in the cell's units: {id, kind, point, joints: [...], load} and, if
/// stated, row, setup, senses: [...] and the conditions under their names.
[[nodiscard]] nlohmann::json measurementJson(const calibration::Measurement& measurement, const deflection::Arm& arm,
                                             const Units& units);

/// Adds to `entry` the values of the columns that are specific to the measurement's kind, keyed by column name, in the
/// cell's units.
void addOwnNumbers(const calibration::Measurement& measurement, const Units& units, nlohmann::json& entry);

/// Returns [{name, rms, heldout_rms}, ...] for the given model, the refitted model, and one model for each explanation
/// in the results. The held-out error is null for a model that was not fitted.
[[nodiscard]] nlohmann::json modelComparisonJson(const calibration::Diagnosis& result, const Units& units);

/// Adds to the JSON of a diagnosis: `joints`; `ladder`; `readings`, each as in measurementJson() with position: [3],
/// before: [3], after: [3] (error with the leading explanation) and explained: [[3], ...] (error with each explanation
/// shown); and `added_variable`: [{explanation, effect, at, slope, length, kept_fraction, points: [[measurement,
/// signature, left], ...]}]. Errors are measured minus predicted. In `points`, `reading` is an index in `readings`, and
/// `left` the residual of the model without the effect.
void addViews(const calibration::Diagnosis& result, const std::vector<calibration::Measurement>& measurements,
              const Units& units, nlohmann::json& json);

}  // namespace tubeplan::app
