// What was measured stands a row off from the joints and loads that it was measured at. What has no partner is left
// out.
#pragma once

#include <charconv>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::shifted_rows {

inline std::vector<std::string> values(const CheckedReadings& checked) {
  return checked.readings.size() > 3 ? std::vector<std::string>{"-1", "1"} : std::vector<std::string>{};
}

/// The measured part of a reading.
inline void takeMeasured(const Measurement& from, Measurement& to) {
  to.kind = from.kind;
  to.point = from.point;
  to.p_W = from.p_W;
  to.direction_W = from.direction_W;
  to.p_TQ = from.p_TQ;
  to.own = from.own;
  to.row = from.row;
  to.reference = from.reference;
  to.sigma = from.sigma;
  to.sigma_W = from.sigma_W;
  to.correlation_W = from.correlation_W;
  to.turn_sigma = from.turn_sigma;
}

/// Every reading gets what stands `by` rows further down.
inline void shift(int by, std::vector<Measurement>& readings) {
  std::vector<Measurement> shifted;
  const auto count = static_cast<int>(readings.size());
  for (int k = 0; k < count; ++k) {
    if (k + by < 0 || k + by >= count) continue;
    const Measurement& measured = readings[static_cast<std::size_t>(k + by)];
    if (measured.setup != readings[static_cast<std::size_t>(k)].setup) continue;
    shifted.push_back(readings[static_cast<std::size_t>(k)]);
    takeMeasured(measured, shifted.back());
  }
  readings = std::move(shifted);
}

inline std::optional<Mend> mend(const CheckedReadings&, const std::string& value) {
  int by = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), by);
  if (error != std::errc{} || end != value.data() + value.size() || by == 0 || std::abs(by) > 1000) return std::nullopt;
  const std::string rows = std::to_string(std::abs(by)) + (std::abs(by) == 1 ? " row" : " rows");
  Mend mend{"shift", value,
            "the measured values stand " + rows + (by > 0 ? " below" : " above") + " the joint readings it belongs to"};
  mend.change = [by](std::vector<Measurement>& readings) { shift(by, readings); };
  return mend;
}

inline MistakeKind kind() {
  return {"shift", "ROWS", "how many rows lower the measured values stand than their joint readings, such as 1 or -1",
          values, mend};
}

}  // namespace tubeplan::calibration::mistakes::shifted_rows
