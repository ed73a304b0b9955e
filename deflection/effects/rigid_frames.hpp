// Undeflected frames of an arm's rows, for laws that depend on positions in the arm.
#pragma once

#include "deflection/chain.hpp"

namespace tubeplan::deflection {

/// Frames of all rows and position of the tip, in base axes [m].
template <class S>
struct RigidFrames {
  std::vector<PoseOf<S>> rows;
  Vector3<S> tip;
};

template <class S>
RigidFrames<S> rigidFramesOf(const ArmOf<S>& arm, const Eigen::Matrix<S, Eigen::Dynamic, 1>& q) {
  RigidFrames<S> frames;
  PoseOf<S> at;
  int joint = 0;
  for (const Row<S>& row : arm.rows) {
    at.p = at.p + at.R * offsetInPreviousAxes<S>(row);
    at.R = at.R * rotationFromPrevious<S>(row);
    if (!row.joint.follows.empty()) at.R = at.R * rotationZ<S>(followedAngle<S>(arm, row.joint, q) + row.joint.offset);
    if (row.joint.type != JointType::kPassive) {
      const S value = q[joint++] + row.joint.offset;
      if (row.joint.type == JointType::kRevolute)
        at.R = at.R * rotationZ<S>(value);
      else
        at.p = at.p + at.R.col(2) * value;
    }
    frames.rows.push_back(at);
  }
  frames.tip = at.p + at.R * arm.p_LT;
  return frames;
}

}  // namespace tubeplan::deflection
