// Kind `sphere`: the tip touches a sphere of unknown centre, such as a tooling ball. The joints are read. The error is
// the tip's distance from the best-fit sphere of all measurements of the same sphere. The radius of the sphere
// (including that of a ball at the tip) is either known, so that the measurements contain a known length, or fitted
// with the centre.
#pragma once

#include <array>
#include <cmath>

#include "calibration/measurements/plane.hpp"

namespace tubeplan::calibration::sphere {

inline constexpr std::array<MeasuredColumn, 1> kColumns{{{"radius", deflection::Quantity::kLength}}};

/// Returns true if the radius is not stated or is above zero.
inline bool isPossible(const Measurement& measurement) { return !(measurement.kind_values[0] <= 0); }

inline bool isRadiusKnown(const Measurement& measurement) { return !std::isnan(measurement.kind_values[0]); }
inline int numbersOf(const Measurement& measurement) { return isRadiusKnown(measurement) ? 3 : 4; }

/// Returns the unit vector from the sphere's centre to the tip; z if the tip is at the centre.
inline Eigen::Vector3d outwards(const Surface& surface, const Eigen::Vector3d& p_W) {
  const Eigen::Vector3d from = p_W - surface.p_W;
  return from.norm() > 0 ? Eigen::Vector3d(from.normalized()) : Eigen::Vector3d::UnitZ();
}

inline MeasuredValue value(const Measurement& measurement, const ToolPose& tool) {
  if (!measurement.surface) return MeasuredValue::Zero(1);
  return MeasuredValue::Constant(1, (tool.p_W - measurement.surface->p_W).norm() - measurement.surface->radius);
}
inline MeasuredSlope slope(const Measurement& measurement, const ToolPose& tool) {
  if (!measurement.surface) return {MeasuredRows::Zero(1, 3), {}};
  return {outwards(*measurement.surface, tool.p_W).transpose(), {}};
}

inline PlaceColumns byPlaceNumbers(const Measurement& measurement, const ToolPose& tool) {
  PlaceColumns columns = PlaceColumns::Zero(1, numbersOf(measurement));
  if (!measurement.surface) return columns;
  columns.leftCols<3>() = -outwards(*measurement.surface, tool.p_W).transpose();
  if (!isRadiusKnown(measurement)) columns(0, 3) = -1;
  return columns;
}

/// Signed distances of points from a sphere [m], and their derivatives with respect to the sphere's centre and, if
/// unknown, its radius.
struct Distances {
  Eigen::VectorXd error;
  Eigen::MatrixXd columns;
};
inline Distances distancesFrom(const Surface& surface, const Eigen::Matrix3Xd& points_W, int numbers) {
  Distances distances{Eigen::VectorXd(points_W.cols()), Eigen::MatrixXd::Constant(points_W.cols(), numbers, -1)};
  for (Eigen::Index k = 0; k < points_W.cols(); ++k) {
    distances.error[k] = (points_W.col(k) - surface.p_W).norm() - surface.radius;
    distances.columns.row(k).head<3>() = -outwards(surface, points_W.col(k)).transpose();
  }
  return distances;
}

/// Fits the sphere |p|^2 = 2 c p + (r^2 - |c|^2), which is linear in c and in the term in parentheses.
inline Surface algebraic(const Eigen::Matrix3Xd& points_W) {
  const Eigen::Vector3d mean = points_W.rowwise().mean();
  const Eigen::Matrix3Xd from = points_W.colwise() - mean;
  Eigen::MatrixXd columns(points_W.cols(), 4);
  columns << 2 * from.transpose(), Eigen::VectorXd::Ones(points_W.cols());
  const Eigen::Vector4d found =
      columns.completeOrthogonalDecomposition().solve(from.colwise().squaredNorm().transpose().eval());
  Surface surface;
  surface.p_W = mean + found.head<3>();
  surface.radius = std::sqrt(std::max(0., found[3] + found.head<3>().squaredNorm()));
  return surface;
}

/// Fits the sphere with Gauss-Newton steps, each halved until the sum of squares decreases.
inline Surface nearestSphere(Surface surface, const Eigen::Matrix3Xd& points_W, int numbers) {
  constexpr int kMostSteps = 50, kMostHalvings = 12;
  constexpr double kStill = 1e-14;  // step length below which the fit has converged [m]
  Distances at = distancesFrom(surface, points_W, numbers);
  for (int steps = 0; steps < kMostSteps; ++steps) {
    Eigen::VectorXd step = -at.columns.completeOrthogonalDecomposition().solve(at.error);
    bool is_nearer = false;
    for (int halvings = 0; halvings < kMostHalvings && !is_nearer; ++halvings, step /= 2) {
      Surface next = surface;
      next.p_W += step.head<3>();
      if (numbers > 3) next.radius += step[3];
      Distances candidate = distancesFrom(next, points_W, numbers);
      if (!(candidate.error.squaredNorm() < at.error.squaredNorm())) continue;
      is_nearer = true;
      surface = next;
      at = std::move(candidate);
    }
    if (!is_nearer || step.norm() < kStill) break;
  }
  return surface;
}

inline bool settle(const Eigen::Matrix3Xd& points_W, const Measurement& measurement, Surface& surface) {
  const int numbers = numbersOf(measurement);
  if (points_W.cols() < numbers + 1) return false;
  Surface start = algebraic(points_W);
  if (isRadiusKnown(measurement)) start.radius = measurement.kind_values[0];
  const Surface found = nearestSphere(start, points_W, numbers);
  if (!found.p_W.allFinite() || !(found.radius > 0)) return false;
  surface.p_W = found.p_W;
  surface.radius = found.radius;
  return true;
}

inline constexpr double kUsualRadius = 0.0125;  // radius [m] of a tooling ball of one inch diameter

inline Surface through(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W) {
  return {p_W - kUsualRadius * direction_W, direction_W, kUsualRadius};
}
inline Eigen::Vector3d nearest(const Surface& surface, const Eigen::Vector3d& p_W) {
  return surface.p_W + surface.radius * outwards(surface, p_W);
}

/// Writes the radius; the touched point follows from the sphere's centre.
inline void record(const ToolPose&, double, const MeasuredValue&, Measurement& measurement) {
  if (measurement.surface) measurement.kind_values[0] = measurement.surface->radius;
}

inline MeasurementKindRow kind() {
  MeasurementKindRow row = plane::kind();
  row.kind = MeasurementKind::kSphere;
  row.name = "sphere";
  row.columns = kColumns;
  row.is_possible = isPossible;
  row.value = value;
  row.slope = slope;
  row.place_numbers = numbersOf;
  row.by_place_numbers = byPlaceNumbers;
  row.record = record;
  row.settle = settle;
  row.through = through;
  row.nearest = nearest;
  return row;
}

}  // namespace tubeplan::calibration::sphere
