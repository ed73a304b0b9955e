#include "planner/collision/inseparable.hpp"

#include <algorithm>

#include "deflection/flexible_kinematics.hpp"
#include "deflection/inverse/rigid_branches.hpp"
#include "planner/scene/separation.hpp"

namespace tubeplan::planner {

using Eigen::Isometry3d;

namespace {

constexpr int kPostures = 1000;

/// Returns the rows' frames in the base frame, without deflection; empty if an effect has no value at q.
std::vector<Isometry3d> rigidFrames(const deflection::Arm& arm, const Eigen::VectorXd& q) {
  deflection::Posture posture;
  posture.q = q;
  std::vector<Isometry3d> frames;
  for (const auto& row : deflection::solveFlexibleKinematics(arm, posture).rows) {
    Isometry3d X_BL = Isometry3d::Identity();
    X_BL.linear() = row.X_BL_rigid.R;
    X_BL.translation() = row.X_BL_rigid.p;
    frames.push_back(X_BL);
  }
  return frames;
}

bool areNear(const Scene& scene, const std::vector<Isometry3d>& X_BL, const std::pair<int, int>& pair) {
  const Body& a = scene.bodies[static_cast<std::size_t>(pair.first)];
  const Body& b = scene.bodies[static_cast<std::size_t>(pair.second)];
  const auto& solid_a = dynamic_cast<const Solid&>(*a.shape);
  const auto& solid_b = dynamic_cast<const Solid&>(*b.shape);
  const auto frameOf = [&](const Body& body) { return X_BL[static_cast<std::size_t>(body.frame_index)]; };
  return separation(frameOf(a), solid_a, frameOf(b), solid_b).distance < scene.clearance;
}

}  // namespace

std::vector<std::pair<int, int>> inseparableBodies(const deflection::Arm& arm, const Scene& scene) {
  std::vector<std::pair<int, int>> pairs;
  for (int b = 0; b < static_cast<int>(scene.bodies.size()); ++b)
    for (int a = 0; a < b; ++a)
      if (areJudged(scene, a, b) &&
          !mayTouch(scene.bodies[static_cast<std::size_t>(a)], scene.bodies[static_cast<std::size_t>(b)]))
        pairs.emplace_back(a, b);
  if (pairs.empty()) return pairs;
  // The loop usually ends at the first posture, which separates all pairs.
  for (const auto& q : deflection::latticeStarts(arm, kPostures)) {
    const auto X_BL = rigidFrames(arm, q);
    if (X_BL.empty()) continue;
    std::erase_if(pairs, [&](const auto& pair) { return !areNear(scene, X_BL, pair); });
    if (pairs.empty()) break;
  }
  return pairs;
}

}  // namespace tubeplan::planner
