// Problems of a set of measurements that make identification impossible.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Reason why a set of measurements cannot determine the free parameters.
struct MeasurementProblem {
  int measurement = -1;  ///< index of the measurement with the problem; -1 if it concerns several measurements
  std::string what;      ///< description of the problem, as a sentence
  std::string advice;
};

/// Returns the number of measured values minus the number of parameters of unknown places.
[[nodiscard]] int numbersMeasured(const std::vector<Measurement>& measurements);

/// Returns the first problem that makes the measurements useless: no measurement at all, a point touched once or a
/// surface touched too few times while its position is unknown, all measurements at one posture, or fewer measured
/// values than free parameters.
[[nodiscard]] std::optional<MeasurementProblem> findMeasurementProblem(const std::vector<Measurement>& measurements,
                                                                       const std::vector<Unknown>& unknowns);

}  // namespace tubeplan::calibration
