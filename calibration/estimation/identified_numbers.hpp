// Results of a fit for each parameter: value, interval, how far the readings determine the value, and a note if one is
// needed.
#pragma once

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// A fit within an identification, and the input of the fit.
struct FittedModel {
  const std::vector<Measurement>& fitted;
  const IdentificationOptions& options;
  PlacedArm start;  ///< state with the unknowns' variables at 0
  std::vector<Unknown> unknowns;
  Fit fit;
  std::optional<ReadingWeights> start_weights;  ///< weights at `start`; empty if the model cannot be evaluated there
};

/// Fills `result.numbers`, one for each unknown in the same order.
void describeNumbers(const FittedModel& model, Identification& result);

/// Widens the intervals of effects' sizes to include all sizes that explain the readings equally well (size_modes.hpp),
/// and states so in the notes.
void widenSizes(const FittedModel& model, Identification& result);

}  // namespace tubeplan::calibration
