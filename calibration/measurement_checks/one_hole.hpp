// Mistake: one measurement names a hole other than the touched one. mistakenHoles() in plain_checks.hpp searches for
// this mistake measurement by measurement.
#pragma once

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::one_hole {

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const auto [id, name] = partedAtColon(value);
  const auto hole = tubesheets::parseTubeName(name);
  const auto* tube = hole && checked.sheet ? checked.sheet->find(hole->row, hole->column) : nullptr;
  if (!tube) return std::nullopt;
  Correction correction{"hole", value, "reading " + id + " touched " + name};
  correction.change = toEach([id, name, place = Eigen::Vector3d(tube->x, tube->y, 0)](Measurement& measurement) {
    if (measurement.id == id) measurement.point = name, measurement.p_W = place;
  });
  return correction;
}

inline MistakeKind kind() {
  return {"hole", "ID:HOLE", "a reading and the hole it touched, such as 7:R10C21", noValues, correction};
}

}  // namespace tubeplan::calibration::mistakes::one_hole
