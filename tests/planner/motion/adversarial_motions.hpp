// Random motions of toy arms among obstacles that coarse sampling misses: motions found free are compared with fine
// sampling.
#pragma once

#include <array>
#include <functional>

#include "tests/planner/scene/meshes.hpp"
#include "tests/planner/toy_arm.hpp"

namespace tubeplan::planner::testing {

struct MotionTally {
  int free = 0, blocked = 0;
  int refuted = 0;  ///< motions found free although a sampled margin is smaller than the proved margin

  /// Counts a motion; `least_sampled` is called only for a motion found free.
  void add(const MotionCheckResult& result, const std::function<double()>& least_sampled) {
    if (result.status != MotionCheckStatus::kFree) {
      ++blocked;
      return;
    }
    ++free;
    refuted += !(least_sampled() >= result.proved_margin - 1e-12);
  }

  MotionTally& operator+=(const MotionTally& other) {
    free += other.free;
    blocked += other.blocked;
    refuted += other.refuted;
    return *this;
  }
};

inline constexpr int kAdversarialScenes = 5;
inline constexpr std::array<const char*, kAdversarialScenes> kAdversarialNames{
    "a hair among thin plates", "clutter, with a clearance to keep", "a bowl and a wall all but touched",
    "an arm of boxes among boxes", "a hair among plates of triangles"};

inline ToyArm adversarialArm(int scene) {
  static constexpr std::array kRadius{1e-6, 0.02, 0.02, 0.03, 1e-6}, kClearance{0.0, 0.01, 0.0, 0.0, 0.0};
  return {{0.6, 0.5, 0.4}, kRadius.at(static_cast<std::size_t>(scene)), kClearance.at(static_cast<std::size_t>(scene))};
}

/// Returns a mesh at position (x, y), rotated by a yaw angle.
inline ShapePointer placedMesh(const TriangleMesh& mesh, double x, double y, double yaw) {
  return makeShape(*findSceneShape("mesh"), std::vector<double>{x, y, 0, 0, 0, yaw}, &mesh).shape;
}

inline Scene adversarialScene(int scene, const ToyArm& arm, std::mt19937_64& generator) {
  const auto somewhere = [&] { return uniform(generator, 0.5, 1.2) * (uniform(generator, 0, 1) < 0.5 ? -1 : 1); };
  const auto plate = [&] {
    return shape("box", {somewhere(), somewhere(), 0, 0.4, 1e-5, 0.4, 0, 0, uniform(generator, 0, 3)});
  };
  const auto post = [&](double radius) {
    const double x = somewhere(), y = somewhere();
    return shape("cylinder", {x, y, -1, x, y, 1, radius});
  };
  if (scene == 0) return arm.scene({{"plate", plate(), {}}, {"other plate", plate(), {}}});
  if (scene == 1)
    return arm.scene(
        {{"post", post(0.05), {}}, {"plate", plate(), {}}, {"wall", shape("keep_side", {0, -1.3, 0, 0, 1, 0}), {}}});
  const double gap = std::pow(10, uniform(generator, -9, -2));
  if (scene == 2)
    return arm.scene({{"bowl", shape("inside_of.sphere", {0, 0, 0, 1.5 + arm.radius + gap}), {}},
                      {"wall", shape("keep_side", {0, 1.1 + arm.radius - gap, 0, 0, -1, 0}), {}}});
  if (scene == 4) {
    const TriangleMesh sheet{{{-0.2, 0, -0.2}, {0.2, 0, -0.2}, {0.2, 0, 0.2}, {-0.2, 0, 0.2}}, {{0, 1, 2}, {0, 2, 3}}};
    const auto plateOf = [&] { return placedMesh(sheet, somewhere(), somewhere(), uniform(generator, 0, 3)); };
    return arm.scene({{"plate", plateOf(), {}},
                      {"other plate", plateOf(), {}},
                      {"post", placedMesh(cylinderMesh(0.05, 1, 16), somewhere(), somewhere(), 0), {}}});
  }
  Scene boxes = arm.scene({{"box", shape("box", {somewhere(), somewhere(), 0, 0.2, 0.3, 0.1, 0, 0.4, 0.3}), {}},
                           {"plate", plate(), {}},
                           {"post", post(0.05), {}}});
  for (std::size_t i = 0; i < boxes.bodies.size(); ++i)
    boxes.bodies[i].shape =
        shape("box", {arm.lengths[i] / 2, 0, 0, arm.lengths[i], 2 * arm.radius, 2 * arm.radius, 0, 0, 0});
  return boxes;
}

inline MotionTally tallyMotions(int scene, std::uint64_t seed, int motions, int samples) {
  std::mt19937_64 generator(seed);
  const ToyArm arm = adversarialArm(scene);
  MotionTally tally;
  for (int motion = 0; motion < motions; ++motion) {
    const CollisionWorld world(adversarialScene(scene, arm, generator));
    const auto clearance_of = arm.clearanceOf(world);
    Eigen::VectorXd q0(3), q1(3);
    for (double& angle : q0) angle = uniform(generator, -2, 2);
    for (Eigen::Index j = 0; j < 3; ++j) q1[j] = q0[j] + uniform(generator, -0.7, 0.7);
    tally.add(checkMotion(q0, q1, clearance_of, arm.travel(world)),
              [&] { return leastSampled(q0, q1, clearance_of, samples); });
  }
  return tally;
}

}  // namespace tubeplan::planner::testing
