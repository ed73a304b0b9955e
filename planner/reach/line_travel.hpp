// Straight travel of the tool from one standoff to another, for example of a camera along a row of tubes at constant
// height. The deflected tip stays on the line: every via point is solved on the flexible model (Calkins 1994, section
// 4.3.2).
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "planner/reach/tool_placer.hpp"
#include "planner/timing/joint_metric.hpp"

namespace tubeplan::planner {

struct LineTravelOptions {
  /// Largest distance of the deflected tip from the line, including where corners between via points are rounded [m]
  /// (0.002 in).
  double tolerance = 5.08e-5;
  int most_waypoints = 1025;
};

enum class LineTravelStatus { kNotRun, kOnLine, kNotReached, kOtherPosture, kTooManyWaypoints };

struct LineTravel {
  LineTravelStatus status = LineTravelStatus::kNotRun;
  std::string reason;                      ///< reason why there is no straight travel; empty if there is one
  std::vector<Eigen::VectorXd> waypoints;  ///< waypoints from start to goal, both included, to be passed without stops
  /// Largest distance of the tip from the line during the motion without stops [m].
  double deviation = std::numeric_limits<double>::quiet_NaN();
};

/// Straight travels of the tip between postures. Postures of different branches cannot be connected along a line, and
/// give kOtherPosture. Collisions are not checked.
class LineTravels {
 public:
  LineTravels(const Workcell& cell, JointSpeeds speeds, const deflection::InverseKinematicsOptions& inverse = {},
              const LineTravelOptions& options = {});

  [[nodiscard]] LineTravel between(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1);

 private:
  [[nodiscard]] double deviationOf(const std::vector<Eigen::VectorXd>& corners, const Eigen::Vector3d& from_W,
                                   const Eigen::Vector3d& to_W);
  bool refine(double tolerance, const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W, std::vector<double>& shares,
              LineTravel& travel);

  JointSpeeds speeds_;
  LineTravelOptions options_;
  ToolPlacer placer_;
};

}  // namespace tubeplan::planner
