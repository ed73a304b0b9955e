#include "app/jobs/calibration.hpp"

#include "app/documents/calibration_json.hpp"
#include "app/documents/step_chances_json.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/studies/measurements/touched_holes.hpp"
#include "app/studies/positioning/step_chances.hpp"

namespace tubeplan::app {

CalibrationOutcome calibrateCell(const Cell& cell, const std::vector<calibration::Measurement>& touches,
                                 const std::string& file) {
  requireEnoughTouches(touches, file);
  CalibrationOutcome outcome;
  outcome.touches = touches;
  outcome.calibration = calibration::calibrateBase(cell.filedArm(), touches, cell.X_WB, calibrationOptionsOf(cell));
  outcome.model_error = modelErrorFor(cell, outcome.calibration);
  outcome.figures = calibrationJson(outcome.calibration, cell);
  if (outcome.model_error) outcome.figures["model_error"] = modelErrorJson(*outcome.model_error, cell.units);
  return outcome;
}

std::string calibratedCellText(const Cell& cell, const CalibrationOutcome& outcome, const std::string& out) {
  const auto& base = outcome.calibration;
  return cellTextWithBase(cell, {base.X_WB, base.covariance, true, outcome.model_error, outcome.touches, &base.arm},
                          out);
}

}  // namespace tubeplan::app
