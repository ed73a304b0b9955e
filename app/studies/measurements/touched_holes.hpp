// Interpretation of touched holes: the centring noise, and neighbouring holes that may have been touched by mistake.
#pragma once

#include "app/studies/cell_model.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "calibration/estimation/estimate.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/stepped_tool.hpp"

namespace tubeplan::app {

/// Returns a function that lists the neighbours of the hole named by a touch; none if the touch names no hole. `sheet`
/// must outlive the function.
[[nodiscard]] calibration::NeighbourQuestion neighboursOn(const tubesheets::Sheet& sheet);

/// Returns the uncertainties that a calibration of the cell's base from touches must consider: the uncertainty of the
/// arm's parameters, and the model error if it is known. Touches must be chosen and fitted with the same uncertainties.
[[nodiscard]] calibration::AdditionalUncertainty additionalUncertainty(const CellModel& cell);

/// Returns the options to calibrate the cell's base from touches: the uncertainties of additionalUncertainty(), and the
/// neighbours of holes. `cell` must outlive the options.
[[nodiscard]] calibration::BaseCalibrationOptions calibrationOptionsOf(const CellModel& cell);

/// Returns the centring noise of the tool's last step, as the standard deviation of a coordinate [m]: half of the
/// step's tolerance.
[[nodiscard]] double touchSigmaOf(const tubesheets::SteppedTool& tool);

}  // namespace tubeplan::app
