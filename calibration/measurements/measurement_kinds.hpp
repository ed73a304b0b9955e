// Extensible table of the kinds of readings. A new kind is one header in this folder and one row of the table.
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
[[nodiscard]] inline const MeasurementKindRow& kindOf(const Measurement& reading) { return kindOf(reading.kind); }

/// Returns the row of the kind with this name; null if there is none.
[[nodiscard]] const MeasurementKindRow* findMeasurementKind(std::string_view name);

/// Returns the names of all kinds, for messages.
[[nodiscard]] std::vector<std::string> measurementKindNames();

/// Returns the names of the kinds whose instrument may be fixed to a row's frame.
[[nodiscard]] std::vector<std::string> kindNamesOfRows();

[[nodiscard]] inline int rowsOf(const Measurement& reading) {
  const MeasurementKindRow& kind = kindOf(reading);
  return kind.rows_of ? kind.rows_of(reading) : kind.rows;
}

/// Returns true if the reading depends on the rotation of the measured frame: because of its kind, or because it
/// measures a point other than the tip.
[[nodiscard]] inline bool seesTurn(const Measurement& reading) { return kindOf(reading).sees_turn || reading.p_TQ; }

/// Returns true if the reading depends on the rotation of the tool frame relative to the arm; readings of a row's frame
/// do not.
[[nodiscard]] inline bool seesToolTurn(const Measurement& reading) { return !reading.row && seesTurn(reading); }

/// Returns the tool's pose, with its position moved from the tip to the point that the reading measures.
[[nodiscard]] ToolPose atMeasuredPoint(const Measurement& reading, ToolPose tool);

/// Return the values that the reading would measure of a tool at this pose [m], and their derivatives with respect to
/// the pose. Both refer to the point of the tool that the reading measures.
[[nodiscard]] MeasuredValue predictedValue(const Measurement& reading, const ToolPose& tool);
[[nodiscard]] MeasuredSlope predictedSlope(const Measurement& reading, const ToolPose& tool);

/// Returns the reading's value in the kind's own column of that name; NaN if the kind has no such column.
[[nodiscard]] double ownNumber(const Measurement& reading, std::string_view name);

/// Returns true if the reading states the rotation of a frame by roll, pitch and yaw.
[[nodiscard]] inline bool statesFrame(const Measurement& reading) { return std::isfinite(ownNumber(reading, "roll")); }

/// Returns the columns that hold the measured values of a kind.
[[nodiscard]] inline ValueColumns valueColumnsOf(const MeasurementKindRow& kind) {
  return kind.value_columns(kind.columns);
}

/// Returns true if the kind measures x, y, z; otherwise x, y, z is the point from which the kind measures.
[[nodiscard]] inline bool measuresPlace(const MeasurementKindRow& kind) { return valueColumnsOf(kind).has_place; }

/// Returns true if the values of a reading are possible; an unsigned length, for example, must be above zero.
[[nodiscard]] inline bool isPossible(const Measurement& reading) {
  const auto is_possible = kindOf(reading).is_possible;
  return !is_possible || is_possible(reading);
}

/// Returns true if a reading states as many values as its kind requires, and the values are possible.
[[nodiscard]] bool statesEnough(const Measurement& reading);

/// Returns the reference of a displacement, which points into `reading`; empty for other readings.
[[nodiscard]] inline std::optional<Departure> departureOf(const Measurement& reading) {
  const auto departure = kindOf(reading).departure;
  return departure ? std::optional(departure(reading)) : std::nullopt;
}

/// Returns true for a displacement of the tip, which does not depend on the position of the base.
[[nodiscard]] inline bool isDisplacement(const Measurement& reading) { return kindOf(reading).departure != nullptr; }

/// Returns the reference reading of a displacement; null if the reading is not a displacement from another reading.
[[nodiscard]] inline const Measurement* referenceOf(const Measurement& reading) {
  const auto from = departureOf(reading);
  return from && !from->is_unloaded ? from->reading : nullptr;
}

