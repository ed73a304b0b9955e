// Joint readings that bring the tool under a hole and up to the sheet's lower face, by the three methods of Calkins
// (1994, section 4.3).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/inverse/inverse_kinematics.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::planner {

enum class Compensation {
  kNone,  ///< goal and approach are computed with rigid kinematics
  /// The goal is computed with the flexible model, the approach with rigid kinematics, relative to the rigid model's
  /// tip in the goal posture (4.3.1).
  kGoalPoint,
  kViaPoint,  ///< all via points are computed with the flexible model (4.3.2)
};

/// Returns the name of a mode in files and options: none, goal-point or via-point.
std::string_view nameOf(Compensation mode);
/// Returns a phrase for reports: "no compensation", "goal-point compensation" or "via-point compensation".
std::string_view wordsOf(Compensation mode);
std::optional<Compensation> findCompensation(std::string_view name);

struct CompensationOptions {
  Compensation mode = Compensation::kViaPoint;
  double standoff = 0.0254;  ///< depth below the face where an approach begins and a retreat ends [m]
  /// Largest distance of the tip from the straight line between via points [m] (0.001 in).
  double path_tolerance = 2.54e-5;
  int max_via_points = 129;
  bool with_approach = true;  ///< if false, only the posture at the hole is found, without an approach
  deflection::InverseKinematicsOptions inverse;
};

/// A posture under a hole, and the approach path up to it.
struct TubeBranch {
  deflection::BranchStatus status = deflection::BranchStatus::kNotRun;
  std::string reason;
  Eigen::VectorXd q;  ///< joint readings at which the tip is at the goal, usually the centre of the hole on the face
  std::vector<Eigen::VectorXd> approach;  ///< postures from the standoff up to q, both included
  Eigen::Vector3d predicted_tip_W;        ///< tip position of the flexible model at q, in the world [m]
  double tilt = std::numeric_limits<double>::quiet_NaN();  ///< angle between the tool axis and the hole's axis [rad]
  /// Largest distance of the flexible model's tip from the hole's axis during the approach [m].
  double path_deviation = std::numeric_limits<double>::quiet_NaN();
};

/// Returns all branches for one goal, converged branches first. An empty result means that the goal is out of reach.
[[nodiscard]] std::vector<TubeBranch> compensate(const Workcell& cell, const Eigen::Vector3d& hole_W,
                                                 const CompensationOptions& options = {});

/// Returns only the branch that a search from `q_start` leads to.
[[nodiscard]] TubeBranch compensateFrom(const Workcell& cell, const Eigen::Vector3d& hole_W,
                                        const Eigen::VectorXd& q_start, const CompensationOptions& options = {});

/// Tip of the workcell's model at q: position in the world [m] and tilt relative to the holes' axis [rad].
struct PredictedTip {
  Eigen::Vector3d p_WT;
  double tilt;
  Eigen::Vector3d axis_W;  ///< axis of the tool in the world, unit length
};
PredictedTip predictTip(const Workcell& cell, const Eigen::VectorXd& q);

/// Returns the largest distance [m] of the tip from the line through `hole_W` along the holes' axis. The joints move
/// straight from posture to posture; each such segment is divided into `samples` steps.
double lateralDeviation(const Workcell& cell, const Eigen::Vector3d& hole_W,
                        const std::vector<Eigen::VectorXd>& postures, int samples = 4);

}  // namespace tubeplan::planner
