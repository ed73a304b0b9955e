// The flexible kinematics of random arms compared with the checker's independent statics, which uses none of its
// elements and sweeps.
#include <gtest/gtest.h>

#include "planner/verification/segmented_statics.hpp"
#include "tests/deflection/random_arms.hpp"

namespace tubeplan::planner {
namespace {

using namespace deflection;

RC_GTEST_PROP(SegmentedStatics, AgreesWithTheFlexibleKinematicsOfRandomArms, ()) {
  Arm arm = randomArm();
  for (auto& row : arm.rows)
    if (row.beam) row.beam->segments = 8;
  const Posture posture = randomPostureOf(arm, 300);
  const auto shape = solveFlexibleKinematics(arm, posture);
  RC_PRE(isModest(arm, shape));
  SegmentedStaticsOptions options;
  options.pieces = 256;  // many pieces, because each weight acts at the end of its piece instead of along it
  const auto other = solveSegmentedStatics(arm, posture, options);
  RC_ASSERT(other.status == SegmentedStaticsStatus::kConverged);
  const double sag = (shape.X_BD.p - shape.X_BT.p).norm();
  RC_ASSERT((other.p_BD - shape.X_BD.p).norm() <= 0.005 * sag + 1e-6 * reachOf(arm));
}

}  // namespace
}  // namespace tubeplan::planner
