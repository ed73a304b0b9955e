#include "planner/scene/segment_distance.hpp"

#include <gtest/gtest.h>

#include "planner/scene/separation.hpp"
#include "tests/planner/toy_arm.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using testing::shape;
using testing::solid;
using testing::uniform;
using testing::uniformPose;
using testing::uniformVector;

double distanceOf(const SegmentNearest& nearest) { return (nearest.on_segment - nearest.on_solid).norm(); }

TEST(NearestToBox, FaceEdgeCornerAndThrough) {
  const Vector3d half(1, 2, 3);
  EXPECT_NEAR(distanceOf(nearestToBox({-4, 0, 3.5}, {4, 0.5, 3.5}, half)), 0.5, 1e-15);
  EXPECT_NEAR(distanceOf(nearestToBox({4, 0, 0}, {0, 8, 0}, half)), 4 / std::sqrt(5), 1e-15);
  EXPECT_NEAR(distanceOf(nearestToBox({2, 3, 4}, {5, 6, 7}, half)), std::sqrt(3), 1e-15);
  EXPECT_NEAR(distanceOf(nearestToBox({2, 3, 4}, {2, 3, 4}, half)), std::sqrt(3), 1e-15);
  EXPECT_EQ(distanceOf(nearestToBox({-5, -5, -5}, {5, 5, 5}, half)), 0);
  EXPECT_EQ(distanceOf(nearestToBox({0, 0, 0}, {0.1, 0, 0}, half)), 0);
}

TEST(NearestToCylinder, SideEndRimAndThrough) {
  EXPECT_NEAR(distanceOf(nearestToCylinder({3, -4, 0}, {3, 4, 1}, 2, 5)), 1, 1e-15);
  EXPECT_NEAR(distanceOf(nearestToCylinder({1, -1, 7}, {-1, 1, 7}, 2, 5)), 2, 1e-15);
  EXPECT_NEAR(distanceOf(nearestToCylinder({5, 0, 9}, {9, 0, 20}, 2, 5)), 5, 1e-15);
  EXPECT_NEAR(distanceOf(nearestToCylinder({6, 0, 5}, {2, 0, 9}, 2, 5)), std::sqrt(8), 1e-15);
  EXPECT_EQ(distanceOf(nearestToCylinder({-5, 0.1, -1}, {5, 0, 1}, 2, 5)), 0);
  EXPECT_EQ(distanceOf(nearestToCylinder({0, 0, -9}, {0, 0, 9}, 2, 5)), 0);
}

/// Returns the distance of a segment from a convex shape, found by ternary search along the segment; 0 if they meet.
double byThirds(const Shape& shape, Vector3d a, Vector3d b) {
  for (int i = 0; i < 200; ++i) {
    const Vector3d third = a + (b - a) / 3, two_thirds = b - (b - a) / 3;
    (shape.pointDistance(third) < shape.pointDistance(two_thirds) ? b : a) =
        shape.pointDistance(third) < shape.pointDistance(two_thirds) ? two_thirds : third;
  }
  return std::max(0.0, shape.pointDistance(0.5 * (a + b)));
}

/// Returns a random segment, long or short; some are parallel or almost perpendicular to an axis.
std::pair<Vector3d, Vector3d> segmentOf(std::mt19937_64& generator, int trial) {
  const Vector3d from = uniformVector(generator, -1.5, 1.5);
  Vector3d along = uniformVector(generator, -2, 2) * std::pow(10, uniform(generator, -6, 0));
  if (trial % 3 == 0) along[trial % 9 / 3] *= 1e-9;
  if (trial % 5 == 0) along = Vector3d::Unit(trial % 3) * along.norm();
  return {from, from + along};
}

TEST(NearestToBox, AsThirdsFindIt) {
  std::mt19937_64 generator(1);
  for (int trial = 0; trial < 4000; ++trial) {
    Vector3d half = uniformVector(generator, 0.05, 1);
    if (trial % 2) half[trial % 3] = 1e-6;
    const auto box = shape("box", {0, 0, 0, 2 * half.x(), 2 * half.y(), 2 * half.z(), 0, 0, 0});
    const auto [from, to] = segmentOf(generator, trial);
    EXPECT_NEAR(distanceOf(nearestToBox(from, to, half)), byThirds(*box, from, to), 2e-8);
  }
}

