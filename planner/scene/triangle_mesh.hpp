// A surface of triangles as data, and its topology.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace tubeplan::planner {

/// Corners in any unit; a triangle is three indices of them.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
};

/// Largest number of triangles; more would take seconds to read at every command.
inline constexpr std::size_t kMostTriangles = 2'000'000;

/// Returns the problem of a mesh; empty if it is usable. A usable mesh has triangles, not too many, with corners that
/// exist and are finite numbers of at most a million, and not all of them degenerate.
[[nodiscard]] std::string findMeshProblem(const TriangleMesh& mesh);

/// Topology of the triangles. Corners at the same coordinates count as one.
struct MeshSurvey {
  std::size_t open_edges = 0;    ///< edges with an odd number of triangles
  std::size_t turned_edges = 0;  ///< edges passed more often one way than the other: neighbours that face opposite ways
  Eigen::AlignedBox3d bounds;
  /// Returns true if the surface has an inside: round any edge as many triangles face one way as the other.
  [[nodiscard]] bool isClosed() const { return open_edges == 0 && turned_edges == 0; }
};

/// Surveys a mesh, which must be free of problems.
[[nodiscard]] MeshSurvey surveyMesh(const TriangleMesh& mesh);

/// Returns "solid", or "a surface: 12 edges are open", to follow "it is ".
[[nodiscard]] std::string describe(const MeshSurvey& survey);

}  // namespace tubeplan::planner
