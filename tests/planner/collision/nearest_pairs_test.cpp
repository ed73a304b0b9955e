#include "planner/collision/nearest_pairs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/planner/scene/meshes.hpp"
#include "tests/planner/toy_arm.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d;
using testing::shape;
using testing::uniform;
using testing::uniformPose;
using testing::uniformVector;

using Frames = std::vector<Isometry3d>;

/// Returns postures in kernel lanes as RowPlacing lays them out; the last posture is repeated in unused lanes.
deflection::PlacedRows sideBySide(std::span<const Frames> postures, const kernels::Kernel& kernel) {
  deflection::PlacedRows placed;
  placed.lanes = kernel.lanes;
  placed.count = static_cast<int>(postures.size());
  const std::size_t rows = postures.front().size();
  const auto width = static_cast<std::size_t>(kernel.lanes);
  placed.frames.resize(12 * rows * width);
  placed.bow.assign(width, 0);
  placed.is_converged.assign(width, true);
  for (std::size_t lane = 0; lane < width; ++lane)
    for (std::size_t row = 0; row < rows; ++row) {
      const Isometry3d& X = postures[std::min(lane, postures.size() - 1)][row];
      for (std::size_t k = 0; k < 12; ++k)
        placed.frames[(12 * row + k) * width + lane] =
            k < 3 ? X.translation()[static_cast<int>(k)]
                  : X.linear()(static_cast<int>(k % 3), static_cast<int>(k / 3 - 1));
    }
  return placed;
}

std::vector<NearestPair> nearestOf(const NearestPairs& pairs, const std::vector<Frames>& postures,
                                   const kernels::Kernel& kernel) {
  std::vector<NearestPair> found(postures.size());
  const auto width = static_cast<std::size_t>(kernel.lanes);
  for (std::size_t first = 0; first < postures.size(); first += width) {
    const std::size_t count = std::min(width, postures.size() - first);
    pairs.find(sideBySide(std::span(postures).subspan(first, count), kernel), std::span(found).subspan(first, count));
  }
  return found;
}

Scene sceneOf(std::vector<ShapePointer> bodies, std::vector<ShapePointer> obstacles) {
  Scene scene;
  scene.clearance = 0.01;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    scene.links.push_back({"link" + std::to_string(k), true});
    scene.bodies.push_back({scene.links.back().name, static_cast<int>(k), "", bodies[k], {}});
  }
  for (std::size_t k = 0; k < obstacles.size(); ++k)
    scene.obstacles.push_back({"obstacle" + std::to_string(k), obstacles[k], {}});
  return scene;
}

ShapePointer capsule(const Vector3d& from, const Vector3d& to, double radius) {
  return shape("capsule", {from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), radius});
}

std::vector<ShapePointer> obstaclesOfAllKinds() {
  return {shape("keep_side", {0.1, 0.2, -0.4, 0.3, -0.2, 1}),
          shape("inside_of.sphere", {0.1, 0, 0.2, 1.1}),
          shape("sphere", {0.4, 0.1, -0.2, 0.15}),
          shape("capsule", {-0.5, 0.2, 0, 0.3, 0.4, 0.1, 0.05}),
          shape("box", {0.2, -0.3, 0.1, 0.5, 0.3, 0.2, 0.3, -0.4, 0.7}),
          shape("cylinder", {-0.2, -0.4, -0.3, 0.1, -0.2, 0.3, 0.12})};
}

/// Returns a random capsule; in some trials its axis is parallel to an axis or edge of an obstacle, or of zero length.
Capsule anyCapsule(std::mt19937_64& random, int trial) {
  const Vector3d from = uniformVector(random, -1, 1);
  static const std::array kAxes{Vector3d(1, 0, 0), Vector3d(0, 0, 1), Vector3d(0.8, 0.2, 0.1), Vector3d(0.3, 0.2, 0.6),
                                Vector3d(0.3, -0.2, 1)};
  Vector3d along = uniformVector(random, -1, 1);
  if (trial % 4 == 1) along = kAxes[static_cast<std::size_t>(trial / 4) % kAxes.size()] * uniform(random, -1, 1);
  if (trial % 4 == 2) along = Vector3d::Zero();
  if (trial % 4 == 3) along *= 1e-9;
  return {from, from + along, trial % 5 ? uniform(random, 0.01, 0.2) : 1e-12};
}

