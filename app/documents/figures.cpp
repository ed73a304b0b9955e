#include "app/documents/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/files/units.hpp"

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

std::string lengthText(double metres, const Units& units, int digits) {
  if (!std::isfinite(metres)) return "none";
  return fmt::format("{:.{}g} {}", metres / units.factor(dimension::kLength), digits, units.length().name);
}

int lengthDecimals(const Units& units) {
  constexpr double kSeen = 2.54e-6;  // m
  const double decimals = std::ceil(std::log10(units.factor(dimension::kLength) / kSeen) - 1e-9);
  return std::max(4, static_cast<int>(decimals));
}

nlohmann::json vectorJson(const Eigen::VectorXd& values, const Units& units, Dimension dimension) {
  nlohmann::json json = nlohmann::json::array();
  for (const double value : values) json.push_back(units.toFile(value, dimension));
  return json;
}

}  // namespace tubeplan::app
