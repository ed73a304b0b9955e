#include "planner/verification/lipschitz_distance.hpp"

#include <gtest/gtest.h>

#include <map>

#include "planner/collision/arm_clearance.hpp"
#include "tests/planner/collision_world.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d;
using testing::mockup;
using testing::shape;
using testing::uniform;
using testing::uniformPose;
using testing::uniformVector;

const Capsule kUpright{Vector3d(0, 0, 0), Vector3d(0, 0, 0.6), 0.05};

TEST(LipschitzDistance, MeetsClosedFormsToItsAccuracyFromBelow) {
  const struct {
    ShapePointer other;
    double distance;
  } cases[] = {
      {shape("keep_side", {0, 0, -0.2, 0, 0, 1}), 0.15},            // the lower end is nearest
      {shape("keep_side", {0.3, 0, 0, -1, 0, 0}), 0.25},            // parallel: equal distance everywhere
      {shape("inside_of.sphere", {0, 0, 0.3, 1}), 0.65},            // both ends are equally near
      {shape("sphere", {0.5, 0, 0.31, 0.1}), 0.35},                 // an inner point is nearest
      {shape("capsule", {0.4, -1, 0.2, 0.4, 1, 0.2, 0.02}), 0.33},  // skew axes
      {shape("box", {0.5, 0, 0.3, 0.2, 0.2, 0.2, 0, 0, 0}), 0.35},
      {shape("cylinder", {0.5, 0, -1, 0.5, 0, 1, 0.1}), 0.35},  // parallel
      {shape("sphere", {0, 0, 0.3, 0.1}), -0.15},               // overlapping
  };
  for (const double accuracy : {1e-3, 1e-5})
    for (const auto& [other, distance] : cases) {
      const double found = lipschitzDistance(kUpright, *other, {.accuracy = accuracy});
      EXPECT_LE(found, distance + 1e-12);
      EXPECT_GE(found, distance - accuracy - 1e-12);
    }
}

TEST(LipschitzDistance, APointLikeCapsuleIsItsOneDistance) {
  const Capsule ball{Vector3d(0.1, 0, 0), Vector3d(0.1, 0, 0), 0.02};
  EXPECT_NEAR(lipschitzDistance(ball, *shape("sphere", {1, 0, 0, 0.5})), 0.38, 1e-15);
}

TEST(LipschitzDistance, ACapsuleThatIsNowhereIsClearOfNothing) {
  const Capsule lost{Vector3d(0, 0, 0), Vector3d(0, 0, std::nan("")), 0.02};
  EXPECT_EQ(lipschitzDistance(lost, *shape("sphere", {1, 0, 0, 0.5})), -std::numeric_limits<double>::infinity());
}

TEST(LipschitzDistance, NeverAboveWhatDenseSamplingOfTheAxisFinds) {
  std::mt19937_64 generator(3);
  const ShapePointer others[] = {
      shape("box", {0, 0, 0, 0.6, 0.3, 0.2, 0.3, 0.2, 0.1}), shape("cylinder", {-0.2, 0, 0.1, 0.3, 0.2, 0, 0.15}),
      shape("capsule", {0, -0.3, 0, 0, 0.3, 0.1, 0.05}), shape("inside_of.sphere", {0, 0, 0, 1.5})};
  for (int round = 0; round < 500; ++round)
    for (const auto& other : others) {
      const Capsule capsule{uniformVector(generator, -1, 1), uniformVector(generator, -1, 1),
                            uniform(generator, 0.01, 0.1)};
      double sampled = std::numeric_limits<double>::infinity();
      for (int k = 0; k <= 200; ++k)
        sampled = std::min(
            sampled, other->pointDistance(capsule.from + k / 200. * (capsule.to - capsule.from)) - capsule.radius);
      const double found = lipschitzDistance(capsule, *other, {.accuracy = 1e-5});
      EXPECT_LE(found, sampled + 1e-12);
      // Every point of the axis is within a 400th of the axis length of a sampled point.
      EXPECT_GE(found, sampled - 1e-5 - (capsule.to - capsule.from).norm() / 400);
    }
}

