// Single figures as documents and texts write them: in the file's units, never NaN.
#pragma once

#include <Eigen/Core>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "app/formats/units.hpp"

namespace tubeplan::app {

/// Rounded to 12 digits; null where it is not finite.
[[nodiscard]] nlohmann::json finiteJson(double value);

[[nodiscard]] nlohmann::json lengthJson(double metres, const Units& units);

/// Three lengths.
[[nodiscard]] nlohmann::json placeJson(const Eigen::Vector3d& metres, const Units& units);

/// "0.0123 in", to so many digits; "none" where it is not finite.
[[nodiscard]] std::string lengthText(double metres, const Units& units, int digits = 4);

/// To so many digits; whole numbers without an exponent.
[[nodiscard]] std::string significantText(double value, int digits);

/// "0.0123 in": a figure with its unit, to so many digits.
[[nodiscard]] std::string figureText(double value, std::string_view unit, int digits);

/// "p = 0.012": the probability of what is seen by chance alone.
[[nodiscard]] std::string chanceText(double p);

/// Decimals at which lengths stand in columns of this unit: a ten-thousandth of an inch is seen in every unit.
[[nodiscard]] int lengthDecimals(const Unit& length);

/// How a calibration, an identification or a comparison ended; their statuses have these in this order.
template <class Status>
[[nodiscard]] std::string_view statusName(Status status) {
  static constexpr std::array<std::string_view, 5> kNames{"not-run", "done", "refused", "not-converged", "stopped"};
  static_assert(static_cast<int>(Status::kNotConverged) == 3);
  return kNames.at(static_cast<std::size_t>(status));
}

/// A vector in file units, each number rounded to 12 digits.
[[nodiscard]] nlohmann::json vectorJson(const Eigen::VectorXd& values, const Units& units, Dimension dimension);

}  // namespace tubeplan::app
