#include "planner/scene/mesh_shape.hpp"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>

#include "planner/scene/separation.hpp"
#include "planner/scene/triangle_distance.hpp"
#include "planner/verification/lipschitz_distance.hpp"
#include "tests/planner/scene/meshes.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using testing::meshShape;
using testing::solid;
using testing::uniform;
using testing::uniformPose;
using testing::uniformVector;

Capsule anyCapsule(std::mt19937_64& generator, double extent, double radius) {
  const Vector3d from = uniformVector(generator, -extent, extent);
  const double length = uniform(generator, 0, 1) < 0.1 ? 0 : uniform(generator, 0.01, 0.8);
  return {from, from + length * uniformVector(generator, -1, 1).normalized(), radius};
}

Corners anyTriangle(std::mt19937_64& generator, int kind) {
  Corners t{uniformVector(generator, -1, 1), uniformVector(generator, -1, 1), uniformVector(generator, -1, 1)};
  if (kind % 5 == 1) t[2] = t[0] + 0.4 * (t[1] - t[0]) + std::pow(10, -kind % 15) * uniformVector(generator, -1, 1);
  if (kind % 17 == 2) t[2] = t[1];
  if (kind % 29 == 3) t[1] = t[2] = t[0];
  return t;
}

/// Points spread over a triangle, so that every point of the triangle is within `spacing` [m] of one of them.
struct Spread {
  std::vector<Vector3d> points;
  double spacing;
};
Spread spreadOver(const Corners& t, int steps) {
  Spread spread{{}, std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()}) / steps};
  for (int i = 0; i <= steps; ++i)
    for (int k = 0; i + k <= steps; ++k)
      spread.points.push_back(t[0] + double(i) / steps * (t[1] - t[0]) + double(k) / steps * (t[2] - t[0]));
  return spread;
}

TEST(TriangleDistance, SegmentsAgainstDenseSampling) {
  std::mt19937_64 generator(1);
  for (int round = 0; round < 1500; ++round) {
    const Corners t = anyTriangle(generator, round);
    const Capsule c = anyCapsule(generator, 1.2, 0);
    const Spread spread = spreadOver(t, 40);
    double sampled = std::numeric_limits<double>::infinity();
    for (const Vector3d& p : spread.points) {
      const auto pair = nearestPoints(c.from, c.to, p, p);
      sampled = std::min(sampled, (pair.on_a - p).norm());
    }
    const double found = gapTo(t, c.from, c.to).distance;
    EXPECT_LE(found, sampled + 1e-12) << round;
    EXPECT_GE(found, sampled - spread.spacing - 1e-12) << round;
  }
}

TEST(TriangleDistance, SegmentsThatPassThroughTheFaceTouchIt) {
  std::mt19937_64 generator(2);
  for (int round = 0; round < 2000; ++round) {
    const Corners t = anyTriangle(generator, 0);
    const double u = uniform(generator, 0.05, 0.9), v = uniform(generator, 0.02, 0.95 - u);
    const Vector3d through = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
    const Vector3d along = uniformVector(generator, -1, 1);
    EXPECT_LE(gapTo(t, through - uniform(generator, 0, 2) * along, through + along).distance, 1e-9);
  }
}

TEST(TriangleDistance, PointsAgainstDenseSampling) {
  std::mt19937_64 generator(3);
  for (int round = 0; round < 1500; ++round) {
    const Corners t = anyTriangle(generator, round);
    const Vector3d p = uniformVector(generator, -1.5, 1.5);
    const Spread spread = spreadOver(t, 60);
    double sampled = std::numeric_limits<double>::infinity();
    for (const Vector3d& q : spread.points) sampled = std::min(sampled, (p - q).norm());
    EXPECT_LE(pointGap(t, p), sampled + 1e-12);
    EXPECT_GE(pointGap(t, p), sampled - spread.spacing - 1e-12);
    EXPECT_NEAR(pointGap(t, p), gapTo(t, p, p).distance, 1e-9);
  }
}

