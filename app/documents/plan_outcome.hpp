// Request for a plan and its outcome.
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
  std::string truth;  ///< file; empty: no scores
  std::string compensation = "via-point";
  std::string travel = "joints";  ///< joints or line, see planner::TravelKind
  double load = 0;                ///< in the cell's unit of force
  ConditionsRequest conditions;
  std::map<int, double> stays = {};  ///< dwell time by tube index [s]; a work list in a file states its own
  double padding = 0;                ///< added clearance, in standard deviations of the base
  std::optional<double> standoff;    ///< start of approaches below a hole; in the cell's unit of length
  double insertion = 0;              ///< end of approaches past a hole's face; in the cell's unit of length
  std::uint64_t seed = 1;
};

struct PlanOutcome {
  Cell cell;
  planner::Workcell nominal, model;  ///< cells before and after calibration
  std::optional<planner::Workcell> truth;
  planner::Compensation compensation = planner::Compensation::kViaPoint;
  std::vector<calibration::Measurement> touches;
  std::optional<BothCalibrations> calibration;
  planner::VisitConditions conditions;
  tubesheets::Selection selection;  ///< requested tubes
  std::string left_out;             ///< "12 plugged, 1 inaccessible": tubes excluded from planning
  double padding = 0;               ///< largest extra clearance of a tip at a visited hole [m]
  std::vector<int> zones;           ///< per visit; empty if no tubes have priority
  planner::VisitPlan plan;
  int tubes_added = 0, tubes_removed = 0;    ///< visited tubes compared with the earlier plan
  std::vector<planner::Centring> predicted;  ///< by the model itself, per visit
  std::vector<double> play;                  ///< play of the tool in the tube, per visit [m]; empty without insertion
  StepChances chances;                       ///< probabilities of steps, per visit
  std::vector<ModeScores> scores;            ///< per visit; empty without truth

  /// Returns the calibration that placed the base in this plan; null if the base is the cell's.
  [[nodiscard]] const calibration::BaseCalibration* placedBy() const {
    return calibration ? &calibration->flexible : nullptr;
  }
  [[nodiscard]] BaseStanding standing() const { return standingOf(cell, placedBy()); }
};

}  // namespace tubeplan::app
