#include "app/files/robot_kinematics.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <numbers>
#include <variant>

#include "app/files/arm_reader.hpp"
#include "app/files/input_error.hpp"
#include "app/files/yaml/yaml_edit.hpp"
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

/// The same place seen from a base half a turn about z.
LinkOrigin halfTurned(const LinkOrigin& origin) {
  return {{-origin.position.x(), -origin.position.y(), origin.position.z()},
          {origin.rpy.x(), origin.rpy.y(), origin.rpy.z() + std::numbers::pi},
          0};
}

/// The row's origin in the nominal file, where it may be replaced.
const LinkOrigin& nominalOrigin(const YamlFile& nominal, const deflection::Row<double>& row) {
  const auto* origin = std::get_if<LinkOrigin>(&row.placement);
  if (!origin)
    throw InputError(nominal.path, "the row " + inQuotes(row.name) + " by dh", "rows by origin, as the robot's URDF",
                     "take the arm that `arm import robot.urdf` makes, or `arm export --convention origin`");
  if (row.joint.type != deflection::JointType::kRevolute || row.joint.offset != 0 || origin->beta != 0)
    throw InputError(nominal.path, "the row " + inQuotes(row.name),
                     "revolute joints without offset or beta: the origins hold all that was calibrated");
  return *origin;
}

void refuseOtherModel(const YamlFile& nominal, const std::string& row, const LinkOrigin& from, const LinkOrigin& to) {
  constexpr double kFarthest = 0.05, kMostTurned = 10 * std::numbers::pi / 180;
  const double moved = (from.position - to.position).norm(), turned = angleBetween(from, to);
  if (moved <= kFarthest && turned <= kMostTurned) return;
  throw InputError(nominal.path,
                   fmt::format("the row {}, which would move by {:.1f} mm and {:.2f} deg", inQuotes(row), moved * 1000,
                               turned * 180 / std::numbers::pi),
                   "no more than 50 mm and 10 deg: the nominal arm of the same model, joints turning about z",
                   "import the URDF of ur_description of this model and name that arm with --nominal");
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
  if (active.size() != kinematics.origins.size())
    throw InputError(nominal.path, fmt::format("{} joints", active.size()), "6, as the kinematics file has origins");
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

}  // namespace tubeplan::app
