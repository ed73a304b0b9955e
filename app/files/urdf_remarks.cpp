#include "app/files/urdf_remarks.hpp"

#include <fmt/format.h>
#include <urdf_model/model.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "app/files/input_error.hpp"

namespace tubeplan::app {

namespace {

using Eigen::Vector3d;

constexpr double kRightAngle = std::numbers::pi / 2;
constexpr double kRounded = 5e-3;    // rad: 3.14, 1.57 and 6.28 are nearer to what they stand for
constexpr double kSeenAtTip = 1e-5;  // m: what fewer digits than that cost no instrument sees

/// Where each joint of the chain is at zero readings; the last entry is the tip.
std::vector<Vector3d> placesOf(const std::vector<urdf::LinkConstSharedPtr>& chain) {
  std::vector<Vector3d> places;
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  for (const auto& link : chain) {
    const auto& pose = link->parent_joint->parent_to_joint_origin_transform;
    const Eigen::Quaterniond turn(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
    X = X * Eigen::Translation3d(pose.position.x, pose.position.y, pose.position.z) * turn.normalized();
    places.push_back(X.translation());
  }
  if (!places.empty()) places.push_back(places.back());
  return places;
}

/// Whether an angle that is off by so much has no more decimals than that leaves: one that was measured has more.
bool hasFewDecimals(double angle, double off) {
  const std::string text = fmt::format("{}", angle);
  const std::size_t point = text.find('.');
  const auto decimals = static_cast<double>(point == std::string::npos ? 0 : text.size() - point - 1);
  return off < std::pow(10, -decimals);
}

/// Empty where there is nothing to say of that angle.
std::string remarkOn(double angle, double lever) {
  if (std::abs(angle) > 4 * kRightAngle + kRounded)
    return fmt::format("rpy {:g} is more than a turn: degrees in a file of radians?", angle);
  const double whole = std::round(angle / kRightAngle) * kRightAngle, off = std::abs(angle - whole);
  if (whole == 0 || off > kRounded || off * lever < kSeenAtTip || !hasFewDecimals(angle, off)) return "";
  return fmt::format("rpy {:.10g} is {:+.0f} deg rounded, {:.2g} mrad off: that moves the tip by up to {:.2g} mm",
                     angle, whole * 180 / std::numbers::pi, off * 1e3, off * lever * 1e3);
}

}  // namespace

std::vector<std::string> remarksOnTurns(const std::vector<urdf::LinkConstSharedPtr>& chain, const WrittenTurns& turns) {
  std::vector<std::string> remarks;
  const auto places = placesOf(chain);
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const std::string& joint = chain[k]->parent_joint->name;
    const auto written = turns.find(joint);
    if (written == turns.end()) continue;
    for (const double angle : written->second)
      if (const std::string remark = remarkOn(angle, (places.back() - places[k]).norm()); !remark.empty())
        remarks.push_back(fmt::format("joint {}: {}", nameInLine(joint), remark));
  }
  return remarks;
}

}  // namespace tubeplan::app
