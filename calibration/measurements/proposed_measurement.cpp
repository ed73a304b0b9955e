#include "calibration/measurements/proposed_measurement.hpp"

#include "calibration/measurements/reading_prediction.hpp"
#include "deflection/effects/effect_context.hpp"

namespace tubeplan::calibration {

bool touchesKnownPoint(const ProposedMeasurement& proposed) {
  return kindOf(proposed.kind).is_touch && proposed.known_W;
}

bool touchesUnknownPoint(const ProposedMeasurement& proposed) {
  return kindOf(proposed.kind).is_touch && !proposed.known_W;
}

ValueColumns valueColumnsOf(const ProposedMeasurement& proposed) {
  const MeasurementKindRow& kind = kindOf(proposed.kind);
  ValueColumns values = valueColumnsOf(kind);
  if (!kind.is_from_reading) return values;
  if (proposed.is_length_alone)
    values.numbers.assign(kind.columns.begin(), kind.columns.end());
  else
    values.numbers.assign(kPlaceColumns.begin(), kPlaceColumns.end());
  values.least = static_cast<int>(values.numbers.size());
  return values;
}

Measurement conditionsOf(const ProposedMeasurement& proposed) {
  Measurement reading;
  reading.id = proposed.id;
  reading.kind = proposed.kind;
  reading.point = proposed.point;
  reading.setup = proposed.setup;
  reading.load = proposed.load;
  reading.q = proposed.q;
  reading.side_q = proposed.side_q;
  reading.p_W = proposed.known_W;
  reading.direction_W = proposed.direction_W;
  reading.reference = proposed.reference;
  reading.row = proposed.row;
  reading.surface = proposed.surface;
  reading.own[0] = proposed.given;
  reading.sigma = proposed.sigma;
  reading.turn_sigma = proposed.turn_sigma;
  reading.approach_directions = proposed.approach_directions;
  reading.conditions = proposed.conditions;
  return reading;
}

std::optional<Measurement> expectedReading(const PlacedArm& placed, const ProposedMeasurement& proposed) {
  const MeasurementKindRow& kind = kindOf(proposed.kind);
  const auto& X_WB = placed.base_poses.back().X_WB;
  Measurement reading = conditionsOf(proposed);
  reading.setup = placed.base_poses.back().setup;
  auto tool = frameAt(placed.arm, X_WB, reading);
  if (!tool) return std::nullopt;
  if (const auto from = departureOf(reading)) {
    const auto rest = toolAt(placed.arm, X_WB, readingAt(*from));
    if (!rest) return std::nullopt;
    tool->p_W -= rest->p_W;
  }
  // Left without measured values, the reading counts as one in which all steps entered, as is expected of a centred
  // tool.
  if (kind.counts_steps) return reading;
  if (proposed.is_length_alone)
    reading.own[0] = tool->p_W.norm();
  else
    kind.record(*tool, deflection::measurementScale(placed.arm), MeasuredValue::Zero(kind.rows), reading);
  return reading;
}

}  // namespace tubeplan::calibration
