// Kind `plane`: the tip touches a plane of unknown position, such as a face of a datum block or a granite table. The
// joints are read. The error is the tip's distance from the best-fit plane of all measurements of the same plane. The
// radius of a ball at the tip only shifts the plane, if all touches are on the same side.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "calibration/measurements/measurement_kind.hpp"

namespace tubeplan::calibration::plane {

inline constexpr int kNumbers = 3;  // number of parameters of a plane: two angles of the normal and the distance

inline int numbersOf(const Measurement&) { return kNumbers; }

inline MeasuredValue value(const Measurement& measurement, const ToolPose& tool) {
  if (!measurement.surface) return MeasuredValue::Zero(1);
  return MeasuredValue::Constant(1, measurement.surface->direction_W.dot(tool.p_W - measurement.surface->p_W));
}
inline MeasuredSlope slope(const Measurement& measurement, const ToolPose&) {
  if (!measurement.surface) return {MeasuredRows::Zero(1, 3), {}};
  return {measurement.surface->direction_W.transpose(), {}};
}
inline MeasuredValue measured(const Measurement&) { return MeasuredValue::Zero(1); }

/// Returns the derivatives with respect to the plane's two angles and its distance. Tilting the normal moves a point
/// off the plane in proportion to the point's distance along the plane.
inline PlaceColumns byPlaceNumbers(const Measurement& measurement, const ToolPose& tool) {
  PlaceColumns columns = PlaceColumns::Zero(1, kNumbers);
  if (!measurement.surface) return columns;
  const Eigen::Vector3d across = measurement.surface->direction_W.unitOrthogonal();
  const Eigen::Vector3d from = tool.p_W - measurement.surface->p_W;
  columns << across.dot(from), measurement.surface->direction_W.cross(across).dot(from), -1;
  return columns;
}

/// Fits the plane. The normal is the direction in which the points are spread least, oriented like the previous normal.
inline bool settle(const Eigen::Matrix3Xd& points_W, const Measurement&, Surface& surface) {
  // Points form a line if their second-largest spread, relative to the largest, is below this value.
  constexpr double kLine = 1e-6;
  if (points_W.cols() < kNumbers) return false;
  const Eigen::Vector3d mean = points_W.rowwise().mean();
  const Eigen::Matrix3Xd from = points_W.colwise() - mean;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(from * from.transpose());
  if (!(spread.eigenvalues()[1] > kLine * kLine * spread.eigenvalues()[2])) return false;
  const Eigen::Vector3d normal = spread.eigenvectors().col(0);
  surface.p_W = mean;
  surface.direction_W = normal.dot(surface.direction_W) < 0 ? Eigen::Vector3d(-normal) : normal;
  return true;
}

inline Surface through(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W) { return {p_W, direction_W, 0}; }
inline Eigen::Vector3d nearest(const Surface& surface, const Eigen::Vector3d& p_W) {
  return p_W - surface.direction_W * surface.direction_W.dot(p_W - surface.p_W);
}

/// Writes nothing: the touched point follows from the plane.
inline void recordNothing(const ToolPose&, double, const MeasuredValue&, Measurement&) {}

inline std::optional<MeasurementLack> lack(const Measurement& measurement, const std::string& kind) {
  if (measurement.point.empty())
    return MeasurementLack{
        "the reading does not name the " + kind + " that it touched",
        "write the " + kind + "'s name in the column 'point', the same in all readings that touched it"};
  if (!measurement.p_W && !measurement.direction_W) return std::nullopt;
  return MeasurementLack{
      "the reading of kind " + kind + " states its place (x, y, z, dx, dy, dz), which follows from the readings",
      "leave these columns empty; of a plane of known place make readings of kind axis, of a ball of known centre of "
      "kind "
      "distance"};
}

inline MeasurementKindRow kind() {
  return {.kind = MeasurementKind::kPlane,
          .name = "plane",
          .rows = 1,
          .is_by_scale = false,
          .value = value,
          .slope = slope,
          .measured = measured,
          .record = recordNothing,
          .lack = lack,
          .usual_sigma = kTouchSigma,
          .value_columns = jointsOnly,
          .place_numbers = numbersOf,
          .by_place_numbers = byPlaceNumbers,
          .settle = settle,
          .through = through,
          .nearest = nearest};
}

}  // namespace tubeplan::calibration::plane
