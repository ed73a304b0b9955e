// What touching a hole means: how far off its centring may be, and which holes it may have been mistaken for.
#pragma once

#include "app/studies/cell_model.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "calibration/estimation/estimate.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/stepped_tool.hpp"

namespace tubeplan::app {

/// The neighbours of the hole that a touch names, none where it names none; for as long as the sheet is there.
[[nodiscard]] calibration::NeighbourQuestion neighboursOn(const tubesheets::Sheet& sheet);

/// Returns the doubt beside which touches place a cell's base: of its arm's numbers, and what is known of its model's
/// own error. Touches are chosen and fitted beside the same.
[[nodiscard]] calibration::DoubtBeside doubtBeside(const CellModel& cell);

/// Returns how touches of a cell calibrate its base: beside that doubt, holes told from their neighbours; for as long
/// as the cell is there.
[[nodiscard]] calibration::BaseCalibrationOptions calibrationOptionsOf(const CellModel& cell);

/// Centring noise of the tool's last step, as one sigma of a coordinate: half of what that step lets through.
[[nodiscard]] double touchSigmaOf(const tubesheets::SteppedTool& tool);

}  // namespace tubeplan::app
