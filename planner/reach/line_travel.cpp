#include "planner/reach/line_travel.hpp"

#include <algorithm>
#include <cmath>

#include "planner/reach/tip_prediction.hpp"
#include "planner/timing/flowing_timing.hpp"

namespace tubeplan::planner {

namespace {

using Eigen::Vector3d, Eigen::VectorXd;

// Shortest segment, as a fraction of the line; if a segment this short still needs a via point, the branches differ.
constexpr double kShortest = 1. / 2048;
constexpr int kMostTries = 6;  // number of attempts; each one halves the tolerance of the previous attempt

double distanceFromLine(const Vector3d& p, const Vector3d& from, const Vector3d& to) {
  const Vector3d along = (to - from).stableNormalized();
  return ((p - from) - along * along.dot(p - from)).norm();
}

std::vector<VectorXd> middlesOf(const std::vector<VectorXd>& postures) {
  std::vector<VectorXd> middles;
  for (std::size_t k = 0; k + 1 < postures.size(); ++k) middles.push_back((postures[k] + postures[k + 1]) / 2);
  return middles;
}

LineTravel refused(LineTravelStatus status, std::string reason) {
  LineTravel travel;
  travel.status = status;
  travel.reason = std::move(reason);
  return travel;
}

}  // namespace

LineTravels::LineTravels(const Workcell& cell, JointSpeeds speeds, const deflection::InverseKinematicsOptions& inverse,
                         const LineTravelOptions& options)
    : speeds_(std::move(speeds)), options_(options), placer_(cell, cell.arm, inverse) {}

/// Returns the largest distance of the tip from the line at the corners and midway between them [m].
double LineTravels::deviationOf(const std::vector<VectorXd>& corners, const Vector3d& from_W, const Vector3d& to_W) {
  std::vector<VectorXd> postures = middlesOf(corners);
  postures.insert(postures.end(), corners.begin(), corners.end());
  double worst = 0;
  for (const Vector3d& tip_W : placer_.tipsAt(postures)) worst = worseOf(worst, distanceFromLine(tip_W, from_W, to_W));
  return worst;
}

/// Adds a via point on the line in the middle of every segment where the tip is more than `tolerance` [m] off the line,
/// until there is none. Returns false, with the reason in `travel`, if a via point cannot be reached. `shares`:
/// position of each waypoint along the line, from 0 to 1.
bool LineTravels::refine(double tolerance, const Vector3d& from_W, const Vector3d& to_W, std::vector<double>& shares,
                         LineTravel& travel) {
  const auto fail = [&travel](LineTravelStatus status, std::string reason) {
    travel = refused(status, std::move(reason));
    return false;
  };
  while (true) {
    const std::vector<VectorXd> middles = middlesOf(travel.waypoints);
    const std::vector<Vector3d> tips_W = placer_.tipsAt(middles);
    std::vector<std::size_t> wide;
    std::vector<Vector3d> places_W;
    std::vector<VectorXd> starts;
    for (std::size_t k = 0; k < middles.size(); ++k) {
      if (distanceFromLine(tips_W[k], from_W, to_W) <= tolerance) continue;
      if (shares[k + 1] - shares[k] < kShortest)
        return fail(LineTravelStatus::kOtherPosture, "the postures at the ends of the line cannot be joined along it");
      wide.push_back(k);
      places_W.push_back(from_W + (shares[k] + shares[k + 1]) / 2 * (to_W - from_W));
      starts.push_back(middles[k]);
    }
    if (wide.empty()) return true;
    if (static_cast<int>(travel.waypoints.size() + wide.size()) > options_.most_waypoints)
      return fail(LineTravelStatus::kTooManyWaypoints, "the line needs too many via points");
    const auto vias = placer_.near(places_W, starts);
    for (std::size_t n = wide.size(); n-- > 0;) {
      if (vias[n].status != deflection::BranchStatus::kConverged)
        return fail(LineTravelStatus::kNotReached, "a point on the line cannot be reached: " + vias[n].reason);
      const auto at = static_cast<std::ptrdiff_t>(wide[n]);
      travel.waypoints.insert(travel.waypoints.begin() + at + 1, vias[n].q);
      shares.insert(shares.begin() + at + 1, (shares[wide[n]] + shares[wide[n] + 1]) / 2);
    }
  }
}

LineTravel LineTravels::between(const VectorXd& q0, const VectorXd& q1) {
  LineTravel travel;
  travel.waypoints = {q0, q1};
  std::vector<double> shares{0, 1};
  const auto ends_W = placer_.tipsAt(travel.waypoints);
  double tolerance = options_.tolerance / 2;
  for (int round = 0; round < kMostTries; ++round, tolerance /= 2) {
    if (!refine(tolerance, ends_W[0], ends_W[1], shares, travel)) return travel;
    const TimedFlow flow = timeFlow(travel.waypoints, speeds_);
    travel.deviation = deviationOf(cornersOf(flow), ends_W[0], ends_W[1]);
    if (!(travel.deviation <= options_.tolerance)) continue;
    travel.status = LineTravelStatus::kOnLine;
    return travel;
  }
  return refused(LineTravelStatus::kTooManyWaypoints, "the via points cut the corners too widely");
}

}  // namespace tubeplan::planner
