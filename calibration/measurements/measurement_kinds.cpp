#include "calibration/measurements/measurement_kinds.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "calibration/measurements/axis.hpp"
#include "calibration/measurements/deflection.hpp"
#include "calibration/measurements/direction.hpp"
#include "calibration/measurements/distance.hpp"
#include "calibration/measurements/offset.hpp"
#include "calibration/measurements/orientation.hpp"
#include "calibration/measurements/plane.hpp"
#include "calibration/measurements/polar.hpp"
#include "calibration/measurements/pose.hpp"
#include "calibration/measurements/position.hpp"
#include "calibration/measurements/relative.hpp"
#include "calibration/measurements/sphere.hpp"
#include "calibration/measurements/steps.hpp"
#include "calibration/measurements/tilt.hpp"
#include "calibration/measurements/touch.hpp"

namespace tubeplan::calibration {

std::span<const MeasurementKindRow> measurementKinds() {
  static const std::array kKinds{position::kind(), touch::kind(),    deflection_measurement::kind(),
                                 distance::kind(), axis::kind(),     orientation::kind(),
                                 pose::kind(),     offset::kind(),   tilt::kind(),
                                 steps::kind(),    relative::kind(), plane::kind(),
                                 sphere::kind(),   polar::kind(),    direction::kind()};
  return kKinds;
}

const MeasurementKindRow& kindOf(MeasurementKind kind) { return measurementKinds()[static_cast<std::size_t>(kind)]; }

const MeasurementKindRow* findMeasurementKind(std::string_view name) {
  const auto kinds = measurementKinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& row) { return row.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

ToolPose atMeasuredPoint(const Measurement& measurement, ToolPose tool) {
  if (const auto point = pointOf(measurement)) tool.p_W += tool.R_WT * *point;
  return tool;
}

MeasuredValue predictedValue(const Measurement& measurement, const ToolPose& tool) {
  return kindOf(measurement).value(measurement, atMeasuredPoint(measurement, tool));
}

MeasuredSlope predictedSlope(const Measurement& measurement, const ToolPose& tool) {
  MeasuredSlope slope = kindOf(measurement).slope(measurement, atMeasuredPoint(measurement, tool));
  const auto point = pointOf(measurement);
  if (!point) return slope;
  // A rotation w about the tip moves a point at r from the tip by w x r.
  const MeasuredRows by_lever = -slope.by_place * deflection::crossMatrix<double>(tool.R_WT * *point);
  slope.by_turn = slope.by_turn.size() ? MeasuredRows(slope.by_turn + by_lever) : by_lever;
  return slope;
}

PlaceColumns byPlaceNumbers(const Measurement& measurement, const ToolPose& tool) {
  if (touchesUnknownPoint(measurement)) return Eigen::Matrix3d::Identity();
  const MeasurementKindRow& kind = kindOf(measurement);
  return kind.by_place_numbers ? kind.by_place_numbers(measurement, atMeasuredPoint(measurement, tool))
                               : PlaceColumns();
}

int placeNumbers(const Measurement& measurement) {
  if (touchesUnknownPoint(measurement)) return 3;
  const MeasurementKindRow& kind = kindOf(measurement);
  return kind.place_numbers ? kind.place_numbers(measurement) : 0;
}

std::string placeOf(const Measurement& measurement) { return kindOf(measurement).name + (" " + measurement.point); }

std::vector<std::vector<int>> groupsByPlace(const std::vector<Measurement>& measurements) {
  std::map<std::string, std::vector<int>> places;
  std::vector<std::vector<int>> groups;
  for (int k = 0; k < static_cast<int>(measurements.size()); ++k) {
    const Measurement& measurement = measurements[static_cast<std::size_t>(k)];
    if (hasUnknownPlace(measurement))
      places[placeOf(measurement)].push_back(k);
    else
      groups.push_back({k});
  }
  for (auto& [place, members] : places) groups.push_back(std::move(members));
  return groups;
}

double ownNumber(const Measurement& measurement, std::string_view name) {
  const auto columns = kindOf(measurement).columns;
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].name == name) return measurement.kind_values[static_cast<Eigen::Index>(k)];
  return std::numeric_limits<double>::quiet_NaN();
}

