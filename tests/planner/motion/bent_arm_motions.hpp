// Random motions of the mock-up's deflected arm among plates 0.01 mm thick: motions found free are compared with fine
// sampling.
#pragma once

#include "planner/collision/arm_clearance.hpp"
#include "tests/planner/motion/adversarial_motions.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner::testing {

/// Returns the mock-up without its walls, with three thin plates within the arm's reach.
inline Workcell amongThinPlates(Workcell cell, std::mt19937_64& generator) {
  cell = alone(std::move(cell));
  for (const char* name : {"plate", "other plate", "third plate"}) {
    const Eigen::Vector3d centre = cell.X_WB * uniformVector(generator, -40 * kInch, 40 * kInch);
    const auto turn = [&] { return uniform(generator, 0, 3); };
    const double yaw = turn(), pitch = turn(), roll = turn();
    cell.scene.obstacles.push_back(
        {name, shape("box", {centre.x(), centre.y(), centre.z(), 0.4, 1e-5, 0.3, roll, pitch, yaw}), {}});
  }
  return cell;
}

/// Checks and counts at least `motions` random motions, `motions_each` of them in each scene.
inline MotionTally tallyBentArmMotions(std::uint64_t seed, int motions, int samples, int motions_each = 20) {
  std::mt19937_64 generator(seed);
  const Workcell bare = mockup();
  MotionTally tally;
  while (tally.free + tally.blocked < motions) {
    const Workcell cell = amongThinPlates(bare, generator);
    const ArmClearance clearance(cell);
    const PostureClearance at = [&](const Eigen::VectorXd& q) { return clearance.at(q, ContactRule::kTravel); };
    for (int motion = 0; motion < motions_each; ++motion) {
      const Eigen::VectorXd q0 = randomPosture(cell.arm, generator);
      const Eigen::VectorXd q1 = q0 + 0.15 * (randomPosture(cell.arm, generator) - q0);
      tally.add(checkMotion(q0, q1, at, clearance.travel()), [&] { return leastSampled(q0, q1, at, samples); });
    }
  }
  return tally;
}

}  // namespace tubeplan::planner::testing
