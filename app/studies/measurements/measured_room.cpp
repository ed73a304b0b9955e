#include "app/studies/measurements/measured_room.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::app {

namespace {

using calibration::Measurement;
using Eigen::Vector3d;

constexpr double kShortLink = 1e-3;  // shortest link [m]; frames closer than this have no link between them
constexpr double kSlack = 1e-3;      // tolerance for a posture just outside the room [m]

struct Link {
  Vector3d from, to;
};

/// Returns the links in the world frame, from base to tip; empty if the solution for the deflected shape does not
/// converge.
std::vector<Link> linksAt(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                          const deflection::Posture& posture) {
  const auto shape = deflection::solveFlexibleKinematics(arm, posture);
  if (shape.status != deflection::KinematicsStatus::kConverged) return {};
  std::vector<Link> links;
  Vector3d from = X_WB.translation();
  const auto add = [&](const Vector3d& p_B) {
    const Vector3d to = X_WB * p_B;
    links.push_back({from, to});
    from = to;
  };
  for (const auto& row : shape.rows) add(row.X_BL.p);
  add(shape.X_BD.p);
  return links;
}

double lowestOf(const std::vector<Link>& links) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Link& link : links) lowest = std::min(lowest, link.to.z());
  return lowest;
}

/// Returns the distance between two links [m] (Ericson 2005, "Real-Time Collision Detection", 5.1.9).
double distance(const Link& a, const Link& b) {
  const Vector3d u = a.to - a.from, v = b.to - b.from, offset = a.from - b.from;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), u_offset = u.dot(offset),
               v_offset = v.dot(offset);
  const double square = uu * vv - uv * uv;
  double s = square > 1e-12 * uu * vv ? std::clamp((uv * v_offset - u_offset * vv) / square, 0., 1.) : 0;
  const double t = std::clamp((uv * s + v_offset) / vv, 0., 1.);
  s = std::clamp((uv * t - u_offset) / uu, 0., 1.);
  return (offset + s * u - t * v).norm();
}

/// Returns the distance between the links of each pair [m], in a fixed order. Infinite for neighbouring links, and if a
/// link is shorter than kShortLink.
std::vector<double> distancesOf(const std::vector<Link>& links) {
  const auto isLink = [&](std::size_t k) { return (links[k].to - links[k].from).norm() > kShortLink; };
  // Group number of each link; links separated only by links shorter than kShortLink have adjacent groups and are
  // neighbours.
  std::vector<int> group(links.size());
  for (std::size_t k = 1; k < links.size(); ++k) group[k] = group[k - 1] + isLink(k);
  std::vector<double> distances;
  for (std::size_t a = 0; a < links.size(); ++a)
    for (std::size_t b = a + 1; b < links.size(); ++b)
      distances.push_back(isLink(a) && isLink(b) && group[b] > group[a] + 1 ? distance(links[a], links[b])
                                                                            : std::numeric_limits<double>::infinity());
  return distances;
}

}  // namespace

MeasuredRoom::MeasuredRoom(const calibration::PlacedArm& fitted, const std::vector<Measurement>& measurements)
    : fitted_(fitted) {
  for (const Measurement& measurement : measurements) {
    const auto& X_WB = fitted.base_poses[static_cast<std::size_t>(basePoseOf(fitted, measurement))].X_WB;
    const auto links = linksAt(fitted.arm, X_WB, calibration::postureOf(measurement, fitted.arm, X_WB));
    if (links.empty()) continue;
    lowest_ = std::min(lowest_, lowestOf(links));
    const auto distances = distancesOf(links);
    if (nearest_.empty()) nearest_ = distances;
    for (std::size_t k = 0; k < distances.size(); ++k) nearest_[k] = std::min(nearest_[k], distances[k]);
  }
}

bool MeasuredRoom::contains(const Eigen::VectorXd& q, double load) const {
  const auto& X_WB = fitted_.base_poses.back().X_WB;
  const auto links = linksAt(fitted_.arm, X_WB, {q, load, deflection::gravityInBase(fitted_.arm, X_WB)});
  if (links.empty() || lowestOf(links) < lowest_ - kSlack) return false;
  const auto distances = distancesOf(links);
  for (std::size_t k = 0; k < std::min(distances.size(), nearest_.size()); ++k)
    if (distances[k] < nearest_[k] - kSlack) return false;
  return true;
}

}  // namespace tubeplan::app