/// Returns the smallest distance of a capsule from the obstacle, sampled by `pointDistance` at evenly spaced points of
/// the capsule's axis.
double leastSampled(const Shape& obstacle, const Capsule& body) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= 400; ++k)
    least = std::min(least, obstacle.pointDistance(body.from + k / 400. * (body.to - body.from)));
  return least - body.radius;
}

TEST(NearestPairs, DistancesOfEveryKindAreThoseOfTheScalarKernelAndNeverMoreThanSampled) {
  std::mt19937_64 random(1);
  for (const ShapePointer& obstacle : obstaclesOfAllKinds()) {
    for (int trial = 0; trial < 1500; ++trial) {
      const Capsule body = anyCapsule(random, trial);
      const NearestPairs pairs(sceneOf({capsule(body.from, body.to, body.radius)}, {obstacle}));
      const auto found = nearestOf(pairs, {{Isometry3d::Identity()}}, kernels::kernels().front());
      const double scalar = obstacle->separationFrom(body).distance, sampled = leastSampled(*obstacle, body);
      if (sampled > -body.radius + 1e-8) {
        EXPECT_NEAR(found[0].distance, scalar, 1e-12) << trial;
        EXPECT_GE(found[0].distance, sampled - (body.to - body.from).norm() / 800 - 1e-12) << trial;
      }
      if (sampled > -body.radius) {
        EXPECT_LE(found[0].distance, sampled + 1e-12) << trial;
      } else {
        EXPECT_LT(found[0].distance, 0) << trial;
      }
    }
  }
}

TEST(NearestPairs, TouchingAndCrossingCountAsContact) {
  const auto distanceOf = [](const ShapePointer& body, const ShapePointer& obstacle) {
    return nearestOf(NearestPairs(sceneOf({body}, {obstacle})), {{Isometry3d::Identity()}}, kernels::kernels().front())
        .front()
        .distance;
  };
  const ShapePointer box = shape("box", {0, 0, 0, 2, 2, 2, 0, 0, 0}), rod = shape("cylinder", {0, 0, -1, 0, 0, 1, 1});
  for (const ShapePointer& solid : {box, rod}) {
    EXPECT_NEAR(distanceOf(capsule({2, 0, 0}, {3, 0, 0}, 1), solid), 0, 1e-15);                 // capsule end on a face
    EXPECT_NEAR(distanceOf(capsule({1.5, 0, -3}, {1.5, 0, 3}, 0.5), solid), 0, 1e-15);          // along the side face
    EXPECT_NEAR(distanceOf(capsule({-3, 0, 1.25}, {3, 0, 1.25}, 0.125), solid), 0.125, 1e-15);  // above the end face
    EXPECT_EQ(distanceOf(capsule({-3, 0, 0}, {3, 0, 0}, 0.125), solid), -0.125);                // through the middle
    EXPECT_EQ(distanceOf(capsule({0, 0, 0}, {0, 0, 0}, 0.125), solid), -0.125);                 // a ball inside
    EXPECT_NEAR(distanceOf(capsule({0, 0, 4}, {0, 0, 4}, 0.5), solid), 2.5, 1e-15);
  }
  const ShapePointer bar = capsule({0, 0, 0}, {1, 0, 0}, 0.25);
  EXPECT_NEAR(distanceOf(capsule({0, 1, 0}, {1, 1, 0}, 0.25), bar), 0.5, 1e-15);  // parallel
  EXPECT_NEAR(distanceOf(capsule({2, 0, 0}, {3, 0, 0}, 0.25), bar), 0.5, 1e-15);  // collinear
  EXPECT_NEAR(distanceOf(capsule({0.5, -1, 0}, {0.5, 1, 0}, 0.25), bar), -0.5, 1e-15);
  EXPECT_NEAR(distanceOf(capsule({0.5, 0.5, 0}, {0.5, 0.5, 0}, 0.25), bar), 0, 1e-15);
}

/// Returns four scenes: capsules among obstacles, bodies of every kind among obstacles, the same with a mesh, and
/// bodies alone.
std::vector<Scene> manyScenes() {
  const std::vector<ShapePointer> bodies = {
      capsule({0, 0, 0}, {0.3, 0, 0}, 0.05), shape("box", {0.1, 0, 0, 0.2, 0.1, 0.08, 0.2, 0, 0}),
      capsule({0, 0, 0}, {0, 0, 0}, 0.04), shape("cylinder", {0, 0, 0, 0, 0.2, 0.1, 0.06}),
      capsule({0, 0, 0}, {0.2, 0.3, 0}, 0.03)};
  auto obstacles = obstaclesOfAllKinds();
  auto with_mesh = obstacles;
  const TriangleMesh ball = testing::ballMesh(0.2, 6);
  with_mesh.push_back(
      makeShape(*findSceneShape("mesh"), std::vector<double>{0.3, 0.3, 0.3, 0.1, 0.2, 0.3}, &ball).shape);
  return {sceneOf({bodies[0], bodies[2], bodies[4]}, obstacles), sceneOf(bodies, obstacles), sceneOf(bodies, with_mesh),
          sceneOf(bodies, {})};
}

