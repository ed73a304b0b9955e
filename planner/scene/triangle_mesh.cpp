#include "planner/scene/triangle_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<int, 3>;

constexpr double kFarthest = 1e6;

bool isBefore(const Vector3d& a, const Vector3d& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// The same number for corners in the same place: files of some kinds repeat a corner for every triangle.
std::vector<int> placesOf(const std::vector<Vector3d>& vertices) {
  std::vector<int> order(vertices.size()), place(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int k) -> const Vector3d& { return vertices[static_cast<std::size_t>(k)]; };
  std::ranges::sort(order, [&](int a, int b) { return isBefore(at(a), at(b)); });
  int next = -1;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || at(order[k - 1]) != at(order[k])) ++next;
    place[static_cast<std::size_t>(order[k])] = next;
  }
  return place;
}

struct EdgeUse {
  std::uint64_t edge;
  int sense;  ///< 1 from the lower to the higher corner, else -1
};

std::vector<EdgeUse> edgeUses(const TriangleMesh& mesh) {
  const std::vector<int> place = placesOf(mesh.vertices);
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const auto from = static_cast<std::uint64_t>(place[static_cast<std::size_t>(triangle[k])]);
      const auto to = static_cast<std::uint64_t>(place[static_cast<std::size_t>(triangle[(k + 1) % 3])]);
      // An edge without length, of a triangle without a face, is passed both ways: it opens nothing.
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
  if (mesh.triangles.empty()) return "a mesh without triangles";
  if (mesh.triangles.size() > kMostTriangles)
    return fmt::format("a mesh of {} triangles, more than {}", mesh.triangles.size(), kMostTriangles);
  for (const Vector3d& vertex : mesh.vertices) {
    if (!vertex.allFinite()) return "a mesh with a corner that is not a finite number";
    if (vertex.cwiseAbs().maxCoeff() > kFarthest) return fmt::format("a mesh with a corner beyond {:g}", kFarthest);
  }
  const int vertices = static_cast<int>(mesh.vertices.size());
  for (const Triangle& triangle : mesh.triangles)
    if (std::ranges::any_of(triangle, [&](int k) { return k < 0 || k >= vertices; }))
      return "a mesh with a triangle whose corner does not exist";
  if (std::ranges::none_of(mesh.triangles, [&](const Triangle& triangle) { return hasFace(mesh, triangle); }))
    return "a mesh of degenerate triangles only";
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
