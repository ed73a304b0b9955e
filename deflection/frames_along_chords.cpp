#include "deflection/frames_along_chords.hpp"

#include <algorithm>

#include "deflection/chain.hpp"

namespace tubeplan::deflection {

using Eigen::Isometry3d, Eigen::Vector3d;

namespace {

/// Returns the largest distance of a bent element from its chord [m], plus a margin of 10 %. The element is
/// approximated by the cubic curve defined by the displacement d and the rotation w of its end.
double bowOf(const Vector3d& member, const Vector3d& d, const Vector3d& w) {
  double bow = 0;
  const Vector3d slope = w.cross(member);
  for (double s : {0.25, 1. / 3, 0.5, 2. / 3, 0.75})
    bow = std::max(bow, ((3 * s * s - 2 * s * s * s - s) * d + (s * s * s - s * s) * slope).norm());
  return 1.1 * bow;
}

double bowOfRow(const Arm& arm, const FlexibleKinematics& shape, int row) {
  double bow = 0, turn = 0;
  int segments = 0;
  for (const auto& component : shape.components) {
    if (component.row != row || elementKinds()[component.kind].place != ElementPlace::kMember) continue;
    ++segments;
    turn += component.rotation.norm();
    bow = bowOf(memberOf(arm, row), component.displacement, component.rotation);
  }
  return segments > 1 ? 1.1 * memberOf(arm, row).norm() * turn / 8 : bow;
}

/// Returns the deflected far end of a row's member in the base frame [m].
Vector3d farEnd(const FlexibleKinematics& shape, int row) {
  return row + 1 < static_cast<int>(shape.rows.size()) ? shape.rows[row + 1].X_BL.p : shape.X_BD.p;
}

}  // namespace

std::vector<Isometry3d> framesAlongChords(const Arm& arm, const Isometry3d& X_WB, const FlexibleKinematics& shape,
                                          double* bow) {
  std::vector<Isometry3d> frames;
  if (bow) *bow = 0;
  for (int row = 0; row < static_cast<int>(shape.rows.size()); ++row) {
    Isometry3d X_BL = toIsometry(shape.rows[row].X_BL);
    if (arm.rows[row].beam && arm.rows[row].joint.type != JointType::kPrismatic) {
      const Vector3d chord = farEnd(shape, row) - X_BL.translation();
      const Vector3d member = X_BL.linear() * memberOf(arm, row);
      X_BL.linear() = Eigen::Quaterniond::FromTwoVectors(member, chord).toRotationMatrix() * X_BL.linear();
      if (bow) *bow = std::max(*bow, bowOfRow(arm, shape, row));
    }
    frames.push_back(X_WB * X_BL);
  }
  return frames;
}

}  // namespace tubeplan::deflection
