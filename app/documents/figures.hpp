// Single figures as documents and texts write them: in the file's units, never NaN.
#pragma once

#include <Eigen/Core>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "app/formats/units.hpp"

namespace tubeplan::app {

/// Returns the value rounded to 12 digits; null if it is not finite.
[[nodiscard]] nlohmann::json finiteJson(double value);

[[nodiscard]] nlohmann::json lengthJson(double metres, const Units& units);

/// Returns three lengths in the file's unit.
[[nodiscard]] nlohmann::json placeJson(const Eigen::Vector3d& metres, const Units& units);

/// Returns "0.0123 in", with this number of digits; "none" if it is not finite.
[[nodiscard]] std::string lengthText(double metres, const Units& units, int digits = 4);

/// Returns a number with this number of digits; whole numbers without an exponent.
[[nodiscard]] std::string significantText(double value, int digits);

/// Returns "0.0123 in": a figure with its unit, with this number of digits.
[[nodiscard]] std::string figureText(double value, std::string_view unit, int digits);

/// Returns "p = 0.012": the probability of the observation by chance alone.
[[nodiscard]] std::string chanceText(double p);

/// Returns the number of decimals for columns of lengths in this unit, enough to show a ten-thousandth of an inch.
[[nodiscard]] int lengthDecimals(const Unit& length);

/// Returns the name of the outcome of a calibration, an identification or a comparison, whose statuses share one order.
template <class Status>
[[nodiscard]] std::string_view statusName(Status status) {
  static constexpr std::array<std::string_view, 5> kNames{"not-run", "done", "refused", "not-converged", "stopped"};
  static_assert(static_cast<int>(Status::kNotConverged) == 3);
  return kNames.at(static_cast<std::size_t>(status));
}

/// Returns a vector in file units, each number rounded to 12 digits.
[[nodiscard]] nlohmann::json vectorJson(const Eigen::VectorXd& values, const Units& units, Dimension dimension);

}  // namespace tubeplan::app
