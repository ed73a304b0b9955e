#include "app/studies/model/cell_fit.hpp"

#include "calibration/estimation/fit.hpp"
#include "calibration/measurements/reading_placement.hpp"

namespace tubeplan::app {

calibration::FreeChoice freeNumbersOf(const CellModel& cell) { return {cell.identify, !cell.base_known, cell.priors}; }

calibration::PlacedArm startOf(const CellModel& cell, const std::vector<calibration::Measurement>& readings) {
  return calibration::placeForReadings(cell.arm, cell.X_WB, cell.base_known, readings);
}

calibration::PlacedArm placedWhereRead(const CellModel& cell, const std::vector<calibration::Measurement>& readings) {
  auto placed = startOf(cell, readings);
  calibration::alignBases(placed, readings);
  return placed;
}

}  // namespace tubeplan::app
