// The open table of kinds of readings. A new kind is a header in this folder and its row in the table.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibration/measurements/measurement_kind.hpp"

namespace tubeplan::calibration {

/// Returns the kinds in the order of MeasurementKind.
[[nodiscard]] std::span<const MeasurementKindRow> measurementKinds();

[[nodiscard]] const MeasurementKindRow& kindOf(MeasurementKind kind);
[[nodiscard]] inline const MeasurementKindRow& kindOf(const Measurement& reading) { return kindOf(reading.kind); }

/// Returns the kind of that name, or null if there is none.
[[nodiscard]] const MeasurementKindRow* findMeasurementKind(std::string_view name);

/// Returns the names of all kinds, for messages.
[[nodiscard]] std::vector<std::string> measurementKindNames();

/// Returns the names of the kinds that may be fixed to a row's frame.
[[nodiscard]] std::vector<std::string> kindNamesOfRows();

[[nodiscard]] inline int rowsOf(const Measurement& reading) {
  const MeasurementKindRow& kind = kindOf(reading);
  return kind.rows_of ? kind.rows_of(reading) : kind.rows;
}

/// Returns true if the reading depends on the tool's rotation: by its kind, or because it measures another point than
/// the tip.
[[nodiscard]] inline bool seesTurn(const Measurement& reading) { return kindOf(reading).sees_turn || reading.p_TQ; }

/// Returns true if the reading depends on the rotation of the tool frame on the arm, which readings of a row's frame do
/// not.
[[nodiscard]] inline bool seesToolTurn(const Measurement& reading) { return !reading.row && seesTurn(reading); }

/// Returns the tool's pose with the measured point in place of its tip.
[[nodiscard]] ToolPose atMeasuredPoint(const Measurement& reading, ToolPose tool);

/// Return the values that would be measured of a tool at that pose [m] and their slopes by that pose, at the point of
/// the tool that the reading measures.
[[nodiscard]] MeasuredValue predictedValue(const Measurement& reading, const ToolPose& tool);
[[nodiscard]] MeasuredSlope predictedSlope(const Measurement& reading, const ToolPose& tool);

/// Returns the number of that name among the kind's own numbers; NaN if the kind has none.
[[nodiscard]] double ownNumber(const Measurement& reading, std::string_view name);

/// Returns true if the reading states the rotation of a frame by roll, pitch and yaw.
[[nodiscard]] inline bool statesFrame(const Measurement& reading) { return std::isfinite(ownNumber(reading, "roll")); }

/// Returns the columns that hold what a kind measures.
[[nodiscard]] inline ValueColumns valueColumnsOf(const MeasurementKindRow& kind) {
  return kind.value_columns(kind.columns);
}

/// Returns true if the kind measures x, y, z; else these are the place from which it is measured.
[[nodiscard]] inline bool measuresPlace(const MeasurementKindRow& kind) { return valueColumnsOf(kind).has_place; }

/// Returns true if the numbers of a reading are possible: a length without a sign must be above zero.
[[nodiscard]] inline bool isPossible(const Measurement& reading) {
  const auto is_possible = kindOf(reading).is_possible;
  return !is_possible || is_possible(reading);
}

/// Returns true if a reading states as many numbers as its kind asks for, and they are possible.
[[nodiscard]] bool statesEnough(const Measurement& reading);

/// Returns the reference of a displacement, or nothing for other readings. It points into the reading.
[[nodiscard]] inline std::optional<Departure> departureOf(const Measurement& reading) {
  const auto departure = kindOf(reading).departure;
  return departure ? std::optional(departure(reading)) : std::nullopt;
}

/// Returns true for a displacement of the tip, which does not depend on the position of the base.
[[nodiscard]] inline bool isDisplacement(const Measurement& reading) { return kindOf(reading).departure != nullptr; }

/// Returns the reading from which a displacement is taken, or null if the reading is no such displacement.
[[nodiscard]] inline const Measurement* referenceOf(const Measurement& reading) {
  const auto from = departureOf(reading);
  return from && !from->is_unloaded ? from->reading : nullptr;
}

/// Sets every reading's reference to its present copy among these readings. A reference that is no longer among them
/// stays as it is.
void linkReferences(std::vector<Measurement>& readings);

/// Returns the length of the rotational part [rad] of a reading's error, whose rows are in m; NaN if it measures no
/// rotation.
[[nodiscard]] double turnError(const Measurement& reading, const Eigen::Ref<const Eigen::VectorXd>& error);

/// Returns the stated standard deviation of each row [m]; NaN where none is stated.
[[nodiscard]] MeasuredValue rowSigmas(const Measurement& reading);

/// Returns the root mean square [m] of the standard deviations of x, y and z, as the one that stands for all.
[[nodiscard]] double meanSigma(const Eigen::Vector3d& sigma_W);

/// Convert between a correlation matrix and its numbers for x with y, x with z, y with z.
[[nodiscard]] Eigen::Matrix3d correlationMatrix(const Eigen::Vector3d& correlation);
[[nodiscard]] Eigen::Vector3d correlationNumbers(const Eigen::Matrix3d& matrix);

/// Returns true if errors of three coordinates can have these correlations: the matrix is positive definite beyond
/// rounding.
[[nodiscard]] bool isPossibleCorrelation(const Eigen::Vector3d& correlation);

/// Returns the covariance of a reading's rows [m^2] as it states it; rows without a sigma count as exact to a
/// micrometre. Stated noise becomes a weight here and nowhere else; readingCovariance() adds the noise of the encoders.
[[nodiscard]] MeasuredCovariance statedCovariance(const Measurement& reading);

[[nodiscard]] inline bool isTouch(const Measurement& reading) { return kindOf(reading).is_touch; }

/// Returns true if the reading touches a point of unknown place.
[[nodiscard]] inline bool touchesUnknownPoint(const Measurement& reading) { return isTouch(reading) && !reading.p_W; }

/// Returns true if the reading touches a surface, whose place is unknown.
[[nodiscard]] inline bool touchesSurface(const Measurement& reading) { return kindOf(reading).settle != nullptr; }

/// Return how many numbers of an unknown place the reading shares with all readings of that place, and its slopes by
/// these. A touch of an unknown point has three, most readings none.
[[nodiscard]] int placeNumbers(const Measurement& reading);
[[nodiscard]] PlaceColumns byPlaceNumbers(const Measurement& reading, const ToolPose& tool);
[[nodiscard]] inline bool hasUnknownPlace(const Measurement& reading) { return placeNumbers(reading) > 0; }

/// Returns the name of the unknown place: "touch P1", "plane table".
[[nodiscard]] std::string placeOf(const Measurement& reading);

/// Returns the places among these readings of each alone and then of those that share one unknown place, together.
[[nodiscard]] std::vector<std::vector<int>> groupsByPlace(const std::vector<Measurement>& readings);

/// Returns the least number of readings of an unknown place that contain information: one more than determine it.
[[nodiscard]] inline int leastOfPlace(const Measurement& reading) {
  return placeNumbers(reading) / rowsOf(reading) + 1;
}

/// Returns true if the reading touches a point of known place.
[[nodiscard]] inline bool touchesKnownPoint(const Measurement& reading) { return isTouch(reading) && reading.p_W; }

/// Returns true if the reading states the place of the tip.
[[nodiscard]] inline bool statesPlace(const Measurement& reading) { return kindOf(reading).is_place && reading.p_W; }

/// Returns the place of the tip [m] that the reading states, by whatever numbers; nothing if it states none.
[[nodiscard]] inline std::optional<Eigen::Vector3d> statedPlace(const Measurement& reading) {
  if (kindOf(reading).place) return kindOf(reading).place(reading);
  return statesPlace(reading) ? reading.p_W : std::nullopt;
}

}  // namespace tubeplan::calibration
