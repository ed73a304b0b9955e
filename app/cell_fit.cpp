#include "app/cell_fit.hpp"

namespace tubeplan::app {

calibration::FreeChoice freeNumbersOf(const Cell& cell) { return {cell.identify, !cell.base_known, cell.priors}; }

calibration::PlacedArm startOf(const Cell& cell, const std::vector<calibration::Measurement>& readings) {
  return calibration::placeForReadings(cell.arm, cell.X_WB, cell.base_known, readings);
}

InputError refusalOf(const std::optional<calibration::ReadingProblem>& problem, const std::string& reason,
                     const CellReadings& input) {
  if (problem) return inputErrorOf(*problem, input.readings, input.file);
  return {input.file, reason, "readings that tell the free parameters", ""};
}

}  // namespace tubeplan::app
