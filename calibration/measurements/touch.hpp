// Kind `touch`: the tip rests centred at a point, which several measurements may share. The point's position x, y, z
// may be known or unknown.
#pragma once

#include "calibration/measurements/coordinates.hpp"

namespace tubeplan::calibration::touch {

/// Writes nothing: the tip rests at the touched point, whether or not the point's position is known.
inline void recordNothing(const ToolPose&, double, const MeasuredValue&, Measurement&) {}

inline std::optional<MeasurementLack> lack(const Measurement& measurement, const std::string&) {
  if (!measurement.point.empty()) return std::nullopt;
  return MeasurementLack{"the touch has no point", "write the point's name in the column 'point'"};
}

inline MeasurementKindRow kind() {
  MeasurementKindRow row = coordinates::row(MeasurementKind::kTouch, "touch");
  row.is_touch = row.is_place = row.names_hole = row.is_centring = true;
  row.record = recordNothing;
  row.lack = lack;
  row.usual_sigma = kTouchSigma;
  row.value_columns = jointsOnly;
  row.state = coordinates::statePoint;
  return row;
}

}  // namespace tubeplan::calibration::touch