TEST(LipschitzDistance, ShareAndEnoughKeepTheirPromises) {
  std::mt19937_64 generator(4);
  const ShapePointer box = shape("box", {0, 0, 0, 0.6, 0.3, 0.2, 0.3, 0.2, 0.1});
  for (int round = 0; round < 2000; ++round) {
    const Capsule capsule{uniformVector(generator, -1, 1), uniformVector(generator, -1, 1), 0.02};
    const double fine = lipschitzDistance(capsule, *box, {.accuracy = 1e-7});
    const double required = 0.01, share = 0.05;
    const double coarse = lipschitzDistance(capsule, *box, {.accuracy = 1e-6, .share = share, .required = required});
    EXPECT_LE(coarse, fine + 1.1e-7);
    EXPECT_GE(coarse, fine - std::max(1e-6, share * (fine + 1e-7 - required) / (1 - share)));
    const double sufficient = uniform(generator, 0, 0.5);
    const double answer = lipschitzDistance(capsule, *box, {.accuracy = 1e-6, .sufficient = sufficient});
    EXPECT_LE(answer, fine + 1.1e-7);
    EXPECT_GE(answer, std::min(fine - 1e-6, sufficient));
  }
}

/// Returns the collision world's distance [m] for every pair that must keep clear, keyed by the names of the pair.
std::map<std::string, double> pairDistances(const CollisionWorld& world, const std::vector<Eigen::Isometry3d>& frames) {
  std::map<std::string, double> distances;
  for (const auto& pair : world.allPairs(frames))
    if (!pair.allowed) distances[pair.clearance.body + ", " + pair.clearance.other] = pair.clearance.distance;
  return distances;
}

class ByOtherMeans : public ::testing::TestWithParam<int> {};

TEST_P(ByOtherMeans, EveryPairOfTheCellIsAsFarAsTheCollisionWorldSays) {
  const Workcell cell = mockup();
  const CollisionWorld world(cell.scene);
  std::mt19937_64 generator(static_cast<std::uint64_t>(GetParam()));
  constexpr double kAccuracy = 1e-5, kLibrary = 1e-8;
  int compared = 0, separated = 0;
  for (int round = 0; round < 500; ++round) {
    const auto frames = bodyFrames(cell, testing::randomPosture(cell.arm, generator), nullptr);
    ASSERT_FALSE(frames.empty());
    const auto distances = pairDistances(world, frames);
    for (const auto& body : cell.scene.bodies)
      for (const auto& obstacle : cell.scene.obstacles) {
        // The bodies of the base-link share one label, and so one entry of `distances`; their pairs are skipped.
        if (mayTouch(obstacle, body) || body.link == "base-link") continue;
        const auto& capsule = static_cast<const Solid&>(*body.shape).around();
        const auto& X_WL = frames[static_cast<std::size_t>(body.frame_index)];
        const double found = lipschitzDistance({X_WL * capsule.from, X_WL * capsule.to, capsule.radius},
                                               *obstacle.shape, {.accuracy = kAccuracy});
        const double known = distances.at(bodyLabel(body) + ", " + obstacle.name);
        ++compared;
        if (known > 0) {
          ++separated;
          EXPECT_LE(found, known + kLibrary) << bodyLabel(body) << ", " << obstacle.name;
          EXPECT_GE(found, known - kAccuracy - kLibrary) << bodyLabel(body) << ", " << obstacle.name;
        } else {
          EXPECT_LE(found, kLibrary) << bodyLabel(body) << ", " << obstacle.name;
        }
      }
  }
  EXPECT_GT(compared, 5000);
  EXPECT_GT(separated, compared / 4);
  EXPECT_LT(separated, compared);
}

/// Returns the cell with capsules replaced: every second body by a box about its capsule's axis, every third of the
/// others by a cylinder.
Workcell withOtherSolids(Workcell cell) {
  for (std::size_t k = 0; k < cell.scene.bodies.size(); ++k) {
    Body& body = cell.scene.bodies[k];
    const Capsule& capsule = static_cast<const Solid&>(*body.shape).around();
    const Eigen::Vector3d middle = (capsule.from + capsule.to) / 2,
                          size = (capsule.to - capsule.from).cwiseAbs().array() + 1.6 * capsule.radius;
    if (k % 2 == 0)
      body.shape = shape("box", {middle.x(), middle.y(), middle.z(), size.x(), size.y(), size.z(), 0, 0, 0});
    else if (k % 3 == 0)
      body.shape = shape("cylinder", {capsule.from.x(), capsule.from.y(), capsule.from.z(), capsule.to.x(),
                                      capsule.to.y(), capsule.to.z(), capsule.radius});
  }
  return cell;
}