/// Sets the reference of every reading to a copy of the referenced reading as it now is in `readings`. References to
/// readings that `readings` no longer contains stay unchanged.
void linkReferences(std::vector<Measurement>& readings);

/// Returns the length of the rotational part [rad] of a reading's error, whose rows are in m; NaN if the reading
/// measures no rotation.
[[nodiscard]] double turnError(const Measurement& reading, const Eigen::Ref<const Eigen::VectorXd>& error);

/// Returns the stated standard deviation of each row [m]; NaN where none is stated.
[[nodiscard]] MeasuredValue rowSigmas(const Measurement& reading);

/// Returns the root mean square of the standard deviations of x, y and z [m], for use where one value represents all
/// three.
[[nodiscard]] double meanSigma(const Eigen::Vector3d& sigma_W);

/// Convert the correlations of x with y, x with z and y with z to a correlation matrix, and back.
[[nodiscard]] Eigen::Matrix3d correlationMatrix(const Eigen::Vector3d& correlation);
[[nodiscard]] Eigen::Vector3d correlationNumbers(const Eigen::Matrix3d& matrix);

/// Returns true if the errors of three coordinates can have these correlations, i.e. if the correlation matrix is
/// positive definite beyond rounding.
[[nodiscard]] bool isPossibleCorrelation(const Eigen::Vector3d& correlation);

/// Returns the stated covariance of a reading's rows [m^2]; rows without a sigma count as exact to a micrometre. All
/// weights of readings derive from this covariance and the encoder noise that readingCovariance() adds.
[[nodiscard]] MeasuredCovariance statedCovariance(const Measurement& reading);

[[nodiscard]] inline bool isTouch(const Measurement& reading) { return kindOf(reading).is_touch; }

/// Returns true if the reading touches a point of unknown position.
[[nodiscard]] inline bool touchesUnknownPoint(const Measurement& reading) { return isTouch(reading) && !reading.p_W; }

/// Returns true if the reading touches a surface, whose position is always unknown.
[[nodiscard]] inline bool touchesSurface(const Measurement& reading) { return kindOf(reading).settle != nullptr; }

/// Return the number of parameters of the reading's unknown place, and the reading's derivatives with respect to these
/// parameters. All readings of the place share them. A touch of an unknown point has three such parameters, most
/// readings have none.
[[nodiscard]] int placeNumbers(const Measurement& reading);
[[nodiscard]] PlaceColumns byPlaceNumbers(const Measurement& reading, const ToolPose& tool);
[[nodiscard]] inline bool hasUnknownPlace(const Measurement& reading) { return placeNumbers(reading) > 0; }

/// Returns the name of the reading's unknown place, such as "touch P1" or "plane table".
[[nodiscard]] std::string placeOf(const Measurement& reading);

/// Returns groups of reading indices: one group per reading without an unknown place, then one per unknown place with
/// all its readings.
[[nodiscard]] std::vector<std::vector<int>> groupsByPlace(const std::vector<Measurement>& readings);

/// Returns the smallest number of readings of an unknown place that give information on the arm: one more than are
/// needed to determine the place.
[[nodiscard]] inline int leastOfPlace(const Measurement& reading) {
  return placeNumbers(reading) / rowsOf(reading) + 1;
}

/// Returns true if the reading touches a point of known position.
[[nodiscard]] inline bool touchesKnownPoint(const Measurement& reading) { return isTouch(reading) && reading.p_W; }

/// Returns true if the reading states the position of the tip in p_W.
[[nodiscard]] inline bool statesPlace(const Measurement& reading) { return kindOf(reading).is_place && reading.p_W; }

/// Returns the position of the tip [m] that the reading states in whatever form; empty if it states none.
[[nodiscard]] inline std::optional<Eigen::Vector3d> statedPlace(const Measurement& reading) {
  if (kindOf(reading).place) return kindOf(reading).place(reading);
  return statesPlace(reading) ? reading.p_W : std::nullopt;
}

}  // namespace tubeplan::calibration
