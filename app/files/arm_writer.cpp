#include "app/files/arm_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <cmath>

#include "deflection/chain.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::app {

namespace {

using deflection::Arm, deflection::JointType;
using Eigen::Vector3d;
using ArmRow = deflection::Row<double>;

constexpr double kGravity = 9.80665;  // m/s^2, as in urdf_reader.cpp

/// A map in one line, key after key.
class FlowMap {
 public:
  explicit FlowMap(const Units& units) : units_(units) {}
  void add(const char* key, const std::string& value) { entries_.push_back(fmt::format("{}: {}", key, value)); }
  void add(const char* key, double value, Dimension dimension) {
    add(key, formatNumber(units_.toFile(value, dimension)));
  }
  void addUnless(double usual, const char* key, double value, Dimension dimension) {
    if (value != usual) add(key, value, dimension);
  }
  void add(const char* key, const Vector3d& value, Dimension dimension) { add(key, listOf(value, dimension)); }
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

std::string quoted(const std::string& name) {
  const bool is_plain =
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") == std::string::npos &&
      !name.empty() && std::isalpha(static_cast<unsigned char>(name.front()));
  if (is_plain) return name;
  std::string out = "\"";
  for (const char c : name) out += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  return out + "\"";
}

std::string placementText(const ArmRow& row, const Units& units) {
  FlowMap map(units);
  if (const auto* dh = std::get_if<deflection::DenavitHartenberg<double>>(&row.placement)) {
    map.add("alpha", dh->alpha, dimension::kAngle);
    map.add("a", dh->a, dimension::kLength);
    map.add("d", dh->d, dimension::kLength);
    map.add("theta", dh->theta, dimension::kAngle);
    return "dh: " + map.text();
  }
  const auto& origin = std::get<deflection::Origin<double>>(row.placement);
  map.add("position", origin.position, dimension::kLength);
  map.add("rpy", origin.rpy, dimension::kAngle);
  return "origin: " + map.text();
}

std::string followsText(const Arm& arm, const deflection::Joint<double>& joint) {
  std::vector<std::string> terms;
  for (const auto& followed : joint.follows)
    terms.push_back(fmt::format("{}: {}", quoted(arm.rows[static_cast<std::size_t>(followed.row)].joint.name),
                                formatNumber(followed.ratio)));
  return fmt::format("{{{}}}", fmt::join(terms, ", "));
}

std::string jointText(const Arm& arm, const deflection::Joint<double>& joint, const Units& units) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const Dimension unit = joint.type == JointType::kPrismatic ? dimension::kLength : dimension::kAngle;
  FlowMap map(units);
  map.add("name", quoted(joint.name));
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

std::string beamText(const deflection::Beam<double>& beam, const Units& units) {
  constexpr const char* kInertias[] = {"Ix", "Iy", "Iz"};
  FlowMap map(units);
  map.addUnless(deflection::kRigid, "E", beam.E, dimension::kPressure);
  for (int k = 0; k < 3; ++k) map.addUnless(deflection::kRigid, kInertias[k], beam.I[k], dimension::kLengthToTheFourth);
  map.addUnless(deflection::kRigid, "G", beam.G, dimension::kPressure);
  map.addUnless(deflection::kRigid, "J", beam.J, dimension::kLengthToTheFourth);
  map.addUnless(1, "segments", beam.segments, dimension::kNone);
  return map.text();
}

std::string weightText(const deflection::Weight<double>& weight, const Units& units) {
  FlowMap map(units);
  map.addUnless(0, "distributed", weight.distributed, dimension::kForcePerLength);
  map.addUnless(0, "end", weight.end, dimension::kForce);
  std::vector<std::string> lumps;
  for (const auto& lump : weight.lumps) {
    FlowMap one(units);
    one.add("weight", lump.weight, dimension::kForce);
    one.add("at", lump.at, dimension::kLength);
    lumps.push_back(one.text());
  }
  if (!lumps.empty()) map.add("lumps", fmt::format("[{}]", fmt::join(lumps, ", ")));
  return map.empty() ? "" : map.text();
}

std::string rowText(const Arm& arm, const ArmRow& row, const Units& units) {
  constexpr const char* kAxes[] = {"x", "y", "z"};
  std::string text = fmt::format("  - name: {}\n    {}\n", quoted(row.name), placementText(row, units));
  if (!row.joint.name.empty()) text += fmt::format("    joint: {}\n", jointText(arm, row.joint, units));
  FlowMap stiffness(units);
  for (int k = 0; k < 3; ++k)
    stiffness.addUnless(deflection::kRigid, kAxes[k], row.joint_stiffness[k], dimension::kTorquePerAngle);
  if (!stiffness.empty()) text += fmt::format("    joint_stiffness: {}\n", stiffness.text());
  if (row.beam) text += fmt::format("    beam: {}\n", beamText(*row.beam, units));
  if (const std::string weight = weightText(row.weight, units); !weight.empty())
    text += fmt::format("    weight: {}\n", weight);
  return text;
}

std::string triple(const Vector3d& v) { return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z()); }

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  return out;
}

/// All that hangs from a row, as one mass [kg] at its centre in the row's frame. `to_next` as in chain.hpp.
std::string inertialText(const ArmRow& row, const Vector3d& to_next) {
  double weight = row.weight.end + row.weight.distributed * to_next.norm();
  Vector3d moment = row.weight.end * to_next + row.weight.distributed * to_next.norm() * to_next / 2;
  for (const auto& lump : row.weight.lumps) weight += lump.weight, moment += lump.weight * lump.at;
  if (!(weight > 0)) return "";
  return fmt::format(
      "    <inertial>\n      <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n      <mass value=\"{:.17g}\"/>\n"
      "      <inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"/>\n    </inertial>\n",
      triple(moment / weight), weight / kGravity);
}

