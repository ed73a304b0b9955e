// Joint readings that bring the tool under a hole and up to its face, in the thesis's three ways (Calkins 1994,
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
  kGoalPoint,  ///< the goal on the flexible model; the way to it by rigid kinematics of the goal's rigid place (4.3.1)
  kViaPoint,   ///< every via point on the flexible model (4.3.2)
};

/// none, goal-point, via-point.
std::string_view nameOf(Compensation mode);
/// For a reader: "no compensation", "goal-point compensation", "via-point compensation".
std::string_view wordsOf(Compensation mode);
std::optional<Compensation> findCompensation(std::string_view name);

struct CompensationOptions {
  Compensation mode = Compensation::kViaPoint;
  double standoff = 0.0254;         ///< m below the face, where an approach begins and a retreat ends
  double path_tolerance = 2.54e-5;  ///< m; most the tip may leave the straight line between via points (0.001 in)
  int max_via_points = 129;
  bool with_approach = true;  ///< without: only the posture at the hole is found
  deflection::InverseKinematicsOptions inverse;
};

/// One posture under a hole, and the way up to it.
struct TubeBranch {
  deflection::BranchStatus status = deflection::BranchStatus::kNotRun;
  std::string reason;
  Eigen::VectorXd q;                                       ///< tip at the hole's centre on the face
  std::vector<Eigen::VectorXd> approach;                   ///< from the standoff up to q, both included
  Eigen::Vector3d predicted_tip_W;                         ///< of the flexible model at q
  double tilt = std::numeric_limits<double>::quiet_NaN();  ///< rad, of the tool against the hole's axis
  double path_deviation =
      std::numeric_limits<double>::quiet_NaN();  ///< m, most the tip leaves the hole's axis on the way (flexible model)
};

/// All branches for one hole: those that reach it first. Empty: the hole is out of reach.
[[nodiscard]] std::vector<TubeBranch> compensate(const Workcell& cell, const Eigen::Vector3d& hole_W,
                                                 const CompensationOptions& options = {});

/// The branch that a start near it leads to, and no other.
[[nodiscard]] TubeBranch compensateFrom(const Workcell& cell, const Eigen::Vector3d& hole_W,
                                        const Eigen::VectorXd& q_start, const CompensationOptions& options = {});

/// The tip as the workcell's model has it at q: place in the world and tilt against the holes' axis.
struct PredictedTip {
  Eigen::Vector3d p_WT;
  double tilt;
  Eigen::Vector3d axis_W;  ///< of the tool, unit length
};
PredictedTip predictTip(const Workcell& cell, const Eigen::VectorXd& q);

/// Greatest distance of the tip from the line through `hole_W` along the holes' axis, while the joints run straight
/// from posture to posture; sampled `samples` times between two.
double lateralDeviation(const Workcell& cell, const Eigen::Vector3d& hole_W,
                        const std::vector<Eigen::VectorXd>& postures, int samples = 4);

}  // namespace tubeplan::planner
