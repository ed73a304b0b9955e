// Errors of readings as documents and texts write them: in the unit of what was measured, with what they divide into.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/diagnosis.hpp"
#include "calibration/estimation/error_budget.hpp"
#include "calibration/patterns/comparison.hpp"

namespace tubeplan::app {

/// The unit of errors: that of angles where the readings measure nothing else, else that of lengths.
struct ErrorUnit {
  std::string name;
  double factor = 1;  ///< m of an ErrorSize in one such unit
};

[[nodiscard]] ErrorUnit errorUnitOf(bool are_angles, const Units& units);

/// Returns an error in its unit; null where it is not finite.
[[nodiscard]] nlohmann::json errorJson(double error, const ErrorUnit& unit);

/// "0.0123 in" or "0.0123 deg", to so many digits; "none" where it is not finite.
[[nodiscard]] std::string errorText(double error, const ErrorUnit& unit, int digits = 4);

/// The unit of one reading's error: that of angles where it measures nothing else.
[[nodiscard]] ErrorUnit errorUnitOf(const calibration::Measurement& reading, const Units& units);

/// Length of one reading's error, as an ErrorSize has it, in its unit. `turn` [rad] is what of its error is
/// turns, as ComparedReading and ReadingView have it.
[[nodiscard]] nlohmann::json errorSizeJson(const calibration::Measurement& reading, const Eigen::Vector3d& error_W,
                                           double turn, const Units& units);

/// What the causes of a diagnosis, or a refit, take from the error.
[[nodiscard]] calibration::ErrorBudget budgetOf(const calibration::Diagnosis& result);
[[nodiscard]] calibration::ErrorBudget budgetOf(const calibration::Comparison& result);
[[nodiscard]] calibration::ErrorBudget budgetOf(const calibration::Identification& result);

/// {of: "held-out" | "fitted", unit, total, explained, remainder, noise, readings, set_aside: how many, words}; null
/// where there is no error.
[[nodiscard]] nlohmann::json errorBudgetJson(const calibration::ErrorBudget& budget, std::size_t set_aside,
                                             const Units& units);

/// "Held-out error 0.613 mm (root mean square over 436 readings; 32 set aside as outliers): ..."; empty where there is
/// no error.
[[nodiscard]] std::string errorBudgetText(const calibration::ErrorBudget& budget, std::size_t set_aside,
                                          const Units& units);

}  // namespace tubeplan::app
