#include "app/formats/urdf/urdf_remarks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

using Eigen::Vector3d;

constexpr double kDegreeOfTurn = std::numbers::pi / 180;
constexpr double kRounded = 5e-3;            // largest rounding error of an angle such as 3.14, 1.57 or 6.28 [rad]
constexpr double kSeenAtTip = 1e-5;          // smallest tip error that an instrument can resolve [m]
constexpr double kManyDigits = 1e-6;         // rounding error of an angle with many digits, such as 3.141593 [rad]
constexpr double kImplausibleDistance = 20;  // implausible distance between two joints [m]

/// Returns the positions of a chain's joints at zero readings [m]; the last entry is the tip.
std::vector<Vector3d> placesOf(const std::vector<const UrdfTree::Link*>& chain) {
  std::vector<Vector3d> places;
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  for (const auto& link : chain) {
    X = X * link->joint->origin.pose();
    places.push_back(X.translation());
  }
  if (!places.empty()) places.push_back(places.back());
  return places;
}

/// Returns the number of decimals in the shortest notation of an angle that is read back as the same number.
int decimalsIn(double angle) {
  const std::string text = fmt::format("{}", angle);
  const std::size_t point = text.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

/// Round angle that was written with few digits, and its rounding error `off` [rad]. An angle with more digits than its
/// deviation from a round angle explains is assumed to be measured. Two decimals are enough for multiples of a right
/// angle; other multiples of 30 and 45 deg need three.
struct RoundedAngle {
  double degrees, off;
};
std::optional<RoundedAngle> roundedAngleOf(double angle) {
  const int decimals = decimalsIn(angle);
  for (const double step : {90., 45., 30.}) {
    const double rounded = std::round(angle / (step * kDegreeOfTurn)) * step,
                 off = std::abs(angle - rounded * kDegreeOfTurn);
    if (rounded != 0 && off <= kRounded && off < std::pow(10, -decimals) && (step == 90 || decimals > 2))
      return RoundedAngle{rounded, off};
  }
  return {};
}

std::string remarkOnPlace(const UrdfTree::Joint& joint) {
  const double far = joint.origin.xyz.norm();
  if (far <= kImplausibleDistance) return "";
  return fmt::format("its origin is {:.4g} m from its parent's: millimetres in a file of metres?", far);
}

/// Returns a remark if the limits of a revolute joint may be in degrees; otherwise empty.
std::string remarkOnLimits(const UrdfTree::Joint& joint) {
  constexpr double kTwoTurns = 4 * std::numbers::pi, kTwoTurnsInDegrees = 720;
  if (joint.type != "revolute" || !joint.limits) return "";
  const double most = std::max(std::abs(joint.limits->lower), std::abs(joint.limits->upper));
  if (most <= kTwoTurns + kRounded || most > kTwoTurnsInDegrees) return "";
  return fmt::format("limits from {:g} to {:g} are more than two turns: degrees in a file of radians?",
                     joint.limits->lower, joint.limits->upper);
}

/// Sum of those rounding errors that are too small for separate remarks.
struct SmallRounding {
  std::vector<std::string> joints;
  double turn = 0, move = 0;  // sums of rotations and displacements of the tip [rad, m]

  void add(const std::string& joint, double off, double lever) {
    if (joints.empty() || joints.back() != joint) joints.push_back(joint);
    turn += off;
    move += off * lever;
  }
  [[nodiscard]] std::string remark() const {
    return fmt::format(
        "joint{} {}: round angles written with few digits, which together turn the tool by up to {:.2g} mrad and move "
        "its tip by up to {:.2g} mm",
        joints.size() > 1 ? "s" : "", fmt::join(joints, ", "), turn * 1e3, move * 1e3);
  }
};

/// Returns a remark on an angle; empty if there is none. A small rounding error is added to `small` instead.
std::string remarkOnAngle(double angle, double lever, const std::string& joint, SmallRounding& small) {
  if (std::abs(angle) > 2 * std::numbers::pi + kRounded)
    return fmt::format("rpy {:g} is more than a turn: degrees in a file of radians?", angle);
  const auto rounded = roundedAngleOf(angle);
  if (!rounded) return "";
  if (rounded->off * lever < kSeenAtTip) {
    if (rounded->off > kManyDigits) small.add(joint, rounded->off, lever);
    return "";
  }
  return fmt::format("rpy {:.10g} is {:+.0f} deg rounded, {:.2g} mrad off: that moves the tip by up to {:.2g} mm",
                     angle, rounded->degrees, rounded->off * 1e3, rounded->off * lever * 1e3);
}

}  // namespace

std::vector<std::string> remarksOnNumbers(const std::vector<const UrdfTree::Link*>& chain) {
  std::vector<std::string> remarks;
  SmallRounding small;
  const auto places = placesOf(chain);
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const UrdfTree::Joint& joint = *chain[k]->joint;
    const std::string name = nameInLine(joint.name);
    const auto add = [&](const std::string& remark) {
      if (!remark.empty()) remarks.push_back(fmt::format("joint {}: {}", name, remark));
    };
    add(remarkOnPlace(joint));
    add(remarkOnLimits(joint));
    for (const double angle : joint.origin.rpy)
      add(remarkOnAngle(angle, (places.back() - places[k]).norm(), name, small));
  }
  if (!small.joints.empty()) remarks.push_back(small.remark());
  return remarks;
}

}  // namespace tubeplan::app
