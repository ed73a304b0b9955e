// Results of a fit for each parameter: value, interval, verdict on whether the measurements determine it, and a note if
// needed.
#pragma once

#include "calibration/estimation/fit.hpp"

namespace tubeplan::calibration {

/// A fit made during an identification, together with its input.
struct FittedModel {
  const std::vector<Measurement>& fitted;
  const IdentificationOptions& options;
  PlacedArm start;  ///< state of the arm at which the variables of `unknowns` are 0
  std::vector<Unknown> unknowns;
  Fit fit;
  std::optional<MeasurementWeights>
      start_weights;  ///< measurement weights at `start`; empty if the model cannot be evaluated there
};

/// Fills `result.numbers` with one entry per unknown, in the order of `model.unknowns`.
void describeNumbers(const FittedModel& model, Identification& result);

/// Widens the interval of each effect's magnitude to include all magnitudes that explain the measurements equally well
/// (size_modes.hpp), and adds a note on them.
void widenSizes(const FittedModel& model, Identification& result);

}  // namespace tubeplan::calibration
