#include "planner/scene/triangle_tree.hpp"

#include <algorithm>
#include <cmath>

namespace tubeplan::planner {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr std::size_t kLeafTriangles = 4;
constexpr std::size_t kBins = 12;
// Depth beyond which the triangles are split into halves of equal count, so that the recursion terminates.
constexpr int kDeepestSearch = 40;
// Smallest relative triple product whose sign is reliable despite rounding.
constexpr double kTellable = 1e-12;

/// Directions of rays for the winding number. They are arbitrary, but no edge or face of a mesh is likely to be
/// parallel to them.
const std::array<Vector3d, 8> kRays = {Vector3d(0.2653, 0.5721, 0.7761),   Vector3d(-0.7393, 0.3779, 0.5573),
                                       Vector3d(0.4817, -0.8059, 0.3441),  Vector3d(0.6143, 0.2291, -0.7551),
                                       Vector3d(-0.3187, -0.5531, 0.7697), Vector3d(0.8699, -0.3413, -0.3559),
                                       Vector3d(-0.5171, 0.6827, -0.5161), Vector3d(-0.1249, -0.4363, -0.8911)};

double halfArea(const AlignedBox3d& box) {
  const Vector3d size = box.isEmpty() ? Vector3d::Zero().eval() : box.sizes().eval();
  return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

bool rayMeets(const AlignedBox3d& box, const Vector3d& p, const Vector3d& inverse) {
  const Eigen::Array3d a = (box.min() - p).array() * inverse.array(), b = (box.max() - p).array() * inverse.array();
  const double enter = a.min(b).maxCoeff(), leave = a.max(b).minCoeff();
  const double slack = 1e-9 * (std::abs(enter) + std::abs(leave));
  return leave + slack >= 0 && enter <= leave + slack;
}

/// Returns 1 or -1 if the ray passes through a triangle that faces along or against it, 0 if it misses the triangle,
/// std::nullopt if that is uncertain.
std::optional<int> crossing(const Corners& corners, const Vector3d& p, const Vector3d& direction) {
  const Vector3d a = corners[0] - p, b = corners[1] - p, c = corners[2] - p;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double sides[3] = {direction.dot(a.cross(b)), direction.dot(b.cross(c)), direction.dot(c.cross(a))};
  const double floors[3] = {kTellable * la * lb, kTellable * lb * lc, kTellable * lc * la};
  int positive = 0, negative = 0;
  for (int k = 0; k < 3; ++k) {
    positive += sides[k] > floors[k];
    negative += sides[k] < -floors[k];
  }
  if (positive > 0 && negative > 0) return 0;
  // The sign of `height` gives the side of the face on which p lies, and therefore whether the triangle is ahead of p
  // or behind it.
  const double height = a.dot(b.cross(c)), floor = kTellable * la * lb * lc;
  const bool is_behind = positive > 0 ? height < -floor : negative > 0 && height > floor;
  if (is_behind) return 0;
  if (positive < 3 && negative < 3) return std::nullopt;
  if (std::abs(height) <= floor) return std::nullopt;
  return positive == 3 ? 1 : -1;
}

}  // namespace

struct TriangleTree::Item {
  AlignedBox3d box;
  Vector3d middle;
  Corners corners;
};

TriangleTree::TriangleTree(const TriangleMesh& mesh, const Eigen::Isometry3d& X_FM) {
  std::vector<Item> items(mesh.triangles.size());
  for (std::size_t k = 0; k < items.size(); ++k) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      items[k].corners[corner] = X_FM * mesh.vertices[static_cast<std::size_t>(mesh.triangles[k][corner])];
      items[k].box.extend(items[k].corners[corner]);
    }
    items[k].middle = items[k].box.center();
  }
  triangles_.reserve(items.size());
  build(items, 0);
}

/// Partitions the triangles in two so that the sum of box area times number of triangles is small (surface area
/// heuristic, Wald 2007, binned). Returns the number of triangles in the first part; 0 if they cannot be separated.
std::size_t TriangleTree::splitByArea(std::span<Item> items, const AlignedBox3d& middles, Eigen::Index axis) {
  const double low = middles.min()[axis], length = middles.sizes()[axis];
  if (!(length > 0)) return 0;
  const auto binOf = [&](const Item& item) {
    return std::min(kBins - 1, static_cast<std::size_t>(kBins * (item.middle[axis] - low) / length));
  };
  std::array<AlignedBox3d, kBins> boxes;
  std::array<std::size_t, kBins> counts{};
  for (const Item& item : items) boxes[binOf(item)].extend(item.box), ++counts[binOf(item)];
  std::array<double, kBins> right_cost{};
  AlignedBox3d sum;
  std::size_t count = 0, split = 0, first_count = 0;
  for (std::size_t bin = kBins - 1; bin > 0; --bin) {
    sum.extend(boxes[bin]), count += counts[bin];
    right_cost[bin] = halfArea(sum) * static_cast<double>(count);
  }
  double best = std::numeric_limits<double>::infinity();
  sum.setEmpty(), count = 0;
  for (std::size_t bin = 1; bin < kBins; ++bin) {
    sum.extend(boxes[bin - 1]), count += counts[bin - 1];
    const double cost = halfArea(sum) * static_cast<double>(count) + right_cost[bin];
    if (count > 0 && count < items.size() && cost < best) best = cost, split = bin, first_count = count;
  }
  std::partition(items.begin(), items.end(), [&](const Item& item) { return binOf(item) < split; });
  return first_count;
}

void TriangleTree::build(std::span<Item> items, int depth) {
  const std::size_t at = nodes_.size();
  nodes_.emplace_back();
  AlignedBox3d middles;
  for (const Item& item : items) nodes_[at].box.extend(item.box), middles.extend(item.middle);
  if (items.size() <= kLeafTriangles) {
    nodes_[at].first = static_cast<int>(triangles_.size());
    nodes_[at].count = static_cast<int>(items.size());
    for (const Item& item : items) triangles_.push_back(item.corners);
    return;
  }
  Eigen::Index axis = 0;
  middles.sizes().maxCoeff(&axis);
  std::size_t first_count = depth < kDeepestSearch ? splitByArea(items, middles, axis) : 0;
  if (first_count == 0) {
    first_count = items.size() / 2;
    std::ranges::nth_element(items, items.begin() + static_cast<std::ptrdiff_t>(first_count), {},
                             [axis](const Item& item) { return item.middle[axis]; });
  }
  build(items.first(first_count), depth + 1);
  nodes_[at].right = static_cast<int>(nodes_.size());
  build(items.subspan(first_count), depth + 1);
}

std::optional<int> TriangleTree::windingNumber(const Vector3d& p) const {
  if (!bounds().contains(p)) return 0;
  for (const Vector3d& direction : kRays) {
    const Vector3d inverse = direction.cwiseInverse();
    std::optional<int> winding = 0;
    const auto follow = [&](const auto& self, std::size_t at) -> void {
      const Node& node = nodes_[at];
      if (!winding || !rayMeets(node.box, p, inverse)) return;
      if (node.right != 0) {
        self(self, at + 1);
        self(self, static_cast<std::size_t>(node.right));
        return;
      }
      for (int k = node.first; k < node.first + node.count && winding; ++k) {
        const auto crossed = crossing(triangles_[static_cast<std::size_t>(k)], p, direction);
        winding = crossed ? std::optional(*winding + *crossed) : std::nullopt;
      }
    };
    follow(follow, 0);
    if (winding) return winding;
  }
  return std::nullopt;
}

}  // namespace tubeplan::planner
