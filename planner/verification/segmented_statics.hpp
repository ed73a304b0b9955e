// The deflected tip by another method than the plan's: members cut into many rigid pieces with a spring in the middle
// of each, without any code of the flexible kinematics' kernels, elements or derivatives. It is slow and simple: a
// second opinion for the checker.
#pragma once

#include <optional>
#include <string>

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::planner {

struct SegmentedStaticsOptions {
  int pieces = 32;          ///< pieces of every flexible member; the error decreases with their square
  double tolerance = 1e-9;  ///< largest rotation of a spring between two passes that still requires another [rad]
  int max_passes = 200;
};

enum class SegmentedStaticsStatus { kNotRun, kConverged, kNotConverged, kNotCovered };

struct SegmentedStatics {
  SegmentedStaticsStatus status = SegmentedStaticsStatus::kNotRun;
  std::string reason;                              ///< reason if not converged
  Eigen::Vector3d p_BD = Eigen::Vector3d::Zero();  ///< deflected tip in the base [m]
};

/// Solves the shape at rest: every spring turns by its compliance times the moment of everything beyond it, on the bent
/// shape. Effects act by their own laws; arms with clearances are not covered.
[[nodiscard]] SegmentedStatics solveSegmentedStatics(const deflection::Arm& arm, const deflection::Posture& posture,
                                                     const SegmentedStaticsOptions& options = {});

}  // namespace tubeplan::planner
