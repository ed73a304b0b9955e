#include "app/calibration_job.hpp"

#include "app/calibration_json.hpp"
#include "app/input_error.hpp"
#include "app/readers/cell_writer.hpp"

namespace tubeplan::app {

CalibrationOutcome calibrateCell(const Cell& cell, const std::vector<calibration::Touch>& touches,
                                 const std::string& file) {
  if (const auto problem = calibration::findTouchProblem(touches); !problem.empty())
    throw InputError(file, problem, "three or more different holes, well spread", "touch another hole");
  CalibrationOutcome outcome;
  outcome.calibration = calibration::calibrateBase(cell.arm, touches, cell.X_WB);
  outcome.figures = calibrationJson(outcome.calibration, cell.units);
  return outcome;
}

std::string calibratedCellText(const Cell& cell, const calibration::BaseCalibration& calibration,
                               const std::string& out) {
  return cellTextWithBase(cell, {calibration.X_WB, calibration::widenedCovariance(calibration), true}, out);
}

}  // namespace tubeplan::app
