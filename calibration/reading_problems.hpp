// What makes a set of readings unfit to identify anything from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

/// Why readings tell nothing, or not enough.
struct ReadingProblem {
  int reading = -1;  ///< the one to blame, where there is one
  std::string found, expected, advice;
};

/// The first thing that keeps these readings from telling anything: none at all, a point of unknown place touched once,
/// all at one posture, fewer numbers measured than free.
[[nodiscard]] std::optional<ReadingProblem> findReadingProblem(const std::vector<Measurement>& readings,
                                                               const std::vector<Unknown>& unknowns);

/// Something that looks like a slip of units or of a hole's name.
struct ReadingSuspicion {
  std::string what;                  ///< "the joint readings look like radians under a column in degrees"
  double rms_as_is = 0, rms_if = 0;  ///< m, by the model with the bases placed
};

/// Tries the usual slips (radians for degrees, inches for millimetres, grams and kilograms for newtons) on all readings
/// and names those that make the model, as it stands, fit far better.
[[nodiscard]] std::vector<ReadingSuspicion> findUnitSlips(const PlacedArm& placed,
                                                          const std::vector<Measurement>& readings);

}  // namespace tubeplan::calibration
