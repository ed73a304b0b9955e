#include "planner/padding.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "deflection/chain.hpp"
#include "planner/clearance.hpp"

namespace tubeplan::planner {

namespace {

using Matrix36 = Eigen::Matrix<double, 3, 6>;

/// Displacement of a point at `r` from the base by a shift and a small turn of the base.
Matrix36 displacementAt(const Eigen::Vector3d& r) {
  Matrix36 J;
  J << Eigen::Matrix3d::Identity(),
      (Eigen::Matrix3d() << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0).finished();
  return J;
}

double reachOfBodies(const Workcell& cell) {
  const CollisionWorld world(cell.scene);
  const std::vector<double>& reach = world.bodyReach();
  return deflection::reachOf(cell.arm) + (reach.empty() ? 0 : std::ranges::max(reach));
}

}  // namespace

double paddingOf(const Workcell& cell, double sigmas) {
  const double reach = reachOfBodies(cell);
  double variance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d r(corner & 1 ? reach : -reach, corner & 2 ? reach : -reach, corner & 4 ? reach : -reach);
    const Matrix36 J = displacementAt(r);
    const Eigen::Matrix3d covariance = J * cell.base_covariance * J.transpose();
    variance = std::max(variance, covariance.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff());
  }
  return sigmas * std::sqrt(variance);
}

}  // namespace tubeplan::planner
