// Errors of measurements as JSON and text, in the unit of the measured quantity, and their error budget.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/estimation/error_budget.hpp"
#include "calibration/patterns/comparison.hpp"

namespace tubeplan::app {

/// Unit of errors: the angle unit if the measurements measure only angles, otherwise the length unit.
struct ErrorUnit {
  std::string name;
  /// Length of one unit [m]; for an angle unit, the angle [rad] times calibration::kTurnLever.
  double factor = 1;
};

[[nodiscard]] ErrorUnit errorUnitOf(bool are_angles, const Units& units);

/// Returns an error in the given unit; null if it is not finite.
[[nodiscard]] nlohmann::json errorJson(double error, const ErrorUnit& unit);

/// Returns a string such as "0.0123 in" or "0.0123 deg" with `digits` significant digits; "none" if the error is not
/// finite.
[[nodiscard]] std::string errorText(double error, const ErrorUnit& unit, int digits = 4);

/// Returns the unit of a measurement's error: the angle unit if the measurement measures only angles, otherwise the
/// length unit.
[[nodiscard]] ErrorUnit errorUnitOf(const calibration::Measurement& measurement, const Units& units);

/// Returns the magnitude of a measurement's error, defined as in ErrorSize, in the unit of errorUnitOf(). `turn` [rad]
/// is the rotational part of the error, as in ComparedMeasurement and MeasurementView.
[[nodiscard]] nlohmann::json errorSizeJson(const calibration::Measurement& measurement, const Eigen::Vector3d& error_W,
                                           double turn, const Units& units);

/// Returns the error budget: the total error, the part that a diagnosis or refit explains, the part that remains, and
/// the noise.
[[nodiscard]] calibration::ErrorBudget budgetOf(const calibration::Diagnosis& result);
[[nodiscard]] calibration::ErrorBudget budgetOf(const calibration::Comparison& result);
[[nodiscard]] calibration::ErrorBudget budgetOf(const calibration::Identification& result);

/// Returns {of: "held-out" or "fitted", unit, total, explained, remainder, noise, measurements, set_aside: count,
/// words}; null if there is no error.
[[nodiscard]] nlohmann::json errorBudgetJson(const calibration::ErrorBudget& budget, std::size_t set_aside,
                                             const Units& units);

/// Returns a sentence such as "Held-out error 0.613 mm (root mean square over 436 measurements; 32 set aside as
/// outliers):
/// ..."; empty if there is no error.
[[nodiscard]] std::string errorBudgetText(const calibration::ErrorBudget& budget, std::size_t set_aside,
                                          const Units& units);

}  // namespace tubeplan::app
