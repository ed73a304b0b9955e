#include "app/documents/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/files/joint_units.hpp"
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

std::string significantText(double value, int digits) {
  const bool is_whole = std::abs(value) >= std::pow(10, digits) && std::abs(value) < 1e7;  // 1331, not 1.33e+03
  return is_whole ? fmt::format("{:.0f}", value) : fmt::format("{:.{}g}", value, digits);
}

std::string figureText(double value, std::string_view unit, int digits) {
  return std::isfinite(value) ? fmt::format("{} {}", significantText(value, digits), unit) : "none";
}

std::string chanceText(double p) { return p < 1e-300 ? "p below 1e-300" : fmt::format("p = {:.2g}", p); }

std::string lengthText(double metres, const Units& units, int digits) {
  return figureText(metres / units.factor(dimension::kLength), units.length().name, digits);
}

namespace {

/// How many show `seen`, in internal units, where a unit is so many of them.
int decimalsThatShow(double seen, double factor) {
  return std::max(0, static_cast<int>(std::ceil(std::log10(factor / seen) - 1e-9)));
}

}  // namespace

int lengthDecimals(const Unit& length) {
  constexpr double kSeen = 2.54e-6;  // m
  return std::max(4, decimalsThatShow(kSeen, length.factor));
}

int lengthDecimals(const Units& units) { return lengthDecimals(units.length()); }

std::vector<std::string> jointFigures(const deflection::Arm& arm, const Eigen::VectorXd& q, const Units& units) {
  constexpr double kSeen = 1e-3 * std::numbers::pi / 180;  // rad
  const Eigen::VectorXd readings = q.cwiseQuotient(jointFactors(arm, units));
  std::vector<std::string> figures;
  for (const auto& joint : arm.joints()) {
    const bool is_slide = joint.type == deflection::JointType::kPrismatic;
    const int decimals = is_slide ? lengthDecimals(units) : decimalsThatShow(kSeen, units.factor(dimension::kAngle));
    figures.push_back(fmt::format("{:.{}f}", readings[static_cast<Eigen::Index>(figures.size())], decimals));
  }
  return figures;
}

nlohmann::json vectorJson(const Eigen::VectorXd& values, const Units& units, Dimension dimension) {
  nlohmann::json json = nlohmann::json::array();
  for (const double value : values) json.push_back(units.toFile(value, dimension));
  return json;
}

}  // namespace tubeplan::app
