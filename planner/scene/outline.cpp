#include "planner/scene/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tubeplan::planner {
namespace {

/// The hull of the net recedes from a sphere by less than 2 % of the radius.
constexpr int kDirections = 300;

/// Returns direction k of the Fibonacci lattice, whose points are spread evenly over the unit sphere.
Eigen::Vector3d latticeDirection(int k) {
  const double z = 1 - (2 * k + 1.0) / kDirections, across = std::sqrt(1 - z * z);
  const double angle = 2 * std::numbers::pi * k * (std::numbers::phi - 1);
  return {across * std::cos(angle), across * std::sin(angle), z};
}

}  // namespace

std::vector<Eigen::Vector3d> outlineOf(const Solid& solid) {
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k < kDirections; ++k) {
    const Eigen::Vector3d point = solid.support(latticeDirection(k));
    const auto isSame = [&](const Eigen::Vector3d& other) { return (other - point).norm() < 1e-9; };
    if (std::ranges::none_of(points, isSame)) points.push_back(point);
  }
  return points;
}

}  // namespace tubeplan::planner