TEST(NearestPairs, AreThoseOfTheWorldInEveryPostureAndInAnyNumberOfLanes) {
  std::mt19937_64 random(2);
  for (const Scene& scene : manyScenes()) {
    const CollisionWorld world(scene);
    const NearestPairs pairs(scene);
    std::vector<Frames> postures(203);
    for (Frames& frames : postures)
      for (std::size_t k = 0; k < scene.links.size(); ++k) frames.push_back(uniformPose(random, 0.8));
    const auto alone = nearestOf(pairs, postures, kernels::kernels().front());
    for (std::size_t k = 0; k < postures.size(); ++k) {
      const Clearance expected = world.closest(postures[k]);
      const Clearance named = pairs.named(sideBySide({&postures[k], 1}, kernels::kernels().front()), 0, alone[k]);
      // For overlapping bodies only the sign of the distance is guaranteed, and any overlapping pair may be named.
      if (expected.distance < 0) {
        EXPECT_LT(alone[k].distance, 0);
        continue;
      }
      EXPECT_NEAR(alone[k].distance, expected.distance, 1e-12);
      EXPECT_EQ(named.body + named.other, expected.body + expected.other);
      EXPECT_NEAR((named.point_W - expected.point_W).norm(), 0, 1e-6);
      EXPECT_DOUBLE_EQ(named.margin, named.distance - scene.clearance);
    }
    for (const kernels::Kernel& kernel : kernels::kernels()) {
      const auto found = nearestOf(pairs, postures, kernel);
      for (std::size_t k = 0; k < postures.size(); ++k) {
        EXPECT_EQ(found[k].distance, alone[k].distance) << k << " in " << kernel.lanes;
        EXPECT_EQ(found[k].pair, alone[k].pair) << k << " in " << kernel.lanes;
      }
    }
  }
}

TEST(NearestPairs, APoseThatIsNotANumberIsNeverFreeAndSpoilsNoNeighbour) {
  const Scene scene =
      sceneOf({capsule({0, 0, 0}, {0.3, 0, 0}, 0.05), capsule({0, 0, 0}, {0, 0, 0.3}, 0.05)}, obstaclesOfAllKinds());
  const NearestPairs pairs(scene);
  std::mt19937_64 random(3);
  std::vector<Frames> postures(8);
  for (Frames& frames : postures) frames = {uniformPose(random, 0.5), uniformPose(random, 0.5)};
  const auto sound = nearestOf(pairs, postures, kernels::kernels().front());
  postures[3][1].translation().y() = std::nan("");
  for (const kernels::Kernel& kernel : kernels::kernels()) {
    const auto found = nearestOf(pairs, postures, kernel);
    for (std::size_t k = 0; k < postures.size(); ++k)
      if (k == 3) {
        EXPECT_TRUE(std::isnan(found[k].distance));
      } else {
        EXPECT_EQ(found[k].distance, sound[k].distance);
      }
  }
  const Clearance lost = pairs.named(sideBySide({&postures[3], 1}, kernels::kernels().front()), 0, {});
  EXPECT_FALSE(lost.margin >= 0);
  EXPECT_EQ(describe(lost), "link1: its pose is not a number");
}

TEST(NearestPairs, NothingToTouchIsInfinitelyFar) {
  const NearestPairs pairs(sceneOf({capsule({0, 0, 0}, {1, 0, 0}, 0.1)}, {}));
  const auto found = nearestOf(pairs, {{Isometry3d::Identity()}}, kernels::kernels().back());
  EXPECT_EQ(found[0].pair, -1);
  const Clearance named =
      pairs.named(sideBySide(std::vector<Frames>{{Isometry3d::Identity()}}, kernels::kernels().front()), 0, found[0]);
  EXPECT_EQ(describe(named), "nothing is near the arm");
}

}  // namespace
}  // namespace tubeplan::planner