TEST(NearestToCylinder, AsThirdsFindIt) {
  std::mt19937_64 generator(2);
  for (int trial = 0; trial < 4000; ++trial) {
    const double radius = uniform(generator, 0.01, 1), half = trial % 2 ? 1e-6 : uniform(generator, 0.05, 1);
    const auto cylinder = shape("cylinder", {0, 0, -half, 0, 0, half, radius});
    const auto [from, to] = segmentOf(generator, trial);
    EXPECT_NEAR(distanceOf(nearestToCylinder(from, to, radius, half)), byThirds(*cylinder, from, to), 2e-8);
  }
}

constexpr int kTrials = 10000;

ShapePointer randomSolid(const std::string& kind, std::mt19937_64& generator) {
  const auto size = [&](double low) { return uniform(generator, 0, 1) < 0.2 ? 1e-5 : uniform(generator, low, 0.8); };
  if (kind == "box") return shape("box", {0, 0, 0, size(0.1), size(0.1), size(0.1), 0.3, -0.7, 1.1});
  const double length = size(0.1), radius = size(0.02);
  if (kind == "sphere") return shape("sphere", {0.1, 0, 0, radius});
  return shape(kind.c_str(), {0, 0, -length / 2, 0, 0.2, length / 2, radius});
}

/// Returns an upper bound of the distance between a and b, found by alternating projections: each body's point is
/// replaced by the one nearest to the other body's point. For convex bodies the bound converges to the distance.
/// `starts` is the number of random starts.
double fromAbove(const Isometry3d& X_AB, const Solid& a, const Solid& b, std::mt19937_64& generator, int starts) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < starts; ++k) {
    const Vector3d direction = uniformVector(generator, -1, 1);
    Vector3d p = a.support(direction), q = X_AB * b.support(uniformVector(generator, -1, 1));
    for (int turn = 0; turn < 300; ++turn) {
      p = a.nearestTo(q, q).on_solid;
      const Vector3d p_B = X_AB.inverse() * p;
      q = X_AB * b.nearestTo(p_B, p_B).on_solid;
    }
    least = std::min(least, (p - q).norm());
  }
  return least - a.core().rounding - b.core().rounding;
}

class OfKinds : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

/// The distance is never larger than that between two points of the bodies, nor smaller than the library's by more than
/// a micro-inch. Where the two distances differ by more, alternating projections find the points.
TEST_P(OfKinds, NeverFurtherThanTwoPointsNorNearerThanTheLibrary) {
  std::mt19937_64 generator(5);
  int separated = 0, differ = 0, too_near = 0;
  double most_over = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto a = randomSolid(GetParam().first, generator), b = randomSolid(GetParam().second, generator);
    const Isometry3d X_AB = uniformPose(generator, 1);
    const double own = separation(Isometry3d::Identity(), solid(a), X_AB, solid(b)).distance;
    const double other = separationByLibrary(Isometry3d::Identity(), solid(a), X_AB, solid(b)).distance;
    separated += own > 0;
    if (std::max(own, other) <= 0 || std::abs(own - other) <= 2.54e-8) continue;
    ++differ;
    const double above = fromAbove(X_AB, solid(a), solid(b), generator, 5);
    most_over = std::max(most_over, own - above);
    // Negative distances only say that the bodies overlap, so the library's distance counts only if it is positive.
    if (own < other - 2.54e-8 && other > 0) ++too_near;
  }
  EXPECT_LE(most_over, 1e-12);
  EXPECT_EQ(too_near, 0) << "of " << differ;
  EXPECT_GT(separated, kTrials / 4);
  RecordProperty("differ", differ);
}

INSTANTIATE_TEST_SUITE_P(Pairs, OfKinds,
                         ::testing::Values(std::pair{"sphere", "box"}, std::pair{"capsule", "box"},
                                           std::pair{"box", "capsule"}, std::pair{"capsule", "cylinder"},
                                           std::pair{"capsule", "capsule"}, std::pair{"box", "box"},
                                           std::pair{"box", "cylinder"}, std::pair{"cylinder", "box"}));

}  // namespace
}  // namespace tubeplan::planner
