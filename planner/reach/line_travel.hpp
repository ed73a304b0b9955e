// The tool moved straight from one standoff to another, as a camera is moved along a row at constant height: the
// deflected tip stays on the line, every via point solved on the flexible model (Calkins 1994, section 4.3.2).
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "planner/reach/tool_placer.hpp"
#include "planner/timing/joint_metric.hpp"

namespace tubeplan::planner {

struct LineTravelOptions {
  double tolerance = 5.08e-5;  ///< m; most the deflected tip may leave the line, cut corners included (0.002 in)
  int most_waypoints = 1025;
};

enum class LineTravelStatus { kNotRun, kOnLine, kNotReached, kOtherPosture, kTooManyWaypoints };

struct LineTravel {
  LineTravelStatus status = LineTravelStatus::kNotRun;
  std::string reason;                      ///< why there is none
  std::vector<Eigen::VectorXd> waypoints;  ///< both ends included; to be flowed through without rest
  double deviation = std::numeric_limits<double>::quiet_NaN();  ///< m, most the tip leaves the line along that flow
};

/// From one posture to another. Where they are branches of their own, no line joins them: kOtherPosture. Whether the
/// way is clear is not asked.
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
