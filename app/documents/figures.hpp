// Single values as JSON and text, in file units; a value that is not finite becomes null or "none".
#pragma once

#include <Eigen/Core>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "app/formats/units.hpp"

namespace tubeplan::app {

/// Returns the value rounded to 12 significant digits; null if it is not finite.
[[nodiscard]] nlohmann::json finiteJson(double value);

[[nodiscard]] nlohmann::json lengthJson(double metres, const Units& units);

/// Returns a position [m] as three lengths in the file's unit.
[[nodiscard]] nlohmann::json placeJson(const Eigen::Vector3d& metres, const Units& units);

/// Returns a string such as "0.0123 in" with `digits` significant digits; "none" if the length is not finite.
[[nodiscard]] std::string lengthText(double metres, const Units& units, int digits = 4);

/// Returns a number as text with `digits` significant digits. A number below 1e7 with more digits before the decimal
/// point is written as an integer, without an exponent.
[[nodiscard]] std::string significantText(double value, int digits);

/// Returns a value with its unit, such as "0.0123 in", with `digits` significant digits; "none" if it is not finite.
[[nodiscard]] std::string figureText(double value, std::string_view unit, int digits);

/// Returns a p-value as text, such as "p = 0.012".
[[nodiscard]] std::string chanceText(double p);

/// Returns the number of decimals for lengths in this unit in tables, such that 1e-4 in is visible.
[[nodiscard]] int lengthDecimals(const Unit& length);

/// Returns the name of the status of a calibration, identification or comparison. The three enumerations have the same
/// order.
template <class Status>
[[nodiscard]] std::string_view statusName(Status status) {
  static constexpr std::array<std::string_view, 5> kNames{"not-run", "done", "refused", "not-converged", "stopped"};
  static_assert(static_cast<int>(Status::kNotConverged) == 3);
  return kNames.at(static_cast<std::size_t>(status));
}

/// Returns a vector in file units, each component rounded to 12 significant digits.
[[nodiscard]] nlohmann::json vectorJson(const Eigen::VectorXd& values, const Units& units, Dimension dimension);

}  // namespace tubeplan::app
