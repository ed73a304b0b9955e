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

/// Largest number of triangles; reading more would take seconds at every command.
inline constexpr std::size_t kMostTriangles = 2'000'000;

/// Returns the problem of a mesh; empty if the mesh is usable. A usable mesh has triangles, at most kMostTriangles and
/// not all degenerate, and their corners exist and have finite coordinates of at most a million.
[[nodiscard]] std::string findMeshProblem(const TriangleMesh& mesh);

/// Topology of a mesh. Corners at the same coordinates count as one.
struct MeshSurvey {
  std::size_t open_edges = 0;  ///< edges that belong to an odd number of triangles
  /// Edges whose triangles traverse them more often in one direction: adjacent triangles have opposite orientations.
  std::size_t turned_edges = 0;
  Eigen::AlignedBox3d bounds;
  /// Returns true if the surface has an inside: at every edge, as many triangles traverse it in one direction as in the
  /// other.
  [[nodiscard]] bool isClosed() const { return open_edges == 0 && turned_edges == 0; }
};

/// Surveys a mesh, which must be free of problems (findMeshProblem()).
[[nodiscard]] MeshSurvey surveyMesh(const TriangleMesh& mesh);

/// Returns a phrase to follow "it is ", such as "solid" or "a surface: 12 of its edges are open".
[[nodiscard]] std::string describe(const MeshSurvey& survey);

}  // namespace tubeplan::planner