bool statesEnough(const Measurement& measurement) {
  const ValueColumns values = valueColumnsOf(kindOf(measurement));
  const auto isStated = [&](const MeasuredColumn& column) {
    return std::isfinite(ownNumber(measurement, column.name));
  };
  auto stated = std::ranges::count_if(values.numbers, isStated);
  if (values.has_place && measurement.p_W) stated += static_cast<std::ptrdiff_t>(kPlaceColumns.size());
  return stated >= values.least && isPossible(measurement);
}

void linkReferences(std::vector<Measurement>& measurements) {
  const auto isLinked = [](const Measurement& measurement) { return measurement.reference != nullptr; };
  if (std::none_of(measurements.begin(), measurements.end(), isLinked)) return;
  std::map<std::string, std::shared_ptr<const Measurement>> by_id;
  for (const auto& measurement : measurements) {
    auto alone = std::make_shared<Measurement>(measurement);
    alone->reference = nullptr;
    by_id.emplace(measurement.id, std::move(alone));
  }
  for (auto& measurement : measurements)
    if (measurement.reference)
      if (const auto found = by_id.find(measurement.reference->id); found != by_id.end())
        measurement.reference = found->second;
}

double turnError(const Measurement& measurement, const Eigen::Ref<const Eigen::VectorXd>& error) {
  const int turns = std::min(rowsOf(measurement), kindOf(measurement).turn_rows);
  return turns ? error.tail(turns).norm() / kTurnLever : std::numeric_limits<double>::quiet_NaN();
}

MeasuredValue rowSigmas(const Measurement& measurement) {
  const int rows = rowsOf(measurement), turns = std::min(rows, kindOf(measurement).turn_rows);
  MeasuredValue sigmas = MeasuredValue::Constant(rows, measurement.sigma);
  if (measurement.sigma_W && kindOf(measurement).has_coordinates && rows >= 3) sigmas.head<3>() = *measurement.sigma_W;
  sigmas.tail(turns).setConstant(kTurnLever * measurement.turn_sigma);
  return sigmas;
}

double meanSigma(const Eigen::Vector3d& sigma_W) { return std::sqrt(sigma_W.squaredNorm() / 3); }

Eigen::Matrix3d correlationMatrix(const Eigen::Vector3d& correlation) {
  Eigen::Matrix3d matrix;
  matrix << 1, correlation[0], correlation[1], correlation[0], 1, correlation[2], correlation[1], correlation[2], 1;
  return matrix;
}

Eigen::Vector3d correlationNumbers(const Eigen::Matrix3d& matrix) { return {matrix(0, 1), matrix(0, 2), matrix(1, 2)}; }

bool isPossibleCorrelation(const Eigen::Vector3d& correlation) {
  constexpr double kLeastOwn = 1e-9;  // smallest accepted eigenvalue of a correlation matrix
  if (!correlation.allFinite()) return false;
  return correlationMatrix(correlation).selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() > kLeastOwn;
}

MeasuredCovariance statedCovariance(const Measurement& measurement) {
  constexpr double kNotStated = 1e-6, kLeast = 1e-8;  // [m]; kLeast is far below the noise of any instrument
  MeasuredValue sigmas = rowSigmas(measurement);
  for (double& sigma : sigmas) sigma = std::isfinite(sigma) ? std::max(sigma, kLeast) : kNotStated;
  MeasuredCovariance covariance = sigmas.array().square().matrix().asDiagonal();
  if (!measurement.correlation_W || !measurement.sigma_W || !kindOf(measurement).has_coordinates || sigmas.size() < 3)
    return covariance;
  covariance.topLeftCorner<3, 3>() =
      sigmas.head<3>().asDiagonal() * correlationMatrix(*measurement.correlation_W) * sigmas.head<3>().asDiagonal();
  return covariance;
}

std::vector<std::string> measurementKindNames() {
  std::vector<std::string> names;
  for (const MeasurementKindRow& row : measurementKinds()) names.emplace_back(row.name);
  return names;
}

std::vector<std::string> kindNamesOfRows() {
  std::vector<std::string> names;
  for (const MeasurementKindRow& row : measurementKinds())
    if (row.may_be_of_row) names.emplace_back(row.name);
  return names;
}

}  // namespace tubeplan::calibration
