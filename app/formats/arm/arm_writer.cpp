#include "app/formats/arm/arm_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <vector>

#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/yaml/yaml_text.hpp"
#include "deflection/rotation.hpp"
#include "deflection/row_conventions.hpp"
#include "deflection/row_numbers.hpp"

namespace tubeplan::app {

namespace {

using deflection::Arm, deflection::JointType;
using Eigen::Vector3d;
using ArmRow = deflection::Row<double>;

/// YAML map in flow style on one line, built entry by entry.
class FlowMap {
 public:
  explicit FlowMap(const Units& units) : units_(units) {}
  void add(std::string_view key, const std::string& value) { entries_.push_back(fmt::format("{}: {}", key, value)); }
  void add(std::string_view key, double value, Dimension dimension) {
    add(key, formatNumber(units_.toFile(value, dimension)));
  }
  void addUnless(double usual, std::string_view key, double value, Dimension dimension) {
    if (value != usual) add(key, value, dimension);
  }
  void add(std::string_view key, const Vector3d& value, Dimension dimension) { add(key, listOf(value, dimension)); }
  [[nodiscard]] std::string listOf(const Vector3d& value, Dimension dimension) const {
    return fmt::format("[{}, {}, {}]", formatNumber(units_.toFile(value.x(), dimension)),
                       formatNumber(units_.toFile(value.y(), dimension)),
                       formatNumber(units_.toFile(value.z(), dimension)));
  }
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] std::string text() const { return fmt::format("{{{}}}", fmt::join(entries_, ", ")); }

 private:
  const Units& units_;
  std::vector<std::string> entries_;
};

/// Adds those parameters of a row that belong to its map `name`, such as "beam" or "dh". If `usual` is given,
/// parameters with that value are omitted.
void addNumbers(std::string_view name, const ArmRow& row, const std::optional<double>& usual, FlowMap& map) {
  deflection::visitNumbers(
      [&](const deflection::RowNumber& about, const double& number) {
        const std::string_view key = deflection::keyIn(name, about);
        if (!key.empty() && number != usual && number != about.left_out)
          map.add(key, number, dimensionOf(about.quantity));
      },
      row);
}

/// Returns row k in the Denavit-Hartenberg convention of its file.
ArmRow rowAsWritten(const std::vector<ArmRow>& rows, std::size_t k) {
  ArmRow row = rows[k];
  if (deflection::isStandard(rows) && deflection::dhOf(row)) row.placement = deflection::standardNumbers(rows, k);
  return row;
}

std::string placementText(const ArmRow& row, const Units& units) {
  FlowMap map(units);
  if (deflection::dhOf(row)) {
    addNumbers("dh", row, {}, map);
    return "dh: " + map.text();
  }
  const auto& origin = std::get<deflection::Origin<double>>(row.placement);
  map.add("position", origin.position, dimension::kLength);
  map.add("rpy", origin.rpy, dimension::kAngle);
  map.addUnless(0, "beta", origin.beta, dimension::kAngle);
  return "origin: " + map.text();
}

std::string followsText(const Arm& arm, const deflection::Joint<double>& joint) {
  std::vector<std::string> terms;
  for (const auto& followed : joint.follows)
    terms.push_back(fmt::format("{}: {}", yamlName(arm.rows[static_cast<std::size_t>(followed.row)].joint.name),
                                formatNumber(followed.ratio)));
  return fmt::format("{{{}}}", fmt::join(terms, ", "));
}

std::string jointText(const Arm& arm, const deflection::Joint<double>& joint, const Units& units) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const Dimension unit = joint.type == JointType::kPrismatic ? dimension::kLength : dimension::kAngle;
  FlowMap map(units);
  map.add("name", yamlName(joint.name));
  map.add("type", joint.type == JointType::kPrismatic ? "prismatic" : "revolute");
  map.addUnless(0, "offset", joint.offset, unit);
  if (!joint.follows.empty()) {
    map.add("follows", followsText(arm, joint));
    return map.text();
  }
  if (std::isfinite(joint.lower) && std::isfinite(joint.upper))
    map.add("limits", fmt::format("[{}, {}]", formatNumber(units.toFile(joint.lower, unit)),
                                  formatNumber(units.toFile(joint.upper, unit))));
  map.addUnless(kNone, "max_speed", joint.max_speed, unit);
  map.addUnless(kNone, "max_acceleration", joint.max_acceleration, unit);
  map.addUnless(0, "encoder_sigma", joint.encoder_sigma, unit);
  map.addUnless(0, "gear_ratio", joint.gear_ratio, dimension::kNone);
  return map.text();
}

std::string beamText(const ArmRow& row, const Units& units) {
  FlowMap map(units);
  addNumbers("beam", row, deflection::kRigid, map);
  map.addUnless(1, "segments", row.beam->segments, dimension::kNone);
  return map.text();
}