TEST(MeshSurvey, SaysWhetherASurfaceHasAnInside) {
  TriangleMesh box = testing::boxMesh({1, 2, 3});
  EXPECT_TRUE(surveyMesh(box).isClosed());
  EXPECT_EQ(describe(surveyMesh(box)), "solid");
  EXPECT_TRUE(surveyMesh(testing::ballMesh(1, 9)).isClosed());
  EXPECT_TRUE(surveyMesh(testing::cylinderMesh(1, 1, 5)).isClosed());
  EXPECT_TRUE(surveyMesh(testing::turned(box)).isClosed());
  std::swap(box.triangles[3][0], box.triangles[3][1]);
  EXPECT_EQ(surveyMesh(box).turned_edges, 3u);
  EXPECT_EQ(surveyMesh(box).open_edges, 0u);
  box.triangles.pop_back();
  EXPECT_EQ(surveyMesh(box).open_edges, 3u);
  EXPECT_NE(describe(surveyMesh(box)).find("3 of its edges are open"), std::string::npos);
  // A box is closed even if each triangle has its own copies of its corners, as in an STL file.
  TriangleMesh unjoined;
  const TriangleMesh joined_box = testing::boxMesh({1, 2, 3});
  for (const auto& triangle : joined_box.triangles) {
    const int first = static_cast<int>(unjoined.vertices.size());
    for (const int k : triangle) unjoined.vertices.push_back(joined_box.vertices[static_cast<std::size_t>(k)]);
    unjoined.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(surveyMesh(unjoined).isClosed());
}

TEST(MeshSurvey, MeshesThatMakeNoSenseAreTold) {
  EXPECT_NE(findMeshProblem({}).find("no triangles"), std::string::npos);
  TriangleMesh mesh = testing::boxMesh({1, 1, 1});
  EXPECT_EQ(findMeshProblem(mesh), "");
  mesh.vertices[3].y() = std::nan("");
  EXPECT_NE(findMeshProblem(mesh).find("finite"), std::string::npos);
  mesh.vertices[3].y() = 1e300;
  EXPECT_NE(findMeshProblem(mesh).find("beyond"), std::string::npos);
  mesh = testing::boxMesh({1, 1, 1});
  mesh.triangles[5][2] = 8;
  EXPECT_NE(findMeshProblem(mesh).find("does not exist"), std::string::npos);
  mesh.triangles = {{0, 0, 1}, {2, 2, 2}};
  EXPECT_NE(findMeshProblem(mesh).find("degenerate"), std::string::npos);
  mesh.triangles.assign(kMostTriangles + 1, {0, 1, 2});
  EXPECT_NE(findMeshProblem(mesh).find("more than"), std::string::npos);
}

/// Expects random bodies to be as far from the mesh as from the exact shape, or farther by at most `sagitta` [m], the
/// largest distance of the exact surface from the mesh.
void expectAsFarAs(const MeshShape& mesh, const Shape& exact, double sagitta, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const auto box = testing::shape("box", {0, 0, 0, 0.4, 0.2, 0.1, 0, 0, 0});
  const auto cylinder = testing::shape("cylinder", {0, 0, -0.2, 0, 0, 0.2, 0.1});
  int separated = 0, touching = 0;
  for (int round = 0; round < 2000; ++round) {
    const Capsule capsule = anyCapsule(generator, 1, 0.03);
    const Isometry3d X = uniformPose(generator, 1);
    const std::pair<double, double> pairs[] = {
        {mesh.separationFrom(capsule).distance, exact.separationFrom(capsule).distance},
        {mesh.separationFrom(X, solid(box)).distance, exact.separationFrom(X, solid(box)).distance},
        {mesh.separationFrom(X, solid(cylinder)).distance, exact.separationFrom(X, solid(cylinder)).distance}};
    for (const auto& [found, known] : pairs) {
      if (known > 1e-8) {
        ++separated;
        EXPECT_GE(found, known - 1e-8);
        EXPECT_LE(found, known + sagitta + 1e-8);
      } else if (known < -0.03 - 1e-6 || sagitta < 1e-8) {
        ++touching;
        EXPECT_LE(found, 1e-8);
      }
    }
    const Vector3d p = uniformVector(generator, -1, 1);
    EXPECT_GE(mesh.pointDistance(p), exact.pointDistance(p) - 1e-8);
    EXPECT_LE(mesh.pointDistance(p), exact.pointDistance(p) + sagitta + 1e-8);
  }
  EXPECT_GT(separated, 500);
  if (sagitta < 1e-8) {
    EXPECT_GT(touching, 500);
  }
}

TEST(MeshShape, ABoxOfTrianglesIsThatBox) {
  const auto box = testing::shape("box", {0, 0, 0, 1, 0.6, 0.4, 0, 0, 0});
  expectAsFarAs(meshShape(testing::boxMesh({0.5, 0.3, 0.2})), *box, 1e-9, 11);
  expectAsFarAs(meshShape(testing::turned(testing::boxMesh({0.5, 0.3, 0.2}))), *box, 1e-9, 12);
}

TEST(MeshShape, ABallIsFoundWithinItsTessellation) {
  const int rings = 40;
  const double radius = 0.5, sagitta = radius * (1 - std::pow(std::cos(std::numbers::pi / rings / 2), 2));
  expectAsFarAs(meshShape(testing::ballMesh(radius, rings)), *testing::shape("sphere", {0, 0, 0, radius}),
                1.01 * sagitta, 13);
}

TEST(MeshShape, ACylinderIsFoundWithinItsTessellation) {
  const int sides = 48;
  const double radius = 0.4, sagitta = radius * (1 - std::cos(std::numbers::pi / sides));
  expectAsFarAs(meshShape(testing::cylinderMesh(radius, 0.3, sides)),
                *testing::shape("cylinder", {0, 0, -0.3, 0, 0, 0.3, radius}), sagitta, 14);
}

TEST(MeshShape, ABodyWhollyInsideAClosedMeshTouchesIt) {
  const auto ball = testing::shape("sphere", {0, 0, 0, 0.01});
  const MeshShape closed = meshShape(testing::boxMesh({1, 1, 1}));
  EXPECT_LT(closed.separationFrom({{0.1, 0.2, 0.3}, {0.3, 0.2, 0.1}, 0.01}).distance, 0);
  EXPECT_LT(
      closed.separationFrom(Isometry3d::Identity(), solid(testing::shape("box", {0, 0, 0, 1, 1, 1, 0, 0, 0}))).distance,
      0);
  EXPECT_LT(closed.pointDistance({0, 0, 0.9}), -0.09);
  EXPECT_FALSE(closed.isFartherThan(0.1, {{0, 0, 0}, {0.1, 0, 0}, 0.01}));
  TriangleMesh box = testing::boxMesh({1, 1, 1});
  box.triangles.pop_back();
  const MeshShape open = meshShape(box);
  EXPECT_NEAR(open.separationFrom({{0.1, 0.2, 0.3}, {0.3, 0.2, 0.1}, 0.01}).distance, 0.69, 1e-12);
  EXPECT_NEAR(open.pointDistance({0, 0, -0.9}), 0.1, 1e-12);
}

TEST(MeshShape, OverlappingShellsAreOneSolidAndATurnedOneWithinIsARoom) {
  const TriangleMesh big = testing::boxMesh({1, 1, 1}), small = testing::boxMesh({0.5, 0.5, 0.5});
  const MeshShape overlapping = meshShape(testing::joined(big, testing::boxMesh({1, 1, 1}, {0.7, 0, 0})));
  EXPECT_LT(overlapping.pointDistance({0.4, 0.1, 0.1}), 0);
  EXPECT_LT(overlapping.pointDistance({-0.5, 0.1, 0.1}), 0);
  EXPECT_GT(overlapping.pointDistance({1.8, 0.1, 0.1}), 0);
  const MeshShape nested = meshShape(testing::joined(big, small));
  EXPECT_LT(nested.pointDistance({0.1, 0.1, 0.1}), 0);
  const MeshShape hollow = meshShape(testing::joined(big, testing::turned(small)));
  EXPECT_NEAR(hollow.pointDistance({0.1, 0, 0}), 0.4, 1e-12);
  EXPECT_LT(hollow.pointDistance({0.7, 0, 0}), 0);
  EXPECT_NEAR(hollow.separationFrom({{0, 0, 0}, {0.1, 0, 0}, 0.1}).distance, 0.3, 1e-12);
}

TEST(MeshShape, InsideAndOutsideAreToldFromEveryPlace) {
  // Inside and outside are distinguished even at lattice points, many of which are in line with corners, edges and
  // faces of the mesh.
  const MeshShape box = meshShape(testing::boxMesh({1, 1, 1}));
  const MeshShape ball = meshShape(testing::ballMesh(1, 12));
  for (int i = -7; i <= 7; ++i)
    for (int j = -7; j <= 7; ++j)
      for (int k = -7; k <= 7; ++k) {
        const Vector3d p = Vector3d(i, j, k) / 4.0;
        const double beyond = p.cwiseAbs().maxCoeff() - 1;
        if (beyond != 0) {
          EXPECT_EQ(box.pointDistance(p) < 0, beyond < 0) << p.transpose();
        }
        if (std::abs(p.norm() - 1) > 0.05) {
          EXPECT_EQ(ball.pointDistance(p) < 0, p.norm() < 1) << p.transpose();
        }
      }
}

TEST(TriangleTree, NothingNearIsLeftOut) {
  std::mt19937_64 generator(5);
  for (const int count : {1, 3, 17, 400, 3000}) {
    const TriangleMesh loose = testing::looseMesh(generator, count);
    if (!findMeshProblem(loose).empty()) continue;
    const MeshShape mesh = meshShape(loose);
    ASSERT_EQ(mesh.tree().triangles().size(), static_cast<std::size_t>(count));
    for (int round = 0; round < 60; ++round) {
      const Capsule c = anyCapsule(generator, 1.4, 0.02);
      double nearest = std::numeric_limits<double>::infinity(), point = nearest, box = nearest;
      const auto body = testing::shape("box", {0, 0, 0, 0.1, 0.2, 0.05, 0, 0, 0});
      const Isometry3d X = uniformPose(generator, 1.4), X_inverse = X.inverse();
      for (const Corners& t : mesh.tree().triangles()) {
        nearest = std::min(nearest, gapTo(t, c.from, c.to).distance);
        point = std::min(point, pointGap(t, c.from));
        box = std::min(box, gapTo({X_inverse * t[0], X_inverse * t[1], X_inverse * t[2]}, solid(body)).distance);
      }
      const double found = mesh.separationFrom(c).distance;
      if (nearest > 1e-9)
        EXPECT_NEAR(found, nearest - c.radius, 1e-12);
      else
        EXPECT_EQ(found, -c.radius);
      EXPECT_NEAR(mesh.pointDistance(c.from), point, 1e-12);
      if (box > 1e-9) {
        EXPECT_NEAR(mesh.separationFrom(X, solid(body)).distance, box, 1e-12);
      }
      for (const double distance : {0.0, 0.01, 0.1, 0.5})
        if (std::abs(nearest - c.radius - distance) > 1e-9) {
          EXPECT_EQ(mesh.isFartherThan(distance, c), nearest - c.radius > distance);
        }
    }
  }
}

TEST(MeshShape, NeverFartherThanDensePoints) {
  std::mt19937_64 generator(6);
  const TriangleMesh loose = testing::looseMesh(generator, 60);
  const MeshShape mesh = meshShape(loose);
  std::vector<Vector3d> points;
  for (const Corners& t : mesh.tree().triangles())
    for (const Vector3d& p : spreadOver(t, 30).points) points.push_back(p);
  const ShapePointer bodies[] = {testing::shape("box", {0, 0, 0, 0.5, 0.2, 0.1, 0, 0, 0}),
                                 testing::shape("cylinder", {0, 0, -0.2, 0, 0, 0.2, 0.1}),
                                 testing::shape("capsule", {0, 0, -0.2, 0, 0, 0.2, 0.1})};
  for (int round = 0; round < 300; ++round)
    for (const auto& body : bodies) {
      const Isometry3d X = uniformPose(generator, 1.2), X_inverse = X.inverse();
      double sampled = std::numeric_limits<double>::infinity();
      for (const Vector3d& p : points) sampled = std::min(sampled, body->pointDistance(X_inverse * p));
      const double found = mesh.separationFrom(X, solid(body)).distance;
      EXPECT_LE(found, std::max(sampled, 0.0) + 1e-12);
      if (found > 0) {
        EXPECT_GE(found, sampled - 0.05);
      }
    }
}

TEST(MeshShape, HalvingAnAxisFindsTheSame) {
  std::mt19937_64 generator(7);
  const MeshShape meshes[] = {meshShape(testing::ballMesh(0.5, 12)), meshShape(testing::looseMesh(generator, 40)),
                              meshShape(testing::cylinderMesh(0.4, 0.3, 12))};
  for (const MeshShape& mesh : meshes)
    for (int round = 0; round < 400; ++round) {
      const Capsule c = anyCapsule(generator, 1.2, 0.03);
      const double found = mesh.separationFrom(c).distance;
      const double halved = lipschitzDistance(c, mesh, {.accuracy = 1e-6});
      if (found > 0) {
        EXPECT_LE(halved, found + 1e-9);
        EXPECT_GE(halved, found - 1e-6 - 1e-9);
      } else {
        EXPECT_LE(halved, std::max(found, -c.radius) + 1e-9);
      }
    }
}

/// Returns the distance according to the FCL library; 0 if FCL reports contact.
double byLibrary(const fcl::CollisionGeometryd& body, const Isometry3d& X, const fcl::CollisionGeometryd& mesh) {
  const fcl::DistanceRequestd request(true, false, 0, 0, 1e-9, fcl::GST_INDEP);
  fcl::DistanceResultd result;
  try {
    fcl::distance(&body, X, &mesh, Isometry3d::Identity(), request, result);
  } catch (const std::logic_error&) {
    return 0;
  }
  return std::max(result.min_distance, 0.0);
}

TEST(MeshShape, TheDistanceLibraryFindsTheSame) {
  std::mt19937_64 generator(8);
  const TriangleMesh ball = testing::ballMesh(0.5, 10);
  fcl::BVHModel<fcl::OBBRSSd> model;
  model.beginModel();
  std::vector<fcl::Triangle> triangles;
  for (const auto& [a, b, c] : ball.triangles)
    triangles.emplace_back(static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c));
  model.addSubModel(ball.vertices, triangles);
  model.endModel();
  const MeshShape mesh = meshShape(ball);
  struct Body {
    ShapePointer own;
    std::shared_ptr<fcl::CollisionGeometryd> library;
  };
  const Body bodies[] = {
      {testing::shape("capsule", {0, 0, -0.2, 0, 0, 0.2, 0.05}), std::make_shared<fcl::Capsuled>(0.05, 0.4)},
      {testing::shape("box", {0, 0, 0, 0.3, 0.2, 0.1, 0, 0, 0}), std::make_shared<fcl::Boxd>(0.3, 0.2, 0.1)},
      {testing::shape("cylinder", {0, 0, -0.2, 0, 0, 0.2, 0.05}), std::make_shared<fcl::Cylinderd>(0.05, 0.4)}};
  int compared = 0, alike = 0;
  for (int round = 0; round < 300; ++round)
    for (const Body& body : bodies) {
      const Isometry3d X = uniformPose(generator, 1);
      const Separation found = mesh.separationFrom(X, solid(body.own));
      // FCL reports no contact for a body wholly inside a mesh, so bodies that overlap it are not compared.
      if (found.distance < 0) continue;
      ++compared;
      // `found.distance` is a proved lower bound; a point of the body at this distance from the mesh shows that it is
      // attained.
      EXPECT_NEAR(body.own->pointDistance(X.inverse() * found.point), 0, 1e-9);
      EXPECT_NEAR(mesh.pointDistance(found.point), found.distance, 1e-8);
      // Known errors of FCL make its distances too large, never too small.
      const double other = byLibrary(*body.library, X, model);
      EXPECT_GE(other, found.distance - 1e-7);
      alike += other < found.distance + 2e-5;
    }
  EXPECT_GT(compared, 300);
  EXPECT_GT(alike, 0.99 * compared);
}

}  // namespace
}  // namespace tubeplan::planner
