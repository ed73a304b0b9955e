#include "app/studies/model/cell_fit.hpp"

#include "calibration/estimation/fit.hpp"
#include "calibration/measurements/measurement_placement.hpp"

namespace tubeplan::app {

calibration::FreeChoice freeNumbersOf(const CellModel& cell) { return {cell.identify, !cell.base_known, cell.priors}; }

calibration::PlacedArm startOf(const CellModel& cell, const std::vector<calibration::Measurement>& measurements) {
  return calibration::placeForMeasurements(cell.arm, cell.X_WB, cell.base_known, measurements);
}

calibration::PlacedArm placedWhereRead(const CellModel& cell,
                                       const std::vector<calibration::Measurement>& measurements) {
  auto placed = startOf(cell, measurements);
  calibration::alignBases(placed, measurements);
  return placed;
}

}  // namespace tubeplan::app
