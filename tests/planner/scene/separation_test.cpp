#include "planner/scene/separation.hpp"

#include <gtest/gtest.h>

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

Isometry3d at(double x, double y, double z) {
  Isometry3d X = Isometry3d::Identity();
  X.translation() = Vector3d(x, y, z);
  return X;
}

/// Returns the distance of a segment from a shape by ternary search on the shape's point distance, which is convex
/// along the segment.
double segmentDistance(const Shape& shape, Vector3d a, Vector3d b) {
  for (int i = 0; i < 200; ++i) {
    const Vector3d third = a + (b - a) / 3, two_thirds = b - (b - a) / 3;
    if (shape.pointDistance(third) < shape.pointDistance(two_thirds))
      b = two_thirds;
    else
      a = third;
  }
  return shape.pointDistance(0.5 * (a + b));
}

TEST(NearestPoints, CrossedSegmentsAreAsFarAsTheirPlanes) {
  const auto pair = nearestPoints({-1, 0, 0}, {1, 0, 0}, {0, -1, 0.3}, {0, 1, 0.3});
  EXPECT_NEAR((pair.on_a - pair.on_b).norm(), 0.3, 1e-15);
  EXPECT_NEAR(pair.on_a.norm(), 0, 1e-15);
}

TEST(NearestPoints, ParallelAndDegenerateSegments) {
  const auto distance = [](Vector3d a0, Vector3d a1, Vector3d b0, Vector3d b1) {
    const auto pair = nearestPoints(a0, a1, b0, b1);
    return (pair.on_a - pair.on_b).norm();
  };
  EXPECT_NEAR(distance({0, 0, 0}, {1, 0, 0}, {0.5, 0.2, 0}, {3, 0.2, 0}), 0.2, 1e-15);
  EXPECT_NEAR(distance({0, 0, 0}, {1, 0, 0}, {4, 4, 0}, {9, 4, 0}), 5, 1e-15);
  EXPECT_NEAR(distance({0, 0, 0}, {1, 0, 0}, {0.25, 0, 2}, {0.25, 0, 2}), 2, 1e-15);
  EXPECT_NEAR(distance({1, 2, 3}, {1, 2, 3}, {1, 2, 5}, {1, 2, 5}), 2, 1e-15);
  EXPECT_NEAR(distance({0, 0, 0}, {1, 0, 0}, {1, 1e-9, 0}, {2, 1 + 1e-9, 0}), 1e-9, 1e-15);
}

TEST(NearestPoints, NoSampledPairIsNearer) {
  std::mt19937_64 generator(3);
  for (int trial = 0; trial < 300; ++trial) {
    const Vector3d a0 = uniformVector(generator, -1, 1), a1 = uniformVector(generator, -1, 1),
                   b0 = uniformVector(generator, -1, 1);
    // Every other pair of segments is nearly parallel.
    const Vector3d b1 = trial % 2 ? uniformVector(generator, -1, 1)
                                  : Vector3d(b0 + 0.7 * (a1 - a0) + 1e-7 * uniformVector(generator, -1, 1));
    const auto pair = nearestPoints(a0, a1, b0, b1);
    const double distance = (pair.on_a - pair.on_b).norm();
    double sampled = 1e9;
    for (int i = 0; i <= 2000; ++i) {
      const Vector3d p = a0 + i / 2000.0 * (a1 - a0), along = b1 - b0;
      const double t = std::clamp(along.dot(p - b0) / along.squaredNorm(), 0.0, 1.0);
      sampled = std::min(sampled, (b0 + t * along - p).norm());
    }
    EXPECT_LE(distance, sampled + 1e-12);
    EXPECT_GE(distance, sampled - 2e-3);  // the samples are less than 2e-3 apart
  }
}

