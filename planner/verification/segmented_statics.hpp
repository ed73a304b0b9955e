// The deflected tip computed by a different method from the plan's: members are cut into many rigid pieces with a
// spring in the middle of each. No code of the flexible kinematics' kernels, elements or derivatives is used. The
// method is slow and simple, and gives the plan check an independent result.
#pragma once

#include <optional>
#include <string>

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::planner {

struct SegmentedStaticsOptions {
  /// Number of pieces into which each flexible member is cut; the error is inversely proportional to the square of this
  /// number.
  int pieces = 32;
  double tolerance = 1e-9;  ///< convergence tolerance: largest change of a spring's rotation between two passes [rad]
  int max_passes = 200;
};

enum class SegmentedStaticsStatus { kNotRun, kConverged, kNotConverged, kNotCovered };

struct SegmentedStatics {
  SegmentedStaticsStatus status = SegmentedStaticsStatus::kNotRun;
  std::string reason;  ///< reason why the shape did not converge or the arm is not supported; empty if converged
  Eigen::Vector3d p_BD = Eigen::Vector3d::Zero();  ///< deflected tip in the base frame [m]
};

/// Solves for the shape at rest: every spring turns by its compliance times the moment of all weights and loads beyond
/// it, at their positions on the bent shape. Effects are included by their own laws; arms with mechanical play are not
/// supported.
[[nodiscard]] SegmentedStatics solveSegmentedStatics(const deflection::Arm& arm, const deflection::Posture& posture,
                                                     const SegmentedStaticsOptions& options = {});

}  // namespace tubeplan::planner
