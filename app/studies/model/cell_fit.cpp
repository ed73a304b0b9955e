#include "app/studies/model/cell_fit.hpp"

namespace tubeplan::app {

calibration::FreeChoice freeNumbersOf(const CellModel& cell) { return {cell.identify, !cell.base_known, cell.priors}; }

calibration::PlacedArm startOf(const CellModel& cell, const std::vector<calibration::Measurement>& readings) {
  return calibration::placeForReadings(cell.arm, cell.X_WB, cell.base_known, readings);
}

}  // namespace tubeplan::app
