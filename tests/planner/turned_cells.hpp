// Equivalent forms of one task: a cell's files in other units, the cell rotated about the sheet's normal, or the arm
// described in another base frame. The plan must not change. Also tasks with tilted gravity or a tilted base, whose
// plans do change.
#pragma once

#include <fmt/format.h>

#include <map>
#include <random>

#include "app/formats/arm/arm_writer.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner::testing {

/// New values for numbers in a YAML text: maps the offset of each old number to its length in characters and its new
/// value.
using NewNumbers = std::map<std::size_t, std::pair<std::size_t, double>>;

inline void setNumber(const app::YamlNode& node, double value, NewNumbers& numbers) {
  numbers[node.begin] = {node.scalar.size(), value};
}

inline std::string withNumbers(const std::string& text, const NewNumbers& numbers) {
  std::string out;
  std::size_t at = 0;
  for (const auto& [begin, change] : numbers) {
    out += text.substr(at, begin - at) + fmt::format("{:.17g}", change.second);
    at = begin + change.first;
  }
  return out + text.substr(at);
}

inline void scaleLengths(const app::YamlNode& node, double factor, bool is_length, NewNumbers& numbers) {
  static const std::vector<std::string> kLengths{"position", "pitch",   "first_row", "radius",   "hole_diameter",
                                                 "diameter", "lengths", "center",    "size",     "from",
                                                 "to",       "point",   "clearance", "tolerance"};
  if (is_length && node.kind == app::YamlNode::Kind::kScalar) setNumber(node, factor * node.number(), numbers);
  for (std::size_t k = 0; k < node.items.size(); ++k) {
    const bool is_named = node.kind == app::YamlNode::Kind::kMap && std::ranges::count(kLengths, node.keys[k]) > 0;
    scaleLengths(node.items[k], factor, is_named || (is_length && node.kind == app::YamlNode::Kind::kList), numbers);
  }
}

/// Returns the cell read from files with lengths in `unit`, and torques and pressures in matching units.
inline Workcell inUnitOf(const std::string& file, const std::string& unit) {
  const std::string path = TUBEPLAN_SOURCE_DIR "/app/cells/" + file;
  const app::Cell cell = app::readCell(path);
  const app::Units units(app::parseYaml(fmt::format("{{length: {}, angle: deg, force: N}}", unit), "units"));
  NewNumbers numbers;
  scaleLengths(cell.source.root, cell.units.length().factor / units.length().factor, false, numbers);
  return app::workcellOf(app::parseCell(withNumbers(cell.source.text, numbers), path, app::armYaml(cell.arm, units)),
                         "test the planner");
}

inline void turnShapes(const app::YamlNode& node, double angle, NewNumbers& numbers) {
  static const std::vector<std::string> kVectors{"position", "center", "from", "to", "point", "normal"};
  for (std::size_t k = 0; k < node.items.size(); ++k) {
    const app::YamlNode& item = node.items[k];
    const std::string key = node.kind == app::YamlNode::Kind::kMap ? node.keys[k] : "";
    if (std::ranges::count(kVectors, key)) {
      const double x = item.items[0].number(), y = item.items[1].number();
      setNumber(item.items[0], std::cos(angle) * x - std::sin(angle) * y, numbers);
      setNumber(item.items[1], std::sin(angle) * x + std::cos(angle) * y, numbers);
    } else if (key == "rpy") {
      setNumber(item.items[2], item.items[2].number() + angle / kDegree, numbers);
    } else {
      turnShapes(item, angle, numbers);
    }
  }
}

/// Returns `text` with `rpy: [0, 0, 0]` added to every box without a rotation.
inline std::string withBoxesTurnable(std::string text) {
  const std::string size = "size: [";
  for (std::size_t at = 0; (at = text.find(size, at)) != std::string::npos; at += size.size()) {
    const std::size_t end = text.find(']', at) + 1;
    if (text.find("rpy", end) > text.find('}', end)) text.insert(end, ", rpy: [0, 0, 0]");
  }
  return text;
}

/// Returns the cell with sheet, base, obstacles and gravity rotated by `angle` [rad] about the sheet's normal.
inline Workcell turnedAboutTheNormal(const std::string& file, double angle) {
  const std::string path = TUBEPLAN_SOURCE_DIR "/app/cells/" + file;
  const std::string text = withBoxesTurnable(app::readCell(path).source.text);
  const app::YamlNode root = app::parseYaml(text, path);
  NewNumbers numbers;
  for (const char* key : {"base", "scene"})
    if (const app::YamlNode* node = root.find(key)) turnShapes(*node, angle, numbers);
  Workcell cell = app::workcellOf(app::parseCell(withNumbers(text, numbers), path), "test the planner");
  const Eigen::AngleAxisd turn(angle, kHoleAxis_W);
  cell.arm.gravity_W = turn * cell.arm.gravity_W;
  for (auto& tube : cell.sheet.tubes) {
    const Eigen::Vector3d centre = turn * holeCentre(tube);
    tube.x = centre.x();
    tube.y = centre.y();
  }
  return cell;
}

/// Returns the cell with the same arm at the same position, described with a fixed first row and another base frame.
inline Workcell fromAnotherBaseFrame(Workcell cell, std::mt19937_64& generator) {
  const auto angle = [&] { return uniform(generator, -3, 3); };
  auto mount = decltype(cell.arm.rows)::value_type{};
  mount.name = "another-frame";
  const Eigen::Vector3d p(0.1 * angle(), 0.1 * angle(), 0.1 * angle()), rpy(angle(), angle() / 3, angle());
  mount.placement = deflection::Origin<double>{p, rpy};
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = p;
  X.linear() =
      (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  cell.X_WB = cell.X_WB * X.inverse();
  cell.arm.rows.insert(cell.arm.rows.begin(), mount);
  cell.scene.links.insert(cell.scene.links.begin(), {mount.name, false});
  for (auto& body : cell.scene.bodies) ++body.frame_index;
  return cell;
}

inline Eigen::AngleAxisd leanOf(double degrees, double heading) {
  return Eigen::AngleAxisd(degrees * kDegree, Eigen::Vector3d(std::cos(heading), std::sin(heading), 0));
}

inline Workcell withBaseLeaning(Workcell cell, double degrees, double heading) {
  cell.X_WB.rotate(cell.X_WB.linear().transpose() * leanOf(degrees, heading) * cell.X_WB.linear());
  return cell;
}

/// Returns the cell with gravity tilted [deg], which is equivalent to a common tilt of sheet, base and obstacles.
inline Workcell withGravityLeaning(Workcell cell, double degrees, double heading) {
  cell.arm.gravity_W = leanOf(degrees, heading) * cell.arm.gravity_W;
  return cell;
}

}  // namespace tubeplan::planner::testing
