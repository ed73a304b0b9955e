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

[[nodiscard]] inline int rowsOf(const Measurement& reading) { return kindOf(reading).rows; }

[[nodiscard]] inline bool isTouch(const Measurement& reading) { return kindOf(reading).is_touch; }

/// Whether it touches a point whose place nobody knows.
[[nodiscard]] inline bool touchesUnknownPoint(const Measurement& reading) { return isTouch(reading) && !reading.p_W; }

/// Whether it touches a point of known place.
[[nodiscard]] inline bool touchesKnownPoint(const Measurement& reading) { return isTouch(reading) && reading.p_W; }

/// Whether it states where the tip is.
[[nodiscard]] inline bool statesPlace(const Measurement& reading) { return kindOf(reading).is_place && reading.p_W; }

}  // namespace tubeplan::calibration
