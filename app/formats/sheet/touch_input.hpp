// Touches of known holes from measurement files and simulations.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/studies/measurements/simulated_calibration.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "calibration/measurement.hpp"

namespace tubeplan::app {

/// Returns the touches of known holes among the readings; `file` names them in messages. Throws InputError for no
/// touches, for touches of several set-ups without a choice, and for a touch without sigma in a cell without a tool.
[[nodiscard]] std::vector<calibration::Measurement> touchesOf(const std::vector<calibration::Measurement>& readings,
                                                              const Cell& cell, const std::string& file,
                                                              const std::string& setup = "");

/// Sets the bounds of the centring error and its sigma in readings of kind steps, by the tool's tolerances; `file`
/// names them in messages. Throws InputError for a count that the tool does not have, and for zero, which gives no
/// upper bound.
void settleSteps(std::vector<calibration::Measurement>& readings, const tubesheets::SteppedTool& tool,
                 const std::string& file);

/// Returns the chosen holes. Throws InputError if none could be chosen.
[[nodiscard]] std::vector<calibration::TouchPlan> requireTouches(BestTouches touches);

/// Returns simulated touches of the true arm for `--touches auto`, at the three holes that determine the base best by
/// the model of `cell`. Throws InputError if it cannot touch three.
[[nodiscard]] std::vector<calibration::Measurement> touchesByTrueArm(const planner::Workcell& model, const Cell& cell,
                                                                     const planner::Workcell& truth,
                                                                     std::uint64_t seed);

/// Throws InputError for touches that do not determine a base: too few, or nearly on a line.
void requireEnoughTouches(const std::vector<calibration::Measurement>& touches, const std::string& file);

/// Returns touches as the text of a measurement file for `calibrate`.
[[nodiscard]] std::string touchesCsv(const std::vector<calibration::Measurement>& touches, const Cell& cell);

}  // namespace tubeplan::app
