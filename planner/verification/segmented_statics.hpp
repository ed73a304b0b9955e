// The deflected tip by another method than the plan's: members cut into many rigid pieces with a spring in the middle
// of each, and nothing shared with the kernels, elements or derivatives of the flexible kinematics. Slow and plain: a
// second opinion for the checker.
#pragma once

#include <optional>
#include <string>

#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::planner {

struct SegmentedStaticsOptions {
  int pieces = 32;          ///< of every flexible member: the error falls with their square
  double tolerance = 1e-9;  ///< rad, largest turn of a spring between two passes that asks for another
  int max_passes = 200;
};

enum class SegmentedStaticsStatus { kNotRun, kConverged, kNotConverged, kNotCovered };

struct SegmentedStatics {
  SegmentedStaticsStatus status = SegmentedStaticsStatus::kNotRun;
  std::string reason;                              ///< why not
  Eigen::Vector3d p_BD = Eigen::Vector3d::Zero();  ///< m, the deflected tip in the base
};

/// The shape at rest: every spring turns by its compliance times the moment of what lies beyond it, taken on the bent
/// shape. Effects take part by their own laws; arms with clearances are not covered.
[[nodiscard]] SegmentedStatics solveSegmentedStatics(const deflection::Arm& arm, const deflection::Posture& posture,
                                                     const SegmentedStaticsOptions& options = {});

}  // namespace tubeplan::planner
