#include "calibration/measurements/proposed_measurement.hpp"

#include "calibration/measurements/measurement_prediction.hpp"
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
  if (!kind.is_from_measurement) return values;
  if (proposed.is_length_alone)
    values.numbers.assign(kind.columns.begin(), kind.columns.end());
  else
    values.numbers.assign(kPlaceColumns.begin(), kPlaceColumns.end());
  values.least = static_cast<int>(values.numbers.size());
  return values;
}

Measurement conditionsOf(const ProposedMeasurement& proposed) {
  Measurement measurement;
  measurement.id = proposed.id;
  measurement.kind = proposed.kind;
  measurement.point = proposed.point;
  measurement.setup = proposed.setup;
  measurement.load = proposed.load;
  measurement.q = proposed.q;
  measurement.side_q = proposed.side_q;
  measurement.p_W = proposed.known_W;
  measurement.direction_W = proposed.direction_W;
  measurement.reference = proposed.reference;
  measurement.row = proposed.row;
  measurement.surface = proposed.surface;
  measurement.kind_values[0] = proposed.given;
  measurement.sigma = proposed.sigma;
  measurement.turn_sigma = proposed.turn_sigma;
  measurement.approach_directions = proposed.approach_directions;
  measurement.conditions = proposed.conditions;
  return measurement;
}

std::optional<Measurement> expectedMeasurement(const PlacedArm& placed, const ProposedMeasurement& proposed) {
  const MeasurementKindRow& kind = kindOf(proposed.kind);
  const auto& X_WB = placed.base_poses.back().X_WB;
  Measurement measurement = conditionsOf(proposed);
  measurement.setup = placed.base_poses.back().setup;
  auto tool = frameAt(placed.arm, X_WB, measurement);
  if (!tool) return std::nullopt;
  if (const auto from = departureOf(measurement)) {
    const auto departure_tool = toolAt(placed.arm, X_WB, measurementAt(*from));
    if (!departure_tool) return std::nullopt;
    tool->p_W -= departure_tool->p_W;
  }
  // Without measured values, the measurement means that all steps entered, which is the expected result for a centred
  // tool.
  if (kind.counts_steps) return measurement;
  if (proposed.is_length_alone)
    measurement.kind_values[0] = tool->p_W.norm();
  else
    kind.record(*tool, deflection::measurementScale(placed.arm), MeasuredValue::Zero(kind.rows), measurement);
  return measurement;
}

}  // namespace tubeplan::calibration
