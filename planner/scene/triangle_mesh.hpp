// A triangle mesh as data, and its topology.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace tubeplan::planner {

/// Corners in any unit of length, and triangles of three corner indices each.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
};

/// Largest permitted number of triangles; a larger mesh would take seconds to read in every command.
inline constexpr std::size_t kMostTriangles = 2'000'000;

/// Returns the reason why a mesh is unusable; an empty string if it is usable. A usable mesh has at least one and at
/// most kMostTriangles triangles, not all degenerate. All corner indices are valid, and all coordinates of these
/// corners are finite and at most a million.
[[nodiscard]] std::string findMeshProblem(const TriangleMesh& mesh);

/// Topology of a mesh. Corners with the same coordinates are merged.
struct MeshSurvey {
  std::size_t open_edges = 0;  ///< edges that belong to an odd number of triangles
  /// Other edges that are traversed more often in one direction than in the other, because adjacent triangles have
  /// opposite orientations.
  std::size_t turned_edges = 0;
  Eigen::AlignedBox3d bounds;
  /// Returns true if the surface has an inside: every edge is traversed equally often in both directions.
  [[nodiscard]] bool isClosed() const { return open_edges == 0 && turned_edges == 0; }
};

/// Returns the topology of a mesh, which must be usable (findMeshProblem()).
[[nodiscard]] MeshSurvey surveyMesh(const TriangleMesh& mesh);

/// Returns a phrase to follow "it is ", such as "solid" or "a surface: 12 of its edges are open".
[[nodiscard]] std::string describe(const MeshSurvey& survey);

}  // namespace tubeplan::planner
