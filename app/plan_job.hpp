// The main job: touches, calibration, plan and score, from files named in a request to results in memory.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/plan_conditions.hpp"
#include "app/plan_keeper.hpp"
#include "app/readers/cell_reader.hpp"
#include "app/step_chances.hpp"
#include "app/step_score.hpp"
#include "app/touch_rehearsal.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

struct PlanRequest {
  std::string cell;           ///< file
  std::string tubes = "all";  ///< selection or CSV file
  std::string
      touches;  ///< file, `auto` (the truth touches holes chosen by the program), or empty: base as the cell has it
  std::string truth;  ///< file; empty: nothing is scored
  std::string compensation = "via-point";
  double load = 0;  ///< in the cell's unit of force
  ConditionsRequest conditions;
  double padding = 0;              ///< of the base's standard deviations, kept beyond the scene's clearance
  std::optional<double> standoff;  ///< below a hole, where approaches begin; in the cell's unit of length
  std::uint64_t seed = 1;
};

struct PlanOutcome {
  Cell cell;
  planner::Workcell nominal, model;  ///< before and after calibration
  std::optional<planner::Workcell> truth;
  planner::Compensation compensation = planner::Compensation::kViaPoint;
  std::vector<calibration::Measurement> touches;
  std::optional<BothCalibrations> calibration;
  planner::VisitConditions conditions;
  std::string left_out;    ///< "12 plugged": tubes that were not planned for
  double padding = 0;      ///< m, the most that a tip at a visited hole is kept off beyond the clearance
  std::vector<int> zones;  ///< per visit; empty where no tubes come first
  planner::VisitPlan plan;
  int tubes_added = 0, tubes_removed = 0;    ///< against the plan begun from, of those visited
  std::vector<planner::Centring> predicted;  ///< by the model itself, per visit
  StepChances chances;                       ///< of steps, per visit
  std::vector<ModeScores> scores;            ///< per visit; empty without truth
};

/// Reads, calibrates, plans and scores. Throws InputError for bad input. A calibration that is refused ends the job
/// with the plan not run. The keeper gives what is known already and keeps what is found out.
[[nodiscard]] PlanOutcome runPlanJob(const PlanRequest& request, planner::PlanHooks hooks, PlanKeeper& keeper);

/// Plans the visits of a cell at hand, its base where it is, and scores against the request's truth; of the request's
/// other files none is read, and nothing is kept. Its tubes are a selection, no file.
[[nodiscard]] PlanOutcome planCell(const Cell& cell, const PlanRequest& request, planner::PlanHooks hooks);

}  // namespace tubeplan::app
