// A tree of boxes around triangles, which finds triangles near a body without testing all of them.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "planner/scene/triangle_mesh.hpp"

namespace tubeplan::planner {

using Corners = std::array<Eigen::Vector3d, 3>;

/// Returns the smallest coordinate of the triangle's corners along a direction.
[[nodiscard]] inline double leastAlong(const Corners& triangle, const Eigen::Vector3d& direction) {
  return std::min({direction.dot(triangle[0]), direction.dot(triangle[1]), direction.dot(triangle[2])});
}

class TriangleTree {
 public:
  /// `mesh` must be usable (findMeshProblem()); X_FM is the pose of its frame M in F.
  TriangleTree(const TriangleMesh& mesh, const Eigen::Isometry3d& X_FM);

  [[nodiscard]] const Eigen::AlignedBox3d& bounds() const { return nodes_.front().box; }
  [[nodiscard]] std::span<const Corners> triangles() const { return triangles_; }

  /// Calls `look(corners)` for triangles, starting with those in the nearest boxes. `distance_of(box, least)` returns a
  /// lower bound of the distance of the triangles in a box; boxes with a bound of `least` or more are skipped. `look`
  /// lowers `least` when it finds a nearer triangle.
  template <class DistanceOf, class Look>
  void nearestFirst(const DistanceOf& distance_of, const Look& look, const double& least) const {
    descend(0, distance_of(nodes_.front().box, least), distance_of, look, least);
  }

  /// Returns the winding number of the surface around p_F, which is not zero inside a closed mesh. It is the number of
  /// triangles along a ray from p_F that face in the ray's direction minus the number that face against it. Returns
  /// std::nullopt if all rays tried pass too close to an edge, for example if the point is on the surface.
  [[nodiscard]] std::optional<int> windingNumber(const Eigen::Vector3d& p_F) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int first = 0, count = 0;  ///< range of the triangles of a leaf
    int right = 0;             ///< index of the second child, the first child being the next node; 0 for a leaf
  };
  struct Item;  ///< a triangle while the tree is built

  void build(std::span<Item> items, int depth);
  static std::size_t splitByArea(std::span<Item> items, const Eigen::AlignedBox3d& middles, Eigen::Index axis);

  template <class DistanceOf, class Look>
  void descend(int at, double distance, const DistanceOf& distance_of, const Look& look, const double& least) const {
    if (!(distance < least)) return;
    const Node& node = nodes_[static_cast<std::size_t>(at)];
    if (node.right == 0) {
      for (int k = node.first; k < node.first + node.count; ++k) look(triangles_[static_cast<std::size_t>(k)]);
      return;
    }
    int nearer = at + 1, farther = node.right;
    double near = distance_of(nodes_[static_cast<std::size_t>(nearer)].box, least);
    double far = distance_of(nodes_[static_cast<std::size_t>(farther)].box, least);
    if (far < near) std::swap(near, far), std::swap(nearer, farther);
    descend(nearer, near, distance_of, look, least);
    descend(farther, far, distance_of, look, least);
  }

  std::vector<Node> nodes_;
  std::vector<Corners> triangles_;  ///< corners in the order of the leaves
};

}  // namespace tubeplan::planner
