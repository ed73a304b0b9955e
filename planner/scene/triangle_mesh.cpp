#include "planner/scene/triangle_mesh.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<int, 3>;

constexpr double kFarthest = 1e6;

/// Returns an index for each corner, the same for corners that coincide within the rounding of mesh files. Some file
/// formats repeat a corner for each of its triangles.
std::vector<int> placesOf(const std::vector<Vector3d>& vertices) {
  constexpr double kSame = 1e-6;  // cell size as a fraction of the mesh's extent; corners in the same cell are merged
  Eigen::AlignedBox3d box;
  for (const Vector3d& vertex : vertices) box.extend(vertex);
  const double side = std::max(kSame * box.sizes().maxCoeff(), std::numeric_limits<double>::min());
  using Cell = std::array<std::int64_t, 3>;
  const auto cellOf = [&](const Vector3d& p) {
    const Vector3d cells = (p - box.min()) / side;
    return Cell{static_cast<std::int64_t>(cells[0]), static_cast<std::int64_t>(cells[1]),
                static_cast<std::int64_t>(cells[2])};
  };
  std::map<Cell, int> first;  // index of the corner that represents each cell
  std::vector<int> place;
  for (int k = 0; k < static_cast<int>(vertices.size()); ++k) {
    const Vector3d& p = vertices[static_cast<std::size_t>(k)];
    const Cell own = cellOf(p);
    int found = k;
    for (int near = 0; near < 27 && found == k; ++near) {
      const auto at = first.find({own[0] + near % 3 - 1, own[1] + near / 3 % 3 - 1, own[2] + near / 9 - 1});
      if (at != first.end() && (vertices[static_cast<std::size_t>(at->second)] - p).norm() <= 2 * side)
        found = at->second;
    }
    if (found == k) first.emplace(own, k);
    place.push_back(found);
  }
  return place;
}

struct EdgeUse {
  std::uint64_t edge;
  int sense;  ///< 1 if the edge is traversed from the lower to the higher corner index, else -1
};

std::vector<EdgeUse> edgeUses(const TriangleMesh& mesh) {
  const std::vector<int> place = placesOf(mesh.vertices);
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const auto from = static_cast<std::uint64_t>(place[static_cast<std::size_t>(triangle[k])]);
      const auto to = static_cast<std::uint64_t>(place[static_cast<std::size_t>(triangle[(k + 1) % 3])]);
      // Edges of zero length (degenerate triangles) are skipped, because they cannot leave a gap in the surface.
      if (from != to) uses.push_back({std::min(from, to) << 32 | std::max(from, to), from < to ? 1 : -1});
    }
  std::ranges::sort(uses, {}, &EdgeUse::edge);
  return uses;
}

bool hasFace(const TriangleMesh& mesh, const Triangle& triangle) {
  const auto corner = [&](int k) -> const Vector3d& { return mesh.vertices[static_cast<std::size_t>(triangle[k])]; };
  return (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() > 0;
}

}  // namespace

std::string findMeshProblem(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return "the mesh has no triangles";
  if (mesh.triangles.size() > kMostTriangles)
    return fmt::format("the mesh has {} triangles, more than {}", mesh.triangles.size(), kMostTriangles);
  for (const Vector3d& vertex : mesh.vertices) {
    if (!vertex.allFinite()) return "a corner of the mesh is not finite";
    if (vertex.cwiseAbs().maxCoeff() > kFarthest)
      return fmt::format("a corner of the mesh lies beyond {:g} in x, y or z", kFarthest);
  }
  const int vertices = static_cast<int>(mesh.vertices.size());
  for (const Triangle& triangle : mesh.triangles)
    if (std::ranges::any_of(triangle, [&](int k) { return k < 0 || k >= vertices; }))
      return "a triangle of the mesh has a corner that does not exist";
  if (std::ranges::none_of(mesh.triangles, [&](const Triangle& triangle) { return hasFace(mesh, triangle); }))
    return "all triangles of the mesh are degenerate";
  return "";
}

MeshSurvey surveyMesh(const TriangleMesh& mesh) {
  MeshSurvey survey;
  for (const Triangle& triangle : mesh.triangles)
    for (const int k : triangle) survey.bounds.extend(mesh.vertices[static_cast<std::size_t>(k)]);
  const std::vector<EdgeUse> uses = edgeUses(mesh);
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t last = first;
    int balance = 0;
    for (; last < uses.size() && uses[last].edge == uses[first].edge; ++last) balance += uses[last].sense;
    if ((last - first) % 2 != 0)
      ++survey.open_edges;
    else if (balance != 0)
      ++survey.turned_edges;
    first = last;
  }
  return survey;
}

std::string describe(const MeshSurvey& survey) {
  if (survey.isClosed()) return "solid";
  if (survey.open_edges > 0) return fmt::format("a surface: {} of its edges are open", survey.open_edges);
  return fmt::format("a surface: at {} of its edges the triangles have opposite orientations", survey.turned_edges);
}

}  // namespace tubeplan::planner
