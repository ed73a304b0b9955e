// Extensible table of the kinds of measurements. A new kind is one header in this folder and one row of the table.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibration/measurements/measurement_kind.hpp"

namespace tubeplan::calibration {

/// Returns the rows of all kinds, in the order of MeasurementKind.
[[nodiscard]] std::span<const MeasurementKindRow> measurementKinds();

[[nodiscard]] const MeasurementKindRow& kindOf(MeasurementKind kind);
[[nodiscard]] inline const MeasurementKindRow& kindOf(const Measurement& measurement) {
  return kindOf(measurement.kind);
}

/// Returns the row of the kind with this name; null if there is none.
[[nodiscard]] const MeasurementKindRow* findMeasurementKind(std::string_view name);

/// Returns the names of all kinds, for messages.
[[nodiscard]] std::vector<std::string> measurementKindNames();

/// Returns the names of the kinds whose instrument may be fixed to a row's frame.
[[nodiscard]] std::vector<std::string> kindNamesOfRows();

[[nodiscard]] inline int rowsOf(const Measurement& measurement) {
  const MeasurementKindRow& kind = kindOf(measurement);
  return kind.rows_of ? kind.rows_of(measurement) : kind.rows;
}

/// Returns the position of the point whose place counts, in the tool frame [m]; empty for the tip itself.
[[nodiscard]] inline std::optional<Eigen::Vector3d> pointOf(const Measurement& measurement) {
  if (!measurement.p_QS) return measurement.p_TQ;
  return *measurement.p_QS + measurement.p_TQ.value_or(Eigen::Vector3d::Zero());
}

/// Returns true if the measurement depends on the rotation of the measured frame: because of its kind, or because it
/// measures a point other than the tip.
[[nodiscard]] inline bool seesTurn(const Measurement& measurement) {
  return kindOf(measurement).sees_turn || pointOf(measurement);
}

/// Returns true if the measurement depends on the rotation of the tool frame relative to the arm; measurements of a
/// row's frame do not.
[[nodiscard]] inline bool seesToolTurn(const Measurement& measurement) {
  return !measurement.row && seesTurn(measurement);
}

/// Returns the tool's pose, with its position moved from the tip to the point that the measurement measures.
[[nodiscard]] ToolPose atMeasuredPoint(const Measurement& measurement, ToolPose tool);

/// Return the values that the measurement would measure of a tool at this pose [m], and their derivatives with respect
/// to the pose. Both refer to the point of the tool that the measurement measures.
[[nodiscard]] MeasuredValue predictedValue(const Measurement& measurement, const ToolPose& tool);
[[nodiscard]] MeasuredSlope predictedSlope(const Measurement& measurement, const ToolPose& tool);

/// Returns the measurement's value in the kind's own column of that name; NaN if the kind has no such column.
[[nodiscard]] double ownNumber(const Measurement& measurement, std::string_view name);

/// Returns true if the measurement states the rotation of a frame by roll, pitch and yaw.
[[nodiscard]] inline bool statesFrame(const Measurement& measurement) {
  return std::isfinite(ownNumber(measurement, "roll"));
}

/// Returns the columns that hold the measured values of a kind.
[[nodiscard]] inline ValueColumns valueColumnsOf(const MeasurementKindRow& kind) {
  return kind.value_columns(kind.columns);
}

/// Returns true if the kind measures x, y, z; otherwise x, y, z is the point from which the kind measures.
[[nodiscard]] inline bool measuresPlace(const MeasurementKindRow& kind) { return valueColumnsOf(kind).has_place; }

/// Returns true if the values of a measurement are possible; an unsigned length, for example, must be above zero.
[[nodiscard]] inline bool isPossible(const Measurement& measurement) {
  const auto is_possible = kindOf(measurement).is_possible;
  return !is_possible || is_possible(measurement);
}

/// Returns true if a measurement states as many values as its kind requires, and the values are possible.
[[nodiscard]] bool statesEnough(const Measurement& measurement);

/// Returns the reference of a displacement, which points into `measurement`; empty for other measurements.
[[nodiscard]] inline std::optional<Departure> departureOf(const Measurement& measurement) {
  const auto departure = kindOf(measurement).departure;
  return departure ? std::optional(departure(measurement)) : std::nullopt;
}

/// Returns true for a displacement of the tip, which does not depend on the position of the base.
[[nodiscard]] inline bool isDisplacement(const Measurement& measurement) {
  return kindOf(measurement).departure != nullptr;
}

/// Returns the reference measurement of a displacement; null if the measurement is not a displacement from another
/// measurement.
[[nodiscard]] inline const Measurement* referenceOf(const Measurement& measurement) {
  const auto from = departureOf(measurement);
  return from && !from->is_unloaded ? from->measurement : nullptr;
}

/// Sets the reference of every measurement to a copy of the referenced measurement as it now is in `measurements`.
/// References to measurements that are no longer in `measurements` stay unchanged.
void linkReferences(std::vector<Measurement>& measurements);

/// Returns the length of the rotational part [rad] of a measurement's error, whose rows are in m; NaN if the
/// measurement measures no rotation.
[[nodiscard]] double turnError(const Measurement& measurement, const Eigen::Ref<const Eigen::VectorXd>& error);

/// Returns the stated standard deviation of each row [m]; NaN where none is stated.
[[nodiscard]] MeasuredValue rowSigmas(const Measurement& measurement);

/// Returns the root mean square of the standard deviations of x, y and z [m], for use where one value represents all
/// three.
[[nodiscard]] double meanSigma(const Eigen::Vector3d& sigma_W);

/// Convert the correlations of x with y, x with z and y with z to a correlation matrix, and back.
[[nodiscard]] Eigen::Matrix3d correlationMatrix(const Eigen::Vector3d& correlation);
[[nodiscard]] Eigen::Vector3d correlationNumbers(const Eigen::Matrix3d& matrix);

/// Returns true if the errors of three coordinates can have these correlations, i.e. if the correlation matrix is
/// positive definite beyond rounding.
[[nodiscard]] bool isPossibleCorrelation(const Eigen::Vector3d& correlation);

/// Returns the stated covariance of a measurement's rows [m^2]; rows without a sigma get a sigma of one micrometre. All
/// weights of measurements derive from this covariance and the encoder noise that measurementCovariance() adds.
[[nodiscard]] MeasuredCovariance statedCovariance(const Measurement& measurement);

[[nodiscard]] inline bool isTouch(const Measurement& measurement) { return kindOf(measurement).is_touch; }

/// Returns true if the measurement touches a point of unknown position.
[[nodiscard]] inline bool touchesUnknownPoint(const Measurement& measurement) {
  return isTouch(measurement) && !measurement.p_W;
}

/// Returns true if the measurement touches a surface, whose position is always unknown.
[[nodiscard]] inline bool touchesSurface(const Measurement& measurement) {
  return kindOf(measurement).settle != nullptr;
}

/// Return the number of parameters of the measurement's unknown place, and the measurement's derivatives with respect
/// to these parameters. All measurements of the place share them. A touch of an unknown point has three such
/// parameters, most measurements have none.
[[nodiscard]] int placeNumbers(const Measurement& measurement);
[[nodiscard]] PlaceColumns byPlaceNumbers(const Measurement& measurement, const ToolPose& tool);
[[nodiscard]] inline bool hasUnknownPlace(const Measurement& measurement) { return placeNumbers(measurement) > 0; }

/// Returns the name of the measurement's unknown place, such as "touch P1" or "plane table".
[[nodiscard]] std::string placeOf(const Measurement& measurement);

/// Returns groups of measurement indices: one group per measurement without an unknown place, then one per unknown
/// place with all its measurements.
[[nodiscard]] std::vector<std::vector<int>> groupsByPlace(const std::vector<Measurement>& measurements);

/// Returns the smallest number of measurements of an unknown place that gives information on the arm: one more than the
/// number needed to determine the place.
[[nodiscard]] inline int leastOfPlace(const Measurement& measurement) {
  return placeNumbers(measurement) / rowsOf(measurement) + 1;
}

/// Returns true if the measurement touches a point of known position.
[[nodiscard]] inline bool touchesKnownPoint(const Measurement& measurement) {
  return isTouch(measurement) && measurement.p_W;
}

/// Returns true if the measurement states the position of the tip in p_W.
[[nodiscard]] inline bool statesPlace(const Measurement& measurement) {
  return kindOf(measurement).is_place && measurement.p_W;
}

/// Returns the position of the tip [m] that the measurement states, in any form; empty if it states none.
[[nodiscard]] inline std::optional<Eigen::Vector3d> statedPlace(const Measurement& measurement) {
  if (kindOf(measurement).place) return kindOf(measurement).place(measurement);
  return statesPlace(measurement) ? measurement.p_W : std::nullopt;
}

}  // namespace tubeplan::calibration