/// The smallest margin must be computed for the boxes and cylinders themselves, not for the capsules around them, for
/// which it is smaller.
TEST_P(ByOtherMeans, TheLeastMarginOfOtherSolidsIsTheCollisionWorlds) {
  const Workcell cell = withOtherSolids(mockup());
  const CollisionWorld world(cell.scene);
  std::mt19937_64 generator(static_cast<std::uint64_t>(GetParam()) + 200);
  constexpr double kAccuracy = 1e-6;
  int free = 0, saved = 0;
  for (int round = 0; round < 1000; ++round) {
    const auto frames = bodyFrames(cell, testing::randomPosture(cell.arm, generator), nullptr);
    const Clearance known = world.closest(frames);
    const double found = LipschitzMargins(cell.scene).at(frames, kAccuracy, 0, nullptr);
    if (known.distance <= 0) {
      EXPECT_LE(found, -cell.scene.clearance + 1e-8);
      continue;
    }
    ++free;
    EXPECT_LE(found, known.margin + 1e-8);
    EXPECT_GE(found, known.margin - kAccuracy - 1e-8);
    Scene rounded = cell.scene;
    for (Body& body : rounded.bodies) {
      const Capsule& around = static_cast<const Solid&>(*body.shape).around();
      body.shape = shape("capsule", {around.from.x(), around.from.y(), around.from.z(), around.to.x(), around.to.y(),
                                     around.to.z(), around.radius});
    }
    saved += LipschitzMargins(rounded).at(frames, kAccuracy, 0, nullptr) < found - 0.001;
  }
  EXPECT_GT(free, 50);
  EXPECT_GT(saved, 20);
}

TEST_P(ByOtherMeans, TheLeastMarginAndItsPairAreTheCollisionWorlds) {
  const Workcell cell = mockup();
  const CollisionWorld world(cell.scene);
  std::mt19937_64 generator(static_cast<std::uint64_t>(GetParam()) + 100);
  constexpr double kAccuracy = 1e-6, kShare = 0.05;
  int free = 0;
  for (int round = 0; round < 1000; ++round) {
    const auto frames = bodyFrames(cell, testing::randomPosture(cell.arm, generator), nullptr);
    const Clearance known = world.closest(frames);
    std::string names;
    const double found = LipschitzMargins(cell.scene).at(frames, kAccuracy, 0, &names);
    const double coarse = LipschitzMargins(cell.scene).at(frames, kAccuracy, kShare, nullptr);
    if (known.distance <= 0) {
      EXPECT_LE(found, -cell.scene.clearance + 1e-8);
      continue;
    }
    ++free;
    EXPECT_LE(found, known.margin + 1e-8);
    EXPECT_GE(found, known.margin - kAccuracy - 1e-8);
    EXPECT_LE(coarse, known.margin + 1e-8);
    EXPECT_GE(coarse, known.margin - std::max(kAccuracy, kShare / (1 - kShare) * known.margin) - 1e-8);
    const auto distances = pairDistances(world, frames);
    const std::size_t comma = names.find(", ");
    const std::string reversed = names.substr(comma + 2) + ", " + names.substr(0, comma);
    const double named = distances.contains(names) ? distances.at(names) : distances.at(reversed);
    EXPECT_GE(named, known.distance - 1e-8) << names;
  }
  EXPECT_GT(free, 50);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ByOtherMeans, ::testing::Values(1, 2, 3));

TEST(LipschitzMargin, NothingThatMayNotTouchIsInfinitelyFar) {
  Workcell cell = testing::alone(mockup());
  cell.scene.bodies.resize(1);
  const auto frames = bodyFrames(cell, Eigen::Vector4d(0, 1.5, -1, 0.2), nullptr);
  EXPECT_EQ(LipschitzMargins(cell.scene).at(frames, 1e-6, 0, nullptr), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace tubeplan::planner
