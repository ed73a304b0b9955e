// A surface of triangles as data, and what is known of it as a whole.
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

/// More would take seconds to read at every command.
inline constexpr std::size_t kMostTriangles = 2'000'000;

/// Empty for a mesh that can be used: it has triangles, not too many, with corners that exist and are finite numbers of
/// at most a million, not all of them without a face.
[[nodiscard]] std::string findMeshProblem(const TriangleMesh& mesh);

/// How the triangles meet. Corners in the very same place are one.
struct MeshSurvey {
  std::size_t open_edges = 0;    ///< with an odd number of triangles
  std::size_t turned_edges = 0;  ///< passed more often one way than the other: neighbours that face opposite ways
  Eigen::AlignedBox3d bounds;
  /// The surface has an inside: round any edge as many triangles face one way as the other.
  [[nodiscard]] bool isClosed() const { return open_edges == 0 && turned_edges == 0; }
};

/// The mesh must be free of problems.
[[nodiscard]] MeshSurvey surveyMesh(const TriangleMesh& mesh);

/// "solid", or "a surface: 12 edges are open", as a sentence goes on after "it is ".
[[nodiscard]] std::string describe(const MeshSurvey& survey);

}  // namespace tubeplan::planner