std::string weightText(const ArmRow& row, const Units& units) {
  FlowMap map(units);
  addNumbers("weight", row, 0, map);
  std::vector<std::string> lumps;
  for (const auto& lump : row.weight.lumps) {
    FlowMap lump_map(units);
    lump_map.add("weight", lump.weight, dimension::kForce);
    lump_map.add("at", lump.at, dimension::kLength);
    lumps.push_back(lump_map.text());
  }
  if (!lumps.empty()) map.add("lumps", fmt::format("[{}]", fmt::join(lumps, ", ")));
  return map.empty() ? "" : map.text();
}

/// Returns the YAML text of a row as a list item, indented by `margin`.
std::string rowText(const Arm& arm, const ArmRow& row, const Units& units, const char* margin) {
  std::string text = fmt::format("{}- name: {}\n", margin, yamlName(row.name));
  const auto add = [&](const std::string& entry) { text += fmt::format("{}  {}\n", margin, entry); };
  add(placementText(row, units));
  if (!row.joint.name.empty()) add("joint: " + jointText(arm, row.joint, units));
  FlowMap stiffness(units);
  addNumbers("joint_stiffness", row, deflection::kRigid, stiffness);
  if (!stiffness.empty()) add("joint_stiffness: " + stiffness.text());
  if (row.beam) add("beam: " + beamText(row, units));
  if (const std::string weight = weightText(row, units); !weight.empty()) add("weight: " + weight);
  return text;
}

/// Returns the YAML text of the first joint axis of rows in the standard convention; empty for other conventions, or if
/// the axis is the z axis of the frame before it.
std::string axisText(const std::vector<ArmRow>& rows, const Units& units) {
  const auto* dh = deflection::isStandard(rows) ? deflection::dhOf(rows.front()) : nullptr;
  if (!dh) return "";
  FlowMap map(units);
  map.addUnless(0, "alpha", dh->alpha, dimension::kAngle);
  map.addUnless(0, "a", dh->a, dimension::kLength);
  map.addUnless(0, "beta", dh->beta, dimension::kAngle);
  map.addUnless(0, "b", dh->b, dimension::kLength);
  return map.empty() ? "" : map.text();
}

/// Returns the YAML text of those rows that the file states explicitly.
std::string rowsText(const Arm& arm, const std::vector<ArmRow>& rows, const Units& units, const char* margin) {
  std::string text;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows[k].is_written) text += rowText(arm, rowAsWritten(rows, k), units, margin);
    if (const auto axis = k == 0 ? axisText(rows, units) : ""; !axis.empty())
      text += fmt::format("{}  axis: {}\n", margin, axis);
  }
  return text;
}

}  // namespace

std::string armYaml(const Arm& arm, const Units& units, ToolAxis tool_axis) {
  std::string text =
      fmt::format("units: {{length: {}, angle: {}, force: {}, temperature: {}, time: {}}}\n", units.length().name,
                  units.angle().name, units.force().name, units.temperature().name, units.time().name);
  if (!arm.name.empty()) text += fmt::format("name: {}\n", yamlName(arm.name));
  if (deflection::isStandard(arm.rows)) text += "convention: standard\n";
  const FlowMap map(units);
  for (const auto& kind : deflection::kConditionKinds)
    if (const double reference = arm.reference[kind.condition]; reference != kind.usual)
      text += fmt::format("{}: {}\n", referenceKey(kind), formatNumber(units.toFile(reference, kind.unit)));
  text += fmt::format("gravity: {}\nlinks:\n", map.listOf(arm.gravity_W, dimension::kNone));
  text += rowsText(arm, arm.rows, units, "  ");
  if (!arm.side_chains.empty()) text += "side_chains:\n";
  for (const auto& chain : arm.side_chains) {
    text += fmt::format("  - on: {}\n    links:\n", yamlName(arm.rows[static_cast<std::size_t>(chain.row)].name));
    text += rowsText(arm, chain.rows, units, "      ");
  }
  const std::string turned =
      arm.R_LT.isIdentity(1e-15) ? "" : ", rpy: " + map.listOf(deflection::fixedAnglesOf(arm.R_LT), dimension::kAngle);
  FlowMap turn(units);
  for (int k = 0; k < 3; ++k)
    turn.addUnless(0, std::string_view("xyz").substr(static_cast<std::size_t>(k), 1), arm.tool_turn_L[k],
                   dimension::kAngle);
  const std::string turned_further = turn.empty() ? "" : ", turn: " + turn.text();
  const std::string axis =
      tool_axis == ToolAxis::kLeftOut ? "" : ", axis: " + map.listOf(arm.tool_axis_L, dimension::kNone);
  return text + fmt::format("tool: {{tip: {}{}{}{}}}\n", map.listOf(arm.p_LT, dimension::kLength), axis, turned,
                            turned_further);
}

}  // namespace tubeplan::app
