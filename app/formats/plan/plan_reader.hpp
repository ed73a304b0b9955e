// A plan's files as stated: plan.json and path.csv.
#pragma once

#include <filesystem>

#include "app/formats/cell/cell_reader.hpp"
#include "planner/verification/plan_checks.hpp"

namespace tubeplan::app {

/// What a row of the path says it goes to.
struct TubeEcho {
  std::string leg;
  int row = 0, column = 0;
  bool operator==(const TubeEcho&) const = default;
};

struct PlanFiles {
  planner::StatedPlan plan;
  std::string compensation;  ///< none, goal-point, via-point
  std::string fingerprint;   ///< of the sheet it was made for
  std::string leg, viewed_from;
  double padding_sigmas = 0;           ///< kept beyond the scene's clearance
  double load = 0;                     ///< N
  double insertion = 0;                ///< m, past the face
  std::vector<std::string> tube_legs;  ///< of plan.tubes; empty in a plan without
  std::vector<TubeEcho> path_echoes;   ///< of plan.path; empty in a plan without
  std::string path_fingerprint;        ///< of the numbers that path.csv has ...
  std::string stated_path;             ///< ... and as plan.json states it; empty in a plan without
};

/// Reads both files of the folder, numbers in the cell's units. Throws InputError for a missing file, key or column,
/// for a number that is none, and for a plan in other units than the cell's.
[[nodiscard]] PlanFiles readPlanFiles(const std::filesystem::path& folder, const Cell& cell);

}  // namespace tubeplan::app
