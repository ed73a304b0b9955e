// The kinds of reading that there are: an open table. A new one is a header beside this and its row in the table.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibration/measurements/measurement_kind.hpp"

namespace tubeplan::calibration {

/// In the order of MeasurementKind.
[[nodiscard]] std::span<const MeasurementKindRow> measurementKinds();

[[nodiscard]] const MeasurementKindRow& kindOf(MeasurementKind kind);
[[nodiscard]] inline const MeasurementKindRow& kindOf(const Measurement& reading) { return kindOf(reading.kind); }

/// Null where there is none of that name.
[[nodiscard]] const MeasurementKindRow* findMeasurementKind(std::string_view name);

/// For messages: what would have been understood.
[[nodiscard]] std::vector<std::string> measurementKindNames();

/// Of the kinds that may be of a row's frame.
[[nodiscard]] std::vector<std::string> kindNamesOfRows();

[[nodiscard]] inline int rowsOf(const Measurement& reading) {
  const MeasurementKindRow& kind = kindOf(reading);
  return kind.rows_of ? kind.rows_of(reading) : kind.rows;
}

/// Whether the tool's turn reaches the reading: by its kind, or because another point of the tool than the tip is seen.
[[nodiscard]] inline bool seesTurn(const Measurement& reading) { return kindOf(reading).sees_turn || reading.p_TQ; }

/// Returns whether the turn of the tool frame on the arm reaches the reading: not where a row's frame is read.
[[nodiscard]] inline bool seesToolTurn(const Measurement& reading) { return !reading.row && seesTurn(reading); }

/// The tool, named by the measured point in place of its tip.
[[nodiscard]] ToolPose atMeasuredPoint(const Measurement& reading, ToolPose tool);

/// What would be measured of a tool that stands there [m], and how it changes with the tool's pose: at the point of the
/// tool that the reading is of.
[[nodiscard]] MeasuredValue predictedValue(const Measurement& reading, const ToolPose& tool);
[[nodiscard]] MeasuredSlope predictedSlope(const Measurement& reading, const ToolPose& tool);

/// The number of that name among its kind's own; not a number where the kind has none.
[[nodiscard]] double ownNumber(const Measurement& reading, std::string_view name);

/// Whether it states how a frame is turned, by roll, pitch and yaw.
[[nodiscard]] inline bool statesFrame(const Measurement& reading) { return std::isfinite(ownNumber(reading, "roll")); }

/// The columns that hold what a kind measures.
[[nodiscard]] inline ValueColumns valueColumnsOf(const MeasurementKindRow& kind) {
  return kind.value_columns(kind.columns);
}

/// Returns whether a kind measures x, y, z, which else are the place of what it is measured from.
[[nodiscard]] inline bool measuresPlace(const MeasurementKindRow& kind) { return valueColumnsOf(kind).has_place; }

/// Whether the numbers that a reading states may be right: a length without a sign is above zero.
[[nodiscard]] inline bool isPossible(const Measurement& reading) {
  const auto is_possible = kindOf(reading).is_possible;
  return !is_possible || is_possible(reading);
}

/// Whether a reading states as many numbers as its kind asks for, such as may be right.
[[nodiscard]] bool statesEnough(const Measurement& reading);

/// What a displacement is taken from; nothing of what is none. It points into the reading.
[[nodiscard]] inline std::optional<Departure> departureOf(const Measurement& reading) {
  const auto departure = kindOf(reading).departure;
  return departure ? std::optional(departure(reading)) : std::nullopt;
}

/// Whether it is how far the tip moved, which no base's place changes.
[[nodiscard]] inline bool isDisplacement(const Measurement& reading) { return kindOf(reading).departure != nullptr; }

/// The reading that a way is taken from; null of readings that are no such way, whatever they were made from.
[[nodiscard]] inline const Measurement* referenceOf(const Measurement& reading) {
  const auto from = departureOf(reading);
  return from && !from->is_unloaded ? from->reading : nullptr;
}

/// Takes every reading's reference as it stands among these readings now; one that is not there any more stays as it
/// is.
void linkReferences(std::vector<Measurement>& readings);

/// Length of what of its rows' error [m] is turns [rad]; not a number where it measures none.
[[nodiscard]] double turnError(const Measurement& reading, const Eigen::Ref<const Eigen::VectorXd>& error);

/// Of each row [m]: what the reading states; not numbers where it states nothing.
[[nodiscard]] MeasuredValue rowSigmas(const Measurement& reading);

/// The one standard deviation [m] that stands for those of x, y and z: their root mean square.
[[nodiscard]] double meanSigma(const Eigen::Vector3d& sigma_W);

/// A correlation matrix by its numbers for x with y, x with z, y with z; and the other way round.
[[nodiscard]] Eigen::Matrix3d correlationMatrix(const Eigen::Vector3d& correlation);
[[nodiscard]] Eigen::Vector3d correlationNumbers(const Eigen::Matrix3d& matrix);

/// Whether errors of three coordinates can be correlated so: positive definite, beyond what rounding leaves.
[[nodiscard]] bool isPossibleCorrelation(const Eigen::Vector3d& correlation);

/// Covariance of its rows [m^2] by what the reading states; rows that state no sigma count as exact to a micrometre.
/// The one place where a stated noise becomes a weight: what the encoders add to it is readingCovariance()'s.
[[nodiscard]] MeasuredCovariance statedCovariance(const Measurement& reading);

[[nodiscard]] inline bool isTouch(const Measurement& reading) { return kindOf(reading).is_touch; }

/// Whether it touches a point whose place nobody knows.
[[nodiscard]] inline bool touchesUnknownPoint(const Measurement& reading) { return isTouch(reading) && !reading.p_W; }

/// Whether it touches a surface, whose place nobody knows.
[[nodiscard]] inline bool touchesSurface(const Measurement& reading) { return kindOf(reading).settle != nullptr; }

/// How many numbers of an unknown place it shares with all readings of the same place: a touch of an unknown point
/// three, most readings none; and how what is measured changes with them.
[[nodiscard]] int placeNumbers(const Measurement& reading);
[[nodiscard]] PlaceColumns byPlaceNumbers(const Measurement& reading, const ToolPose& tool);
[[nodiscard]] inline bool hasUnknownPlace(const Measurement& reading) { return placeNumbers(reading) > 0; }

/// Which unknown place that is: "touch P1", "plane table".
[[nodiscard]] std::string placeOf(const Measurement& reading);

/// How many readings of an unknown place say something: one more than place it.
[[nodiscard]] inline int leastOfPlace(const Measurement& reading) {
  return placeNumbers(reading) / rowsOf(reading) + 1;
}

/// Whether it touches a point of known place.
[[nodiscard]] inline bool touchesKnownPoint(const Measurement& reading) { return isTouch(reading) && reading.p_W; }

/// Whether it states where the tip is.
[[nodiscard]] inline bool statesPlace(const Measurement& reading) { return kindOf(reading).is_place && reading.p_W; }

/// Returns where the tip is by the reading [m], whatever numbers state it; nothing where it does not say.
[[nodiscard]] inline std::optional<Eigen::Vector3d> statedPlace(const Measurement& reading) {
  if (kindOf(reading).place) return kindOf(reading).place(reading);
  return statesPlace(reading) ? reading.p_W : std::nullopt;
}

}  // namespace tubeplan::calibration
