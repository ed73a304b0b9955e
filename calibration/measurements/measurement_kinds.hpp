// The kinds of reading that there are: an open table. A new one is a header beside this and its row in the table.
#pragma once

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

[[nodiscard]] inline int rowsOf(const Measurement& reading) {
  const MeasurementKindRow& kind = kindOf(reading);
  return kind.rows_of ? kind.rows_of(reading) : kind.rows;
}

/// Whether the tool's turn reaches the reading: by its kind, or because another point of the tool than the tip is seen.
[[nodiscard]] inline bool seesTurn(const Measurement& reading) { return kindOf(reading).sees_turn || reading.p_TQ; }

/// What would be measured of a tool that stands there [m], and how it changes with the tool's pose: at the point of the
/// tool that the reading is of.
[[nodiscard]] MeasuredValue predictedValue(const Measurement& reading, const ToolPose& tool);
[[nodiscard]] MeasuredSlope predictedSlope(const Measurement& reading, const ToolPose& tool);

/// The number of that name among its kind's own; not a number where the kind has none.
[[nodiscard]] double ownNumber(const Measurement& reading, std::string_view name);

/// Takes every reading's reference as it stands among these readings now; one that is not there any more stays as it
/// is.
void linkReferences(std::vector<Measurement>& readings);

/// Of each row [m]: what the reading states; not numbers where it states nothing.
[[nodiscard]] MeasuredValue rowSigmas(const Measurement& reading);

[[nodiscard]] inline bool isTouch(const Measurement& reading) { return kindOf(reading).is_touch; }

/// Whether it touches a point whose place nobody knows.
[[nodiscard]] inline bool touchesUnknownPoint(const Measurement& reading) { return isTouch(reading) && !reading.p_W; }

/// Whether it touches a point of known place.
[[nodiscard]] inline bool touchesKnownPoint(const Measurement& reading) { return isTouch(reading) && reading.p_W; }

/// Whether it states where the tip is.
[[nodiscard]] inline bool statesPlace(const Measurement& reading) { return kindOf(reading).is_place && reading.p_W; }

}  // namespace tubeplan::calibration
