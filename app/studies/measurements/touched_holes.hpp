// Interpretation of touched holes: the centring noise, and the holes that one may have been mistaken for.
#pragma once

#include "app/studies/cell_model.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "calibration/estimation/estimate.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/stepped_tool.hpp"

namespace tubeplan::app {

/// Returns a function for the neighbours of the hole that a touch names, none if it names none. `sheet` must outlive
/// it.
[[nodiscard]] calibration::NeighbourQuestion neighboursOn(const tubesheets::Sheet& sheet);

/// Returns the doubt with which touches place a cell's base: of its arm's numbers, and its model's own error as far as
/// known. Touches are chosen and fitted with the same doubt.
[[nodiscard]] calibration::DoubtBeside doubtBeside(const CellModel& cell);

/// Returns the options for calibrating a cell's base by touches: with that doubt, and with the neighbours of holes.
/// `cell` must outlive them.
[[nodiscard]] calibration::BaseCalibrationOptions calibrationOptionsOf(const CellModel& cell);

/// Returns the centring noise of the tool's last step, as one sigma of a coordinate [m]: half of that step's tolerance.
[[nodiscard]] double touchSigmaOf(const tubesheets::SteppedTool& tool);

}  // namespace tubeplan::app
