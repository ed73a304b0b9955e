// Reader of a plan's files as stated: plan.json and path.csv.
#pragma once

#include <filesystem>

#include "app/formats/cell/cell_reader.hpp"
#include "planner/verification/plan_checks.hpp"

namespace tubeplan::app {

/// Tube stated in a row of the path.
struct TubeEcho {
  std::string leg;
  int row = 0, column = 0;
  bool operator==(const TubeEcho&) const = default;
};

struct PlanFiles {
  planner::StatedPlan plan;
  std::string compensation;  ///< kind of compensation: none, goal-point, via-point
  std::string fingerprint;   ///< fingerprint of the sheet for which it was made
  std::string leg, viewed_from;
  double padding_sigmas = 0;  ///< margin beyond the scene's clearance [standard deviations of the base's place]
  double load = 0;            ///< hung load [N]
  double insertion = 0;       ///< insertion past the face of the sheet [m]
  std::vector<std::string> tube_legs;  ///< legs of plan.tubes; empty in a plan without
  std::vector<TubeEcho> path_echoes;   ///< tubes of the rows of plan.path; empty in a plan without
  std::string path_fingerprint;        ///< fingerprint of the numbers in path.csv
  std::string stated_path;             ///< fingerprint of the path as stated in plan.json; empty in a plan without
};

/// Reads both files of the folder, with numbers in the cell's units. Throws InputError for a missing file, key or
/// column, for an invalid number, and for a plan in other units than the cell's.
[[nodiscard]] PlanFiles readPlanFiles(const std::filesystem::path& folder, const Cell& cell);

}  // namespace tubeplan::app
