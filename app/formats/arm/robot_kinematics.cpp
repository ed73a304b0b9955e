#include "app/formats/arm/robot_kinematics.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

#include "app/formats/arm/arm_numbers.hpp"
#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/yaml/yaml_edit.hpp"
#include "app/formats/yaml/yaml_text.hpp"
#include "app/storage/input_error.hpp"
#include "deflection/chain.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::app {

namespace {

using LinkOrigin = deflection::Origin<double>;

constexpr std::array<const char*, 6> kLinks{"shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3"};

LinkOrigin readLinkOrigin(const YamlNode& node) {
  node.expectKeys({"x", "y", "z", "roll", "pitch", "yaw"}, {});
  const auto number = [&](const char* key) { return node.at(key).number(); };
  return {{number("x"), number("y"), number("z")}, {number("roll"), number("pitch"), number("yaw")}, 0};
}

double angleBetween(const LinkOrigin& a, const LinkOrigin& b) {
  using deflection::rotationFromFixedAngles;
  const Eigen::Matrix3d turn =
      rotationFromFixedAngles<double>(a.rpy).transpose() * rotationFromFixedAngles<double>(b.rpy);
  return Eigen::AngleAxisd(turn).angle();
}

/// Returns an origin relative to a base frame that is rotated by half a turn about z.
LinkOrigin halfTurned(const LinkOrigin& origin) {
  return {{-origin.position.x(), -origin.position.y(), origin.position.z()},
          {origin.rpy.x(), origin.rpy.y(), origin.rpy.z() + std::numbers::pi},
          0};
}

/// Returns the origin of a row of the arm in `file`. Throws InputError if the row has none.
const LinkOrigin& originIn(const std::string& file, const deflection::Row<double>& row) {
  const auto* origin = std::get_if<LinkOrigin>(&row.placement);
  if (!origin)
    throw InputError::problem(
        file, fmt::format("the row {} has `dh`, not `origin` as in the robot's URDF", inQuotes(row.name)),
        "use the arm that `arm import robot.urdf` makes, or convert this one with `arm export --convention origin`");
  return *origin;
}

/// Returns the origin of a row in the nominal arm file. Throws InputError unless the joint is revolute and has neither
/// an offset nor a beta.
const LinkOrigin& nominalOrigin(const YamlFile& nominal, const deflection::Row<double>& row) {
  const LinkOrigin& origin = originIn(nominal.path, row);
  if (row.joint.type != deflection::JointType::kRevolute || row.joint.offset != 0 || origin.beta != 0)
    throw InputError::problem(
        nominal.path,
        fmt::format("the row {} {}", inQuotes(row.name),
                    row.joint.type != deflection::JointType::kRevolute
                        ? "has no revolute joint"
                        : "has a joint offset or a beta, but the kinematics file contains the whole calibration"),
        "give --nominal the arm that `arm import robot.urdf` makes from the robot's URDF");
  return origin;
}

void requireSixJoints(const std::string& file, std::size_t joints) {
  if (joints != kLinks.size())
    throw InputError(file, fmt::format("{} joints", joints), "6, one for each origin in the kinematics file",
                     "use the two files of the same arm");
}

/// Returns the row's origin combined with the row's tilt beta and the joint's offset; unchanged if both are zero.
LinkOrigin calibratedOrigin(const std::string& file, const deflection::Row<double>& row) {
  const LinkOrigin& own = originIn(file, row);
  if (own.beta == 0 && row.joint.offset == 0) return own;
  const Eigen::Matrix3d turn =
      deflection::rotationFromPrevious<double>(row) * deflection::rotationZ<double>(row.joint.offset);
  return {own.position, deflection::fixedAnglesOf(turn), 0};
}

/// Converts the origin `second` from the frame of `first` to the parent frame of `first`.
LinkOrigin behind(const LinkOrigin& first, const LinkOrigin& second) {
  const Eigen::Matrix3d turn = deflection::rotationFromFixedAngles<double>(first.rpy);
  return {first.position + turn * second.position,
          deflection::fixedAnglesOf(turn * deflection::rotationFromFixedAngles<double>(second.rpy)), 0};
}

void refuseOtherModel(const YamlFile& nominal, const std::string& row, const LinkOrigin& from, const LinkOrigin& to) {
  constexpr double kFarthest = 0.05, kMostTurned = 10 * std::numbers::pi / 180;
  const double moved = (from.position - to.position).norm(), turned = angleBetween(from, to);
  if (moved <= kFarthest && turned <= kMostTurned) return;
  throw InputError::problem(
      nominal.path,
      fmt::format(
          "the row {} would move by {:.1f} mm and {:.2f} deg, more than 50 mm or 10 deg: this is not the nominal "
          "arm of the same model, with joints turning about z",
          inQuotes(row), moved * 1000, turned * 180 / std::numbers::pi),
      "import the URDF of this model from ur_description, and give that arm with --nominal");
}

}  // namespace

