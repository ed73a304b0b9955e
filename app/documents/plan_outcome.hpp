// What a plan was asked and what came of it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/plan/plan_conditions.hpp"
#include "app/studies/measurements/simulated_calibration.hpp"
#include "app/studies/positioning/base_standing.hpp"
#include "app/studies/positioning/step_chances.hpp"
#include "app/studies/positioning/step_score.hpp"
#include "planner/visit_plan.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

struct PlanRequest {
  std::string cell;           ///< file
  std::string tubes = "all";  ///< selection or CSV file
  std::string
      touches;  ///< file, `auto` (the truth touches holes chosen by the program), or empty: base as the cell has it
  std::string truth;  ///< file; empty: nothing is scored
  std::string compensation = "via-point";
  std::string travel = "joints";  ///< or line: see planner::TravelKind
  double load = 0;                ///< in the cell's unit of force
  ConditionsRequest conditions;
  std::map<int, double> stays = {};  ///< s at tubes by their index; a work list in a file has its own
  double padding = 0;                ///< of the base's standard deviations, kept beyond the scene's clearance
  std::optional<double> standoff;    ///< below a hole, where approaches begin; in the cell's unit of length
  double insertion = 0;              ///< past a hole's face, where approaches end; in the cell's unit of length
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
  tubesheets::Selection selection;  ///< what was asked for
  std::string left_out;             ///< "12 plugged, 1 inaccessible": tubes that were not planned for
  double padding = 0;               ///< m, the most that a tip at a visited hole is kept off beyond the clearance
  std::vector<int> zones;           ///< per visit; empty where no tubes come first
  planner::VisitPlan plan;
  int tubes_added = 0, tubes_removed = 0;    ///< against the plan begun from, of those visited
  std::vector<planner::Centring> predicted;  ///< by the model itself, per visit
  std::vector<double> play;                  ///< m, of the tool in the tube, per visit; empty without insertion
  StepChances chances;                       ///< of steps, per visit
  std::vector<ModeScores> scores;            ///< per visit; empty without truth

  /// What placed the base, where this plan did; null: it stands as the cell has it.
  [[nodiscard]] const calibration::BaseCalibration* placedBy() const {
    return calibration ? &calibration->flexible : nullptr;
  }
  [[nodiscard]] BaseStanding standing() const { return standingOf(cell, placedBy()); }
};

}  // namespace tubeplan::app
