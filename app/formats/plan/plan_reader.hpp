// Reader of the files of a plan: plan.json and path.csv.
#pragma once

#include <filesystem>
#include <optional>

#include "app/formats/cell/cell_reader.hpp"
#include "planner/verification/plan_checks.hpp"

namespace tubeplan::app {

/// The tube that a row of path.csv states.
struct TubeEcho {
  std::string leg;
  int row = 0, column = 0;
  bool operator==(const TubeEcho&) const = default;
};

struct PlanFiles {
  planner::StatedPlan plan;
  std::optional<TubeEcho> start_at;  ///< tube at which the arm starts; nothing if it starts at none
  std::string compensation;          ///< kind of compensation: none, goal-point, via-point
  std::string fingerprint;           ///< fingerprint of the sheet for which the plan was made
  std::string leg, viewed_from;
  double padding_sigmas = 0;  ///< margin added to the scene's clearance [standard deviations of the base position]
  double load = 0;            ///< suspended load [N]
  double insertion = 0;       ///< insertion depth past the sheet's face [m]
  std::vector<std::string> tube_legs;  ///< leg of each tube in plan.tubes; empty if the plan states no legs
  std::vector<TubeEcho> path_echoes;   ///< tube stated in each row of plan.path; empty if path.csv has no columns for
                                       ///< tubes
  std::string path_fingerprint;        ///< fingerprint of the numbers in path.csv as read
  std::string stated_path;             ///< fingerprint of the path as stated in plan.json; empty if plan.json has none
};

/// Reads plan.json and path.csv from `folder`, with numbers in the cell's units. Throws InputError for a missing file,
/// key or column, for an invalid number, and for a plan in units other than the cell's.
[[nodiscard]] PlanFiles readPlanFiles(const std::filesystem::path& folder, const Cell& cell);

}  // namespace tubeplan::app