RobotKinematics readRobotKinematics(const YamlNode& root) {
  root.expectKeys({"kinematics"}, {});
  const YamlNode& node = root.at("kinematics");
  node.expectKeys({kLinks.begin(), kLinks.end()}, {"hash"});
  RobotKinematics kinematics;
  for (std::size_t k = 0; k < kLinks.size(); ++k) kinematics.origins[k] = readLinkOrigin(node.at(kLinks[k]));
  if (const YamlNode* hash = node.find("hash")) kinematics.hash = hash->text();
  return kinematics;
}

std::string withRobotKinematics(const YamlFile& nominal, const RobotKinematics& kinematics) {
  const ArmSource source = readArm(nominal.root);
  const auto active = deflection::activeRows(source.arm);
  requireSixJoints(nominal.path, active.size());
  std::string text = nominal.text;
  const auto write = [&](const std::string& row, const char* list, const Eigen::Vector3d& values, Dimension unit) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::string name = fmt::format("{}.origin.{}.{}", row, list, (unit.angle == 0 ? "xyz" : "rpy")[axis]);
      text = withYamlValue(text, armPath(nominal.root, name), formatNumber(source.units.toFile(values[axis], unit)));
    }
  };
  for (std::size_t k = 0; k < active.size(); ++k) {
    const auto& row = source.arm.rows[static_cast<std::size_t>(active[k])];
    const LinkOrigin& drawn = nominalOrigin(nominal, row);
    LinkOrigin origin = kinematics.origins[k];
    if (k == 0 && angleBetween(drawn, origin) > std::numbers::pi / 2) origin = halfTurned(origin);
    refuseOtherModel(nominal, row.name, drawn, origin);
    write(row.name, "position", origin.position, dimension::kLength);
    write(row.name, "rpy", origin.rpy, dimension::kAngle);
  }
  return text;
}

std::string robotKinematicsText(const RobotKinematics& kinematics) {
  std::string text = "kinematics:\n";
  for (std::size_t k = 0; k < kLinks.size(); ++k) {
    const LinkOrigin& origin = kinematics.origins[k];
    text += fmt::format("  {}:\n", kLinks[k]);
    for (int axis = 0; axis < 3; ++axis) text += fmt::format("    {}: {}\n", "xyz"[axis], origin.position[axis] + 0.);
    constexpr std::array kTurns{"roll", "pitch", "yaw"};
    for (int axis = 0; axis < 3; ++axis)
      text += fmt::format("    {}: {}\n", kTurns[static_cast<std::size_t>(axis)], origin.rpy[axis] + 0.);
  }
  return kinematics.hash.empty() ? text : text + fmt::format("  hash: {}\n", yamlName(kinematics.hash));
}

RobotKinematics robotKinematicsOf(const deflection::Arm& arm, const std::string& file) {
  RobotKinematics kinematics;
  requireSixJoints(file, deflection::activeRows(arm).size());
  std::size_t joints = 0;
  std::optional<LinkOrigin> passive;  // combined origin of the passive rows before the next joint
  for (const auto& row : arm.rows) {
    if (joints == kinematics.origins.size()) break;
    const LinkOrigin own = calibratedOrigin(file, row);
    const LinkOrigin origin = passive ? behind(*passive, own) : own;
    passive.reset();
    if (row.joint.type == deflection::JointType::kPassive)
      passive = origin;
    else if (row.joint.type == deflection::JointType::kRevolute && row.joint.follows.empty())
      kinematics.origins[joints++] = origin;
    else
      throw InputError::problem(
          file, fmt::format("the joint {} slides or follows others", inQuotes(row.joint.name)),
          "export an arm file with --convention instead: a kinematics file holds independent revolute joints only");
  }
  LinkOrigin& base = kinematics.origins.front();
  if (angleBetween(base, LinkOrigin{}) > std::numbers::pi / 2) {
    base = halfTurned(base);
    base.rpy.z() = std::remainder(base.rpy.z(), 2 * std::numbers::pi);
  }
  return kinematics;
}

}  // namespace tubeplan::app
