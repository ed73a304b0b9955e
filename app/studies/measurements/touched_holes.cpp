#include "app/studies/measurements/touched_holes.hpp"

#include "planner/workcell.hpp"

namespace tubeplan::app {

double touchSigmaOf(const tubesheets::SteppedTool& tool) { return tool.steps.back().tolerance / 2; }

calibration::NeighbourQuestion neighboursOn(const tubesheets::Sheet& sheet) {
  return [&sheet](const calibration::Measurement& touch) {
    std::vector<calibration::NeighbourHole> neighbours;
    const auto name = tubesheets::parseTubeName(touch.point);
    const auto index = name ? sheet.indexOf(name->row, name->column) : std::nullopt;
    if (!index) return neighbours;
    for (const int neighbour : sheet.neighbours(*index)) {
      const auto& tube = sheet.tubes[static_cast<std::size_t>(neighbour)];
      neighbours.push_back({tubesheets::tubeName(tube.row, tube.column), planner::holeCentre(tube)});
    }
    return neighbours;
  };
}

calibration::AdditionalUncertainty additionalUncertainty(const CellModel& cell) {
  const auto known = cell.knownModelError();
  return {cell.uncertainty, known ? known->sigma : 0};
}

calibration::BaseCalibrationOptions calibrationOptionsOf(const CellModel& cell) {
  calibration::BaseCalibrationOptions options;
  const calibration::AdditionalUncertainty additional = additionalUncertainty(cell);
  options.arm = additional.arm;
  options.model_error = additional.model_error;
  if (cell.sheet) options.neighbours = neighboursOn(*cell.sheet);
  return options;
}

}  // namespace tubeplan::app
