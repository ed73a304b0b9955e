#include "app/formats/units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "app/formats/yaml/yaml_node.hpp"
#include "app/storage/suggestion.hpp"

namespace tubeplan::app {

namespace {

constexpr double kPoundForce = 4.4482216152605;  // [N], exact: weight of 0.45359237 kg at 9.80665 m/s^2

constexpr Unit kUnits[] = {
    {UnitKind::kLength, "in", 0.0254},
    {UnitKind::kLength, "mm", 0.001},
    {UnitKind::kLength, "cm", 0.01},
    {UnitKind::kLength, "m", 1},
    {UnitKind::kLength, "ft", 0.3048},
    {UnitKind::kAngle, "deg", std::numbers::pi / 180},
    {UnitKind::kAngle, "rad", 1},
    {UnitKind::kForce, "lbf", kPoundForce},
    {UnitKind::kForce, "N", 1},
    {UnitKind::kForce, "kgf", kWeightOfKilogram},
    {UnitKind::kTorque, "lbfin", kPoundForce * 0.0254},
    {UnitKind::kTorque, "lbfmm", kPoundForce * 0.001},
    {UnitKind::kTorque, "lbfcm", kPoundForce * 0.01},
    {UnitKind::kTorque, "lbfm", kPoundForce * 1},
    {UnitKind::kTorque, "lbfft", kPoundForce * 0.3048},
    {UnitKind::kTorque, "Nin", 1 * 0.0254},
    {UnitKind::kTorque, "Nmm", 1 * 0.001},
    {UnitKind::kTorque, "Ncm", 1 * 0.01},
    {UnitKind::kTorque, "Nm", 1 * 1},
    {UnitKind::kTorque, "Nft", 1 * 0.3048},
    {UnitKind::kTorque, "kgfin", kWeightOfKilogram * 0.0254},
    {UnitKind::kTorque, "kgfmm", kWeightOfKilogram * 0.001},
    {UnitKind::kTorque, "kgfcm", kWeightOfKilogram * 0.01},
    {UnitKind::kTorque, "kgfm", kWeightOfKilogram * 1},
    {UnitKind::kTorque, "kgfft", kWeightOfKilogram * 0.3048},
    {UnitKind::kTemperature, "degF", 5.0 / 9.0, 459.67},
    {UnitKind::kTemperature, "degC", 1, 273.15},
    {UnitKind::kTemperature, "K", 1},
    {UnitKind::kTime, "s", 1},
    {UnitKind::kTime, "min", 60},
    {UnitKind::kTime, "h", 3600},
};

const Unit* readUnit(const YamlNode& node, UnitKind kind) {
  const std::string name = node.text();
  if (const Unit* unit = findUnit(kind, name)) return unit;
  node.fail("the unknown unit '" + name + "'", alternatives(unitNames(kind)), suggestion(name, unitNames(kind)));
}

const Unit* readUnit(const YamlNode& map, std::string_view key, UnitKind kind, std::string_view otherwise) {
  const YamlNode* node = map.find(key);
  return node ? readUnit(*node, kind) : findUnit(kind, otherwise);
}

void appendPower(std::string& over, std::string& under, std::string_view name, int exponent) {
  if (exponent == 0) return;
  std::string& side = exponent > 0 ? over : under;
  if (!side.empty()) side += "*";
  side += name;
  if (std::abs(exponent) > 1) side += "^" + std::to_string(std::abs(exponent));
}

}  // namespace

std::span<const Unit> unitTable() { return kUnits; }

const Unit* findUnit(UnitKind kind, std::string_view name) {
  for (const Unit& unit : kUnits)
    if (unit.kind == kind && unit.name == name) return &unit;
  return nullptr;
}

std::vector<std::string> unitNames(UnitKind kind) {
  std::vector<std::string> names;
  for (const Unit& unit : kUnits)
    if (unit.kind == kind) names.emplace_back(unit.name);
  return names;
}

Dimension dimensionOf(deflection::Quantity quantity) {
  using Q = deflection::Quantity;
  switch (quantity) {
    case Q::kNone:
      return dimension::kNone;
    case Q::kLength:
      return dimension::kLength;
    case Q::kAngle:
      return dimension::kAngle;
    case Q::kForce:
      return dimension::kForce;
    case Q::kForcePerLength:
      return dimension::kForcePerLength;
    case Q::kTorquePerAngle:
      return dimension::kTorquePerAngle;
    case Q::kPressure:
      return dimension::kPressure;
    case Q::kLengthToTheFourth:
      return dimension::kLengthToTheFourth;
    case Q::kTorque:
      return dimension::kTorque;
    case Q::kAnglePerTorque:
      return dimension::kAnglePerTorque;
    case Q::kPerBendingStiffness:
      return dimension::kPerBendingStiffness;
    case Q::kPerTemperature:
      return dimension::kPerTemperature;
    case Q::kSpeed:
      return dimension::kSpeed;
    case Q::kTime:
      return dimension::kTime;
    case Q::kTemperature:
      return dimension::kTemperature;
  }
  return dimension::kNone;
}

Units::Units()
    : length_(findUnit(UnitKind::kLength, "m")),
      angle_(findUnit(UnitKind::kAngle, "rad")),
      force_(findUnit(UnitKind::kForce, "N")),
      temperature_(findUnit(UnitKind::kTemperature, "K")),
      time_(findUnit(UnitKind::kTime, "s")) {}

Units::Units(const YamlNode& node) : Units() {
  node.expectKeys({"length", "angle", "force"}, {"temperature", "time"});
  length_ = readUnit(node.at("length"), UnitKind::kLength);
  angle_ = readUnit(node.at("angle"), UnitKind::kAngle);
  force_ = readUnit(node.at("force"), UnitKind::kForce);
  temperature_ = readUnit(node, "temperature", UnitKind::kTemperature, "degC");
  time_ = readUnit(node, "time", UnitKind::kTime, "s");
}

double Units::factor(Dimension d) const {
  const double mechanical =
      std::pow(length_->factor, d.length) * std::pow(angle_->factor, d.angle) * std::pow(force_->factor, d.force);
  return mechanical * std::pow(temperature_->factor, d.temperature) * std::pow(time_->factor, d.time);
}

double Units::toInternal(double value, Dimension dimension) const { return value * factor(dimension); }
double Units::toFile(double value, Dimension dimension) const { return rounded(value / factor(dimension)); }

double Units::toInternal(double value, const deflection::ValueUnit& unit) const {
  return (value + zeroOf(unit.quantity)) * factor(dimensionOf(unit.quantity));
}
double Units::toFile(double value, const deflection::ValueUnit& unit) const {
  return rounded(value / factor(dimensionOf(unit.quantity)) - zeroOf(unit.quantity));
}

double Units::zeroOf(deflection::Quantity quantity) const {
  return quantity == deflection::Quantity::kTemperature ? temperature_->offset : 0;
}

std::string Units::nameOf(Dimension d) const {
  std::string over, under;
  appendPower(over, under, force_->name, d.force);
  appendPower(over, under, length_->name, d.length);
  appendPower(over, under, angle_->name, d.angle);
  appendPower(over, under, temperature_->name, d.temperature);
  appendPower(over, under, time_->name, d.time);
  if (over.empty()) over = "1";
  if (under.empty()) return over;
  return over + (under.find('*') == std::string::npos ? "/" + under : "/(" + under + ")");
}

std::string Units::nameOf(const deflection::ValueUnit& unit) const {
  return unit.quantity == deflection::Quantity::kNone ? unit.fixed_unit : nameOf(dimensionOf(unit.quantity));
}

double rounded(double value) {
  if (!std::isfinite(value)) return value;
  const double result =
      std::strtod(fmt::format("{:.12g}", value).c_str(), nullptr);  // std::stod throws for subnormal numbers
  return result == 0 ? 0 : result;                                  // replaces -0 by 0
}

std::string formatNumber(double value) { return fmt::format("{}", rounded(value)); }

}  // namespace tubeplan::app
