#include "app/documents/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/formats/units.hpp"

namespace tubeplan::app {

nlohmann::json finiteJson(double value) {
  return std::isfinite(value) ? nlohmann::json(rounded(value)) : nlohmann::json();
}

nlohmann::json lengthJson(double metres, const Units& units) {
  return finiteJson(metres / units.factor(dimension::kLength));
}

nlohmann::json placeJson(const Eigen::Vector3d& metres, const Units& units) {
  return {lengthJson(metres.x(), units), lengthJson(metres.y(), units), lengthJson(metres.z(), units)};
}

std::string significantText(double value, int digits) {
  // Prints 1331 instead of 1.33e+03.
  const bool is_whole = std::abs(value) >= std::pow(10, digits) && std::abs(value) < 1e7;
  return is_whole ? fmt::format("{:.0f}", value) : fmt::format("{:.{}g}", value, digits);
}

std::string figureText(double value, std::string_view unit, int digits) {
  return std::isfinite(value) ? fmt::format("{} {}", significantText(value, digits), unit) : "none";
}

std::string chanceText(double p) { return p < 1e-300 ? "p below 1e-300" : fmt::format("p = {:.2g}", p); }

std::string lengthText(double metres, const Units& units, int digits) {
  return figureText(metres / units.factor(dimension::kLength), units.length().name, digits);
}

int lengthDecimals(const Unit& length) {
  constexpr double kSeen = 2.54e-6;  // smallest length that must remain visible [m]
  return std::max(4, static_cast<int>(std::ceil(std::log10(length.factor / kSeen) - 1e-9)));
}

nlohmann::json vectorJson(const Eigen::VectorXd& values, const Units& units, Dimension dimension) {
  nlohmann::json json = nlohmann::json::array();
  for (const double value : values) json.push_back(units.toFile(value, dimension));
  return json;
}

}  // namespace tubeplan::app
