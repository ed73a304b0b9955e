// Faults of a set of readings that make any identification impossible.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Reason why a set of readings cannot determine the free parameters.
struct ReadingProblem {
  int reading = -1;  ///< index of the reading at fault; -1 if no single reading is
  std::string what;  ///< the fault, as a sentence
  std::string advice;
};

/// Returns the number of measured values minus the number of parameters of unknown places.
[[nodiscard]] int numbersMeasured(const std::vector<Measurement>& readings);

/// Returns the first fault that makes the readings useless: no reading at all, a point touched once or a surface
/// touched too few times while its position is unknown, all readings at one posture, or fewer measured values than free
/// parameters.
[[nodiscard]] std::optional<ReadingProblem> findReadingProblem(const std::vector<Measurement>& readings,
                                                               const std::vector<Unknown>& unknowns);

}  // namespace tubeplan::calibration
