// A model of the workbench: a cell in memory, as it would stand in its files, and where it comes from.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/files/cell_reader.hpp"
#include "planner/collision/nearest_pairs.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

struct Model {
  int id = 0;
  std::string label;
  std::string origin;  ///< given, effect, formula, fit, calibration
  Cell cell;
  planner::Workcell posed;                             ///< arm, base and scene alone: what a posture is asked of
  std::shared_ptr<const planner::NearestPairs> pairs;  ///< none where the cell has no bodies
};
using ModelPointer = std::shared_ptr<const Model>;

[[nodiscard]] ModelPointer makeModel(int id, std::string label, std::string origin, Cell cell);

}  // namespace tubeplan::app
