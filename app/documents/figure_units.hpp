// Units of the values in a JSON document, derived from their keys.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

namespace tubeplan::app {

/// Units of figures whose parts have different ones: readings of joints, covariances of a shift and a turn, and points
/// of a distribution; and lists of numbers whose units the document lists under `units_of_each`.
inline constexpr std::string_view kOfTheJoint = "of the joint", kOfShiftAndTurn = "of the shift and the turn",
                                  kOfLengthAndFraction = "of the length, and a fraction",
                                  kOfEachNumber = "of each number";

/// Returns the unit of the value at a path of keys such as "rms/after"; empty for a dimensionless number. `scopes`
/// holds the document first, then the nested objects that contain the value, outermost first.
[[nodiscard]] std::string figureUnit(std::string_view path, std::span<const nlohmann::json* const> scopes);

/// Units of many figures of one document, as figureUnit() returns them. Remembers what it has found for a path.
class FigureUnits {
 public:
  [[nodiscard]] std::string at(const std::string& path, std::span<const nlohmann::json* const> scopes);

 private:
  std::unordered_map<std::string, std::size_t> rows_;  ///< row of the table for a path
};

}  // namespace tubeplan::app
