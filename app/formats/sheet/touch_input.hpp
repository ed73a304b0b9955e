// Touches of known holes, from measurement files or from a simulation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/studies/measurements/simulated_calibration.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "calibration/measurement.hpp"

namespace tubeplan::app {

/// Returns those measurements that are touches of known holes; messages name the file as `file`. Throws InputError if
/// there are no touches, if touches belong to several set-ups and `setup` is empty, and for a touch without sigma in a
/// cell without a calibration tool.
[[nodiscard]] std::vector<calibration::Measurement> touchesOf(const std::vector<calibration::Measurement>& measurements,
                                                              const Cell& cell, const std::string& file,
                                                              const std::string& setup = "");

/// Sets the counted section, bounds and sigma of measurements of kind steps (counted_section.hpp), according to the
/// cell's tool, which must exist; messages name the file as `file`. Throws InputError for a number of steps that the
/// tool does not have and, unless `takes_none`, for zero steps, which give no upper bound.
void settleSteps(std::vector<calibration::Measurement>& measurements, const Cell& cell, const std::string& file,
                 bool takes_none = false);

/// Returns the touches that `touches` contains. Throws InputError if no holes could be chosen.
[[nodiscard]] std::vector<calibration::TouchPlan> requireTouches(BestTouches touches);

/// Returns simulated touches of the true arm for `--touches auto`, at the three holes that determine the base most
/// accurately according to `model`. Throws InputError if the arm cannot touch three holes.
[[nodiscard]] std::vector<calibration::Measurement> touchesByTrueArm(const planner::Workcell& model, const Cell& cell,
                                                                     const planner::Workcell& truth,
                                                                     std::uint64_t seed);

/// Throws InputError for touches that do not determine the base pose: fewer than three holes, or holes nearly on a
/// line.
void requireEnoughTouches(const std::vector<calibration::Measurement>& touches, const std::string& file);

/// Returns the text of a measurement file that contains the touches, as input of the command `calibrate`.
[[nodiscard]] std::string touchesCsv(const std::vector<calibration::Measurement>& touches, const Cell& cell);

}  // namespace tubeplan::app