TEST(CapsuleSeparation, ClosedForms) {
  const auto a = shape("capsule", {0, 0, 0, 1, 0, 0, 0.1}), b = shape("capsule", {0, 0, 0, 0, 0, 1, 0.2});
  EXPECT_NEAR(separation(at(0, 0, 0), solid(a), at(0.5, 1, -0.5), solid(b)).distance, 0.7, 1e-15);
  EXPECT_NEAR(separation(at(0, 0, 0), solid(a), at(4, 4, 0), solid(b)).distance, 4.7, 1e-15);
  EXPECT_NEAR(separation(at(0, 0, 0), solid(a), at(0.5, 0.25, -0.5), solid(b)).distance, -0.05, 1e-15);
  const auto touching = separation(at(0, 0, 0), solid(a), at(0.5, 1, -0.5), solid(b));
  EXPECT_NEAR((touching.point - Vector3d(0.5, 0.1, 0)).norm(), 0, 1e-15);
}

TEST(PlaneSeparation, ExactForEveryBody) {
  const auto plane = shape("keep_side", {0, 0, 1, 0, 0, -2});  // keeps bodies at z < 1
  EXPECT_NEAR(plane->separationFrom(at(5, 6, 0), solid(shape("sphere", {0, 0, 0, 0.25}))).distance, 0.75, 1e-15);
  EXPECT_NEAR(plane->separationFrom(at(0, 0, 0), solid(shape("capsule", {0, 0, 0, 1, 1, 0.5, 0.1}))).distance, 0.4,
              1e-15);
  Isometry3d X = at(0, 0, 0);
  X.rotate(Eigen::AngleAxisd(std::numbers::pi / 4, Vector3d::UnitX()));
  const auto tilted = plane->separationFrom(X, solid(shape("box", {0, 0, 0, 1, 1, 1, 0, 0, 0})));
  EXPECT_NEAR(tilted.distance, 1 - std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(tilted.point.z(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(plane->separationFrom(X, solid(shape("cylinder", {0, 0, -1, 0, 0, 1, 0.5}))).distance,
              1 - 1.5 * std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(plane->separationFrom(at(0, 0, 2), solid(shape("sphere", {0, 0, 0, 0.25}))).distance, -1.25, 1e-15);
}

TEST(SphereInteriorSeparation, ExactForEveryBody) {
  const auto bowl = shape("inside_of.sphere", {0, 0, 0, 2});
  EXPECT_NEAR(bowl->separationFrom(at(1, 0, 0), solid(shape("sphere", {0, 0, 0, 0.25}))).distance, 0.75, 1e-15);
  EXPECT_NEAR(bowl->separationFrom(at(0, 0, 0), solid(shape("sphere", {0, 0, 0, 0.25}))).distance, 1.75, 1e-15);
  EXPECT_NEAR(bowl->separationFrom(at(0, 0, 0), solid(shape("capsule", {0, 0, 0, 0.6, 0.8, 0, 0.1}))).distance, 0.9,
              1e-15);
  EXPECT_NEAR(bowl->separationFrom(at(0.5, 0.5, 0.5), solid(shape("box", {0, 0, 0, 1, 1, 1, 0, 0, 0}))).distance,
              2 - std::sqrt(3), 1e-15);
  EXPECT_NEAR(bowl->separationFrom(at(0, 0, 0), solid(shape("cylinder", {0, 0, 0, 0, 0, 1.2, 0.5}))).distance, 2 - 1.3,
              1e-15);
  EXPECT_NEAR(bowl->separationFrom(at(3, 0, 0), solid(shape("sphere", {0, 0, 0, 0.25}))).distance, -1.25, 1e-15);
}

/// Expects the distances of random capsules around an obstacle, some nearly in contact, to equal those found by ternary
/// search on the obstacle's point distance.
void expectRightAgainstCapsules(const ShapePointer& obstacle, int poses, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  double worst_over = 0, worst_under = 0;
  int overlapping = 0;
  for (int i = 0; i < poses; ++i) {
    const double length = i % 7 ? uniform(generator, 0.01, 1.5) : 0, radius = uniform(generator, 0.005, 0.1);
    const auto capsule = shape("capsule", {0, 0, 0, length, 0, 0, radius});
    Isometry3d X_WB = uniformPose(generator, 1.2);
    if (i % 11 == 0) X_WB.linear().setIdentity();  // parallel to the obstacle's edges and faces
    const double core = segmentDistance(*obstacle, X_WB.translation(), X_WB * Vector3d(length, 0, 0));
    const double found = obstacle->separationFrom(X_WB, solid(capsule)).distance;
    if (core < 1e-7) {
      ++overlapping;
      EXPECT_LE(found, core <= 0 ? -radius : core - radius + 1e-9);
      continue;
    }
    worst_over = std::max(worst_over, found - (core - radius));
    worst_under = std::max(worst_under, (core - radius) - found);
  }
  EXPECT_LT(worst_over, 1e-12);
  EXPECT_LT(worst_under, 1e-8);
  EXPECT_GT(overlapping, poses / 50);
  EXPECT_LT(overlapping, poses);
}

TEST(LibrarySeparation, CapsuleAndBox) {
  expectRightAgainstCapsules(shape("box", {0.1, -0.2, 0.3, 0.8, 0.5, 0.3, 0.4, -0.2, 1.1}), 6000, 11);
  expectRightAgainstCapsules(shape("box", {0, 0, 0, 1, 1, 0.5, 0, 0, 0}), 6000, 12);
}
TEST(LibrarySeparation, CapsuleAndLargeThinPlate) {
  expectRightAgainstCapsules(shape("box", {0, 0, 0, 4, 4, 1e-5, 0, 0, 0}), 3000, 13);
}
TEST(LibrarySeparation, CapsuleAndCylinder) {
  expectRightAgainstCapsules(shape("cylinder", {0, 0.1, -0.4, 0.3, 0, 0.4, 0.35}), 6000, 14);
}
TEST(LibrarySeparation, CapsuleAndCapsule) {
  expectRightAgainstCapsules(shape("capsule", {0, 0.1, -0.4, 0.3, 0, 0.4, 0.35}), 3000, 15);
}

TEST(LibrarySeparation, BoxesBySupportAndByCorners) {
  std::mt19937_64 generator(21);
  const auto obstacle = shape("box", {0, 0, 0, 1, 0.6, 0.4, 0, 0, 0}),
             body = shape("box", {0, 0, 0, 0.5, 0.3, 0.2, 0, 0, 0});
  int separated = 0;
  for (int i = 0; i < 3000; ++i) {
    const Isometry3d X = uniformPose(generator, 1.2);
    const double found = obstacle->separationFrom(X, solid(body)).distance;
    // Upper bound of the true distance: the smallest distance of the body's edges from the obstacle.
    double sampled = 1e9;
    for (int edge = 0; edge < 12; ++edge) {
      const int axis = edge / 4;
      Vector3d from = Vector3d(0.25, 0.15, 0.1);
      from[(axis + 1) % 3] *= edge & 1 ? 1 : -1;
      from[(axis + 2) % 3] *= edge & 2 ? 1 : -1;
      Vector3d to = from;
      to[axis] = -from[axis];
      sampled = std::min(sampled, segmentDistance(*obstacle, X * from, X * to));
    }
    EXPECT_LE(found, std::max(sampled, 0.0) + 1e-12);
    // The distance must not change if body and obstacle are exchanged, even if a corner of the obstacle is nearest to a
    // face.
    const double other_way = body->separationFrom(X.inverse(), solid(obstacle)).distance;
    if (found <= 1e-6) continue;
    EXPECT_NEAR(found, other_way, 1e-8);
    ++separated;
  }
  EXPECT_GT(separated, 500);
}

TEST(LibrarySeparation, TouchingAndAlmostTouchingIsNeverCalledFar) {
  const auto box = shape("box", {0, 0, 0, 1, 1, 1, 0, 0, 0});
  for (const double gap : {0.0, 1e-15, 1e-12, 1e-10, 1e-8, 1e-6}) {
    for (const char* body : {"box", "cylinder"}) {
      const auto other = shape(body, body[0] == 'b' ? std::vector<double>{0, 0, 0, 1, 1, 1, 0, 0, 0}
                                                    : std::vector<double>{-0.5, 0, 0, 0.5, 0, 0, 0.5});
      EXPECT_LE(box->separationFrom(at(1 + gap, 0, 0), solid(other)).distance, gap + 1e-15) << body << gap;
      EXPECT_LE(box->separationFrom(at(1 + gap, 0.3, -0.2), solid(other)).distance, gap + 1e-15) << body << gap;
    }
  }
}

}  // namespace
}  // namespace tubeplan::planner
