// Joint readings that bring the tool under a hole and up to its face, by the thesis's three methods (Calkins 1994,
// section 4.3).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/inverse/inverse_kinematics.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::planner {

enum class Compensation {
  kNone,       ///< rigid kinematics throughout
  kGoalPoint,  ///< the goal on the flexible model; the path to it by rigid kinematics of the goal's rigid place (4.3.1)
  kViaPoint,   ///< every via point on the flexible model (4.3.2)
};

/// Returns none, goal-point or via-point.
std::string_view nameOf(Compensation mode);
/// Returns words for a reader: "no compensation", "goal-point compensation", "via-point compensation".
std::string_view wordsOf(Compensation mode);
std::optional<Compensation> findCompensation(std::string_view name);

struct CompensationOptions {
  Compensation mode = Compensation::kViaPoint;
  double standoff = 0.0254;  ///< depth below the face where an approach begins and a retreat ends [m]
  /// Largest distance of the tip from the straight line between via points [m] (0.001 in).
  double path_tolerance = 2.54e-5;
  int max_via_points = 129;
  bool with_approach = true;  ///< false: only the posture at the hole is found
  deflection::InverseKinematicsOptions inverse;
};

/// A posture under a hole, and the path up to it.
struct TubeBranch {
  deflection::BranchStatus status = deflection::BranchStatus::kNotRun;
  std::string reason;
  Eigen::VectorXd q;                      ///< joint readings with the tip at the hole's centre on the face
  std::vector<Eigen::VectorXd> approach;  ///< postures from the standoff up to q, both included
  Eigen::Vector3d predicted_tip_W;        ///< tip of the flexible model at q [m]
  double tilt = std::numeric_limits<double>::quiet_NaN();  ///< angle between the tool and the hole's axis [rad]
  /// Largest distance of the tip from the hole's axis during the approach, on the flexible model [m].
  double path_deviation = std::numeric_limits<double>::quiet_NaN();
};

/// Returns all branches for one hole, with those that reach it first. Empty: the hole is out of reach.
[[nodiscard]] std::vector<TubeBranch> compensate(const Workcell& cell, const Eigen::Vector3d& hole_W,
                                                 const CompensationOptions& options = {});

/// Returns the branch that a start near it leads to, and no other.
[[nodiscard]] TubeBranch compensateFrom(const Workcell& cell, const Eigen::Vector3d& hole_W,
                                        const Eigen::VectorXd& q_start, const CompensationOptions& options = {});

/// The tip of the workcell's model at q: place in the world [m] and tilt against the holes' axis [rad].
struct PredictedTip {
  Eigen::Vector3d p_WT;
  double tilt;
  Eigen::Vector3d axis_W;  ///< axis of the tool, unit length
};
PredictedTip predictTip(const Workcell& cell, const Eigen::VectorXd& q);

/// Returns the greatest distance [m] of the tip from the line through `hole_W` along the holes' axis, while the joints
/// move straight from posture to posture, with `samples` samples between two.
double lateralDeviation(const Workcell& cell, const Eigen::Vector3d& hole_W,
                        const std::vector<Eigen::VectorXd>& postures, int samples = 4);

}  // namespace tubeplan::planner
