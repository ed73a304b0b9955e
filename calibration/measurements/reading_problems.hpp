// Faults of a set of readings that keep it from identifying anything.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Reason why readings determine nothing, or not enough.
struct ReadingProblem {
  int reading = -1;  ///< index of the reading at fault; -1 if there is none
  std::string what;  ///< sentence of what is wrong
  std::string advice;
};

/// Returns how many numbers the readings hold beyond those that the places of unknown points take.
[[nodiscard]] int numbersMeasured(const std::vector<Measurement>& readings);

/// Finds the first fault that makes the readings useless: none at all, a point of unknown place touched once, all at
/// one posture, fewer numbers measured than free.
[[nodiscard]] std::optional<ReadingProblem> findReadingProblem(const std::vector<Measurement>& readings,
                                                               const std::vector<Unknown>& unknowns);

}  // namespace tubeplan::calibration
