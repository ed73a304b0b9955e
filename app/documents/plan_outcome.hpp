// Request for a plan, and results of the planning.
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
  std::string cell;           ///< file name
  std::string tubes = "all";  ///< selection, or name of a CSV file
  /// Measurement file of touches; `auto` simulates touches of the true arm; empty keeps the cell's base.
  std::string touches;
  std::string truth;  ///< file name of the true cell; empty if no scores are computed
  std::string compensation = "via-point";
  std::string travel = "joints";  ///< `joints` or `line`, see planner::TravelKind
  double load = 0;                ///< in the cell's force unit
  ConditionsRequest conditions;
  /// Dwell time at each tube [s], keyed by tube index; a work list file states its own dwell times.
  std::map<int, double> dwell_times = {};
  double padding = 0;              ///< additional clearance, in standard deviations of the base pose
  std::optional<double> standoff;  ///< distance below a hole at which the approach starts, in the cell's length unit
  /// True if each hole is approached from the shortest clear distance, up to `standoff`.
  bool has_least_standoff = false;
  double insertion = 0;  ///< distance past a hole's face at which the approach ends, in the cell's length unit
  std::uint64_t seed = 1;
};

struct PlanOutcome {
  Cell cell;
  planner::Workcell nominal, model;  ///< workcells before and after calibration
  std::optional<planner::Workcell> truth;
  planner::Compensation compensation = planner::Compensation::kViaPoint;
  std::vector<calibration::Measurement> touches;
  std::optional<BothCalibrations> calibration;
  planner::VisitConditions conditions;
  tubesheets::Selection selection;  ///< selection of the requested tubes
  std::string left_out;             ///< tubes excluded from planning, such as "12 plugged, 1 inaccessible"
  double padding = 0;               ///< largest additional clearance at the tip among the visited holes [m]
  std::vector<int> zones;           ///< zone of each visit; empty if no tubes have priority
  planner::VisitPlan plan;
  /// Number of tubes visited only in this plan, and number visited only in the earlier plan from which it starts.
  int tubes_added = 0, tubes_removed = 0;
  std::vector<planner::Centring> predicted;  ///< centring at each visit as the model predicts it
  std::vector<double> play;  ///< smallest clearance between tool and tube at each visit [m]; empty without insertion
  StepChances chances;       ///< probabilities of 0, 1, ... steps at each visit
  std::vector<ModeScores> scores;  ///< centring of the true arm at each visit; empty without a truth

  /// Returns the calibration that determined the base of this plan; null if the plan uses the cell's base.
  [[nodiscard]] const calibration::BaseCalibration* placedBy() const {
    return calibration ? &calibration->flexible : nullptr;
  }
  [[nodiscard]] BaseStanding standing() const { return standingOf(cell, placedBy()); }
};

}  // namespace tubeplan::app
