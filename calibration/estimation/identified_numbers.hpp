// Results of a fit for each number: its value with an interval, how far the readings determine it, and a note if one is
// needed.
#pragma once

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// A fit of an identification, and its input.
struct FittedModel {
  const std::vector<Measurement>& fitted;
  const IdentificationOptions& options;
  PlacedArm start;  ///< state with the unknowns' variables at 0
  std::vector<Unknown> unknowns;
  Fit fit;
  std::optional<ReadingWeights> start_weights;  ///< weights at `start`, if it can be evaluated
};

/// Sets `numbers`, one for each unknown in their order.
void describeNumbers(const FittedModel& model, Identification& result);

/// Widens the intervals of effects' sizes over all sizes that explain the readings as well (size_modes.hpp), and says
/// so in the numbers' notes.
void widenSizes(const FittedModel& model, Identification& result);

}  // namespace tubeplan::calibration
