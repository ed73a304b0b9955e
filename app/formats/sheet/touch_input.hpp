// Touches out of a measurement file, and the holes that each may have been mistaken for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/studies/measurements/simulated_calibration.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "calibration/measurement.hpp"

namespace tubeplan::app {

/// The touches of known holes among the readings. `file` is for messages. Throws InputError where there are none, where
/// they come from several set-ups and none is chosen, or where a touch says no sigma and the cell has no tool to take
/// it from.
[[nodiscard]] std::vector<calibration::Measurement> touchesOf(const std::vector<calibration::Measurement>& readings,
                                                              const Cell& cell, const std::string& file,
                                                              const std::string& setup = "");

/// What readings of kind steps say of the centring error, by the tool's tolerances, with their sigma. `file` is for
/// messages. Throws InputError for a count that the tool does not have, or none: that has no upper bound.
void settleSteps(std::vector<calibration::Measurement>& readings, const tubesheets::SteppedTool& tool,
                 const std::string& file);

/// The holes chosen, or InputError that none could be.
[[nodiscard]] std::vector<calibration::TouchPlan> requireTouches(BestTouches touches);

/// What the true arm reads at the three holes that place the base best by the model, which is that of `cell`, as
/// `--touches auto`. Throws InputError where it cannot touch three.
[[nodiscard]] std::vector<calibration::Measurement> touchesByTrueArm(const planner::Workcell& model, const Cell& cell,
                                                                     const planner::Workcell& truth,
                                                                     std::uint64_t seed);

/// Throws InputError for touches that place no base: too few, or nearly on a line.
void requireEnoughTouches(const std::vector<calibration::Measurement>& touches, const std::string& file);

/// Touches as a measurement file that `calibrate` reads.
[[nodiscard]] std::string touchesCsv(const std::vector<calibration::Measurement>& touches, const Cell& cell);

}  // namespace tubeplan::app