class UrdfWriter {
 public:
  explicit UrdfWriter(const Arm& arm) : arm_(arm) {}

  UrdfText write() {
    text_ = fmt::format("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n  <link name=\"base\"/>\n",
                        escaped(arm_.name.empty() ? "arm" : arm_.name));
    std::string parent = "base";
    for (std::size_t k = 0; k < arm_.rows.size(); ++k) {
      addRow(k, parent);
      parent = arm_.rows[k].name;
    }
    const auto turn = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), arm_.tool_axis_L).toRotationMatrix();
    text_ += "  <link name=\"tip\"/>\n";
    addJoint("tip", "fixed", parent, "tip", arm_.p_LT, turn, "");
    text_ += "</robot>\n";
    if (has_stiffness_) left_out_.emplace_back("stiffnesses and beams: URDF's links are rigid");
    if (!arm_.effects.empty()) left_out_.emplace_back("effects: URDF has no place for them");
    return {std::move(text_), std::move(left_out_)};
  }

 private:
  void addRow(std::size_t k, const std::string& parent) {
    const ArmRow& row = arm_.rows[k];
    has_stiffness_ = has_stiffness_ || row.beam || std::isfinite(row.joint_stiffness.minCoeff());
    const Vector3d to_next = deflection::offsetToNext<double>(arm_, k);
    text_ += fmt::format("  <link name=\"{}\">\n{}  </link>\n", escaped(row.name), inertialText(row, to_next));
    Vector3d position = deflection::offsetInPreviousAxes<double>(row);
    Eigen::Matrix3d turn = deflection::rotationFromPrevious<double>(row);
    const bool slides = row.joint.type == JointType::kPrismatic;
    if (slides) position += turn.col(2) * row.joint.offset;
    if (row.joint.type == JointType::kRevolute) turn = turn * deflection::rotationZ<double>(row.joint.offset);
    const bool is_moving = deflection::turns(row.joint) || slides;
    const std::string name = row.joint.name.empty() ? row.name + "-fixed" : row.joint.name;
    addJoint(name,
             !is_moving             ? "fixed"
             : slides               ? "prismatic"
             : isBounded(row.joint) ? "revolute"
                                    : "continuous",
             parent, row.name, position, turn, is_moving ? limitsText(row.joint) + mimicText(row) : "");
  }

  static bool isBounded(const deflection::Joint<double>& joint) {
    return std::isfinite(joint.lower) && std::isfinite(joint.upper);
  }

  static std::string limitsText(const deflection::Joint<double>& joint) {
    std::string text = "    <axis xyz=\"0 0 1\"/>\n    <limit effort=\"0\"";
    if (isBounded(joint)) text += fmt::format(" lower=\"{:.17g}\" upper=\"{:.17g}\"", joint.lower, joint.upper);
    return text + fmt::format(" velocity=\"{:.17g}\"/>\n", std::isfinite(joint.max_speed) ? joint.max_speed : 0);
  }

  /// URDF lets a joint follow one other, by its reading: the offset of that one is added here.
  std::string mimicText(const ArmRow& row) {
    if (row.joint.follows.empty()) return "";
    if (row.joint.follows.size() > 1)
      left_out_.push_back("all but the first of the joints that " + row.joint.name + " follows");
    const auto& first = row.joint.follows.front();
    const auto& leader = arm_.rows[static_cast<std::size_t>(first.row)].joint;
    return fmt::format("    <mimic joint=\"{}\" multiplier=\"{:.17g}\" offset=\"{:.17g}\"/>\n", escaped(leader.name),
                       first.ratio, row.joint.offset + first.ratio * leader.offset);
  }

  void addJoint(const std::string& name, const char* type, const std::string& parent, const std::string& child,
                const Vector3d& position, const Eigen::Matrix3d& turn, const std::string& more) {
    text_ += fmt::format(
        "  <joint name=\"{}\" type=\"{}\">\n    <origin xyz=\"{}\" rpy=\"{}\"/>\n    <parent link=\"{}\"/>\n"
        "    <child link=\"{}\"/>\n{}  </joint>\n",
        escaped(name), type, triple(position), triple(deflection::fixedAnglesOf(turn)), escaped(parent), escaped(child),
        more);
  }

  const Arm& arm_;
  std::string text_;
  std::vector<std::string> left_out_;
  bool has_stiffness_ = false;
};

}  // namespace

std::string armYaml(const Arm& arm, const Units& units) {
  std::string text =
      fmt::format("units: {{length: {}, angle: {}, force: {}, temperature: {}, time: {}}}\n", units.length().name,
                  units.angle().name, units.force().name, units.temperature().name, units.time().name);
  if (!arm.name.empty()) text += fmt::format("name: {}\n", quoted(arm.name));
  const FlowMap map(units);
  text += fmt::format("gravity: {}\nlinks:\n", map.listOf(arm.gravity_W, dimension::kNone));
  for (const auto& row : arm.rows) text += rowText(arm, row, units);
  return text + fmt::format("tool: {{tip: {}, axis: {}}}\n", map.listOf(arm.p_LT, dimension::kLength),
                            map.listOf(arm.tool_axis_L, dimension::kNone));
}

UrdfText urdfOf(const Arm& arm) { return UrdfWriter(arm).write(); }

}  // namespace tubeplan::app
