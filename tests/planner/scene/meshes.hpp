// Meshes for tests: triangulated boxes, balls and cylinders, and random triangles.
#pragma once

#include <cmath>
#include <numbers>

#include "planner/scene/mesh_shape.hpp"
#include "tests/planner/toy_arm.hpp"

namespace tubeplan::planner::testing {

inline void addQuad(TriangleMesh& mesh, int a, int b, int c, int d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

/// Returns a box with corners at `centre` +- `half`; each face has two triangles, counter-clockwise seen from outside.
inline TriangleMesh boxMesh(const Eigen::Vector3d& half, const Eigen::Vector3d& centre = Eigen::Vector3d::Zero()) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.vertices.push_back(centre +
                            half.cwiseProduct(Eigen::Vector3d(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)));
  addQuad(mesh, 0, 2, 3, 1);
  addQuad(mesh, 4, 5, 7, 6);
  addQuad(mesh, 0, 1, 5, 4);
  addQuad(mesh, 2, 6, 7, 3);
  addQuad(mesh, 0, 4, 6, 2);
  addQuad(mesh, 1, 3, 7, 5);
  return mesh;
}

/// Returns a prism about z that is inscribed in the cylinder.
inline TriangleMesh cylinderMesh(double radius, double half_length, int sides) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, -half_length}, {0, 0, half_length}};
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    for (const double z : {-half_length, half_length})
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  for (int k = 0; k < sides; ++k) {
    const int corner = 2 + 2 * k, next_corner = 2 + 2 * ((k + 1) % sides);
    mesh.triangles.push_back({0, next_corner, corner});
    mesh.triangles.push_back({1, corner + 1, next_corner + 1});
    addQuad(mesh, corner, next_corner, next_corner + 1, corner + 1);
  }
  return mesh;
}

/// Returns a mesh with corners on a sphere about the origin, arranged by latitude and longitude.
inline TriangleMesh ballMesh(double radius, int rings) {
  TriangleMesh mesh;
  const int sides = 2 * rings;
  mesh.vertices = {{0, 0, -radius}, {0, 0, radius}};
  for (int ring = 1; ring < rings; ++ring)
    for (int k = 0; k < sides; ++k) {
      const double latitude = std::numbers::pi * (double(ring) / rings - 0.5), angle = 2 * std::numbers::pi * k / sides;
      mesh.vertices.emplace_back(radius * std::cos(latitude) * std::cos(angle),
                                 radius * std::cos(latitude) * std::sin(angle), radius * std::sin(latitude));
    }
  const auto at = [&](int ring, int k) { return 2 + (ring - 1) * sides + k % sides; };
  for (int k = 0; k < sides; ++k) {
    mesh.triangles.push_back({0, at(1, k + 1), at(1, k)});
    mesh.triangles.push_back({1, at(rings - 1, k), at(rings - 1, k + 1)});
    for (int ring = 1; ring + 1 < rings; ++ring)
      addQuad(mesh, at(ring, k), at(ring, k + 1), at(ring + 1, k + 1), at(ring + 1, k));
  }
  return mesh;
}

/// Returns random triangles, of which some are almost lines, some are lines and some are points.
inline TriangleMesh looseMesh(std::mt19937_64& generator, int triangles) {
  TriangleMesh mesh;
  for (int k = 0; k < triangles; ++k) {
    const Eigen::Vector3d a = uniformVector(generator, -1, 1), ab = uniformVector(generator, -0.4, 0.4);
    Eigen::Vector3d ac = uniformVector(generator, -0.4, 0.4);
    if (k % 7 == 0) ac = 0.3 * ab + std::pow(10, uniform(generator, -14, -4)) * uniformVector(generator, -1, 1);
    if (k % 31 == 0) ac = 2 * ab;
    const Eigen::Vector3d b = k % 43 == 0 ? a : Eigen::Vector3d(a + ab);
    mesh.vertices.insert(mesh.vertices.end(), {a, b, k % 43 == 0 ? a : Eigen::Vector3d(a + ac)});
    mesh.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
  }
  return mesh;
}

inline TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const int first = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [i, j, k] : b.triangles) a.triangles.push_back({first + i, first + j, first + k});
  return a;
}

inline TriangleMesh turned(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

inline MeshShape meshShape(const TriangleMesh& mesh) { return {mesh, Eigen::Isometry3d::Identity()}; }

}  // namespace tubeplan::planner::testing
