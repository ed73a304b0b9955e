// What makes a set of readings unfit to identify anything from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Why readings determine nothing, or not enough.
struct ReadingProblem {
  int reading = -1;  ///< the one to blame, where there is one
  std::string found, expected, advice;
};

/// Numbers that the readings hold beyond the places of unknown points.
[[nodiscard]] int numbersMeasured(const std::vector<Measurement>& readings);

/// The first thing that keeps these readings from telling anything: none at all, a point of unknown place touched once,
/// all at one posture, fewer numbers measured than free.
[[nodiscard]] std::optional<ReadingProblem> findReadingProblem(const std::vector<Measurement>& readings,
                                                               const std::vector<Unknown>& unknowns);

}  // namespace tubeplan::calibration
