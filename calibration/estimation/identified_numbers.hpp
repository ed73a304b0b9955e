// What a fit says of each number: its value with an interval, how far the readings determine it, and a plain sentence
// where there is something to say.
#pragma once

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// A fit of an identification, and what it was made from.
struct FittedModel {
  const std::vector<Measurement>& fitted;
  const IdentificationOptions& options;
  PlacedArm start;  ///< where the unknowns' variables are 0
  std::vector<Unknown> unknowns;
  Fit fit;
  std::optional<ReadingWeights> start_weights;  ///< at `start`, where it can be evaluated
};

/// Fills `numbers`, one for each unknown in their order.
void describeNumbers(const FittedModel& model, Identification& result);

}  // namespace tubeplan::calibration
