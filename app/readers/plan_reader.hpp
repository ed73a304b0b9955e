// A plan's files as stated: plan.json and path.csv.
#pragma once

#include <filesystem>

#include "app/readers/cell_reader.hpp"
#include "planner/plan_checks.hpp"

namespace tubeplan::app {

struct PlanFiles {
  planner::StatedPlan plan;
  std::string compensation;  ///< none, goal-point, via-point
  std::string fingerprint;   ///< of the sheet it was made for
  double load = 0;           ///< N
};

/// Reads both files of the folder, numbers in the cell's units. Throws InputError for a missing file, key or column,
/// for a number that is none, and for a plan in other units than the cell's.
[[nodiscard]] PlanFiles readPlanFiles(const std::filesystem::path& folder, const Cell& cell);

}  // namespace tubeplan::app
