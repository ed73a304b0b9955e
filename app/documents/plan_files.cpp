#include "app/documents/plan_files.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/task_group.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/documents/calibration_json.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/plan_answer.hpp"
#include "app/documents/plan_text.hpp"
#include "app/documents/pose_json.hpp"
#include "app/documents/step_chances_json.hpp"
#include "app/documents/work_list_export.hpp"
#include "app/formats/arm/joint_units.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/formats/plan/path_numbers.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/formats/units.hpp"
#include "app/formats/units_json.hpp"
#include "app/report/plan_report.hpp"
#include "app/storage/origin.hpp"
#include "app/version.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

/// Returns values in file units at full precision; vectorJson() would round them to 12 digits.
json exactVector(const Eigen::VectorXd& values, const Units& units, Dimension dimension) {
  json list = json::array();
  for (double value : values) list.push_back(value / units.factor(dimension));
  return list;
}

json scoreJson(const std::optional<planner::Centring>& score, const Units& units) {
  if (!score) return nullptr;
  return {{"error", lengthOf(score->error, units)},
          {"dx", lengthOf(score->offset.x(), units)},
          {"dy", lengthOf(score->offset.y(), units)},
          {"height", lengthOf(score->height, units)},
          {"approach_deviation", lengthOf(score->approach_deviation, units)},
          {"steps", score->steps}};
}

json modesJson(const ModeScores& scores, const Units& units) {
  json modes;
  for (std::size_t mode = 0; mode < kModeKeys.size(); ++mode) modes[kModeKeys[mode]] = scoreJson(scores[mode], units);
  return modes;
}

/// Returns the compensation modes that are scored, in the order of Calkins 1994: [{name, words, brief}, ...].
json modeWordsJson() {
  json modes = json::array();
  for (std::size_t mode = 0; mode < kModeKeys.size(); ++mode) {
    const bool is_none = kCompensations[mode] == planner::Compensation::kNone;
    modes.push_back({{"name", kModeKeys[mode]},
                     {"words", planner::wordsOf(kCompensations[mode])},
                     {"brief", is_none ? "without" : planner::nameOf(kCompensations[mode])}});
  }
  return modes;
}

json chancesJson(const PlanOutcome& outcome, std::size_t k) {
  return outcome.chances.by_posture.empty() ? json(nullptr) : json(outcome.chances.by_posture[k]);
}

json tubeJson(const PlanOutcome& outcome, std::size_t k) {
  const Units& units = outcome.cell.units;
  const auto& visit = outcome.plan.visits[k];
  const auto& tube = outcome.model.sheet.tubes[static_cast<std::size_t>(visit.tube)];
  json entry = {{"leg", tubesheets::legName(outcome.model.sheet.leg)},
                {"row", tube.row},
                {"column", tube.column},
                {"name", tubesheets::tubeName(tube.row, tube.column)},
                {"hole", exactVector(planner::holeCentre(tube), units, dimension::kLength)},
                {"joints", jointValuesJson(visit.branch.q, outcome.cell)},
                {"predicted_tip", exactVector(visit.branch.predicted_tip_W, units, dimension::kLength)},
                {"centring_error", outcome.predicted[k].error / units.factor(dimension::kLength)},
                {"tilt", angleOf(visit.branch.tilt, units)},
                {"steps", expectedSteps(outcome, k)},
                {"approach_deviation", lengthOf(visit.branch.path_deviation, units)},
                {"probability_by_steps", chancesJson(outcome, k)}};
  if (!outcome.play.empty()) entry["play_in_tube"] = lengthOf(outcome.play[k], units);
  if (visit.dwell > 0) entry["dwell_s"] = visit.dwell;
  if (!outcome.zones.empty()) entry["zone"] = outcome.zones[k] + 1;
  if (!outcome.scores.empty()) entry["scored"] = modesJson(outcome.scores[k], units);
  return entry;
}

json unreachableJson(const PlanOutcome& outcome) {
  json list = json::array();
  for (const auto& missed : outcome.plan.unreachable) {
    const auto& tube = outcome.model.sheet.tubes[static_cast<std::size_t>(missed.tube)];
    json entry = {{"row", tube.row}, {"column", tube.column}, {"reason", missed.reason}};
    if (!missed.blocking.other.empty())
      entry["in_the_way"] = {{"body", missed.blocking.body},
                             {"other", missed.blocking.other},
                             {"distance", lengthOf(missed.blocking.distance, outcome.cell.units)}};
    list.push_back(entry);
  }
  return list;
}

json countsJson(const PlanOutcome& outcome) {
  if (outcome.scores.empty()) return nullptr;
  const auto counts = countByMode(outcome.scores, static_cast<int>(outcome.model.tool.steps.size()));
  json by_mode;
  for (std::size_t mode = 0; mode < kModeKeys.size(); ++mode) by_mode[kModeKeys[mode]] = counts[mode];
  return by_mode;
}

json sheetJson(const PlanOutcome& outcome) {
  const auto& sheet = outcome.model.sheet;
  return {{"name", sheet.name},
          {"leg", tubesheets::legName(sheet.leg)},
          {"viewed_from", tubesheets::viewedFromName(sheet.viewed_from)},
          {"hole_diameter", lengthOf(sheet.hole_diameter, outcome.cell.units)},
          {"pitch", lengthOf(sheet.pitch, outcome.cell.units)},
          {"rows", sheet.rows},
          {"columns", sheet.columns},
          {"holes", sheet.tubes.size()},
          {"fingerprint", sheet.fingerprint()}};
}

/// Returns the tube of a path segment as "hot,10,20" (leg, row, column), so that every row can be checked against the
/// operator's list.
std::string goalOf(const PlanOutcome& outcome, int segment) {
  const int visit = outcome.plan.segments[static_cast<std::size_t>(segment)].visit;
  const auto& sheet = outcome.model.sheet;
  const int index = visit < 0 ? outcome.plan.departed : outcome.plan.visits[static_cast<std::size_t>(visit)].tube;
  const auto& tube = sheet.tubes[static_cast<std::size_t>(index)];
  return fmt::format("{},{},{}", tubesheets::legName(sheet.leg), tube.row, tube.column);
}

/// Returns the fingerprint of the path rows as written to the file: time, segment and joint values.
std::string pathFingerprintOf(const PlanOutcome& outcome) {
  const Eigen::VectorXd factors = jointFactors(outcome.cell.arm, outcome.cell.units);
  PathNumbers numbers;
  for (const auto& row : planner::samplePath(outcome.plan, planner::jointSpeedsOf(outcome.model.arm)))
    numbers.add(row.time, row.segment + 1, row.q.cwiseQuotient(factors));
  return numbers.fingerprint();
}

/// Returns the kind of travel between tubes. For straight lines, also the number of lines and the deviation of the
/// deflected tip from the lines.
json travelJson(const PlanRequest& request, const planner::VisitPlan& plan, const Units& units) {
  json travel = {{"kind", request.travel}};
  if (request.travel != planner::nameOf(planner::TravelKind::kLine)) return travel;
  travel["on_line"] = plan.lines;
  travel["line_deviation"] = lengthJson(plan.line_deviation, units);
  return travel;
}

/// Returns the text of the cell with which the plan was made, including the calibrated base if there is one.
std::string calibratedText(const PlanOutcome& outcome, const std::filesystem::path& out) {
  if (!outcome.calibration) return cellTextAt(outcome.cell, out);
  const auto& base = outcome.calibration->flexible;
  return cellTextWithBase(
      outcome.cell, {base.X_WB, base.covariance, true, outcome.chances.model_error, outcome.touches, &base.arm}, out);
}

}  // namespace

int expectedSteps(const PlanOutcome& outcome, std::size_t k) {
  const auto& chances = outcome.chances.by_posture;
  return chances.empty() ? outcome.predicted[k].steps : likeliestSteps(chances[k]);
}

json planJson(const PlanRequest& request, const PlanOutcome& outcome) {
  const auto& plan = outcome.plan;
  json tubes = json::array();
  for (std::size_t k = 0; k < plan.visits.size(); ++k) tubes.push_back(tubeJson(outcome, k));
  json result = {
      {"version", kVersion},
      {"seed", request.seed},
      {"sentence", planAnswer(outcome)},
      {"cell", outcome.cell.name},
      {"compensation", planner::nameOf(outcome.compensation)},
      {"load", outcome.cell.units.toFile(outcome.model.load, dimension::kForce)},
      {"insertion", outcome.cell.units.toFile(outcome.model.insertion, dimension::kLength)},
      {"units", unitsJson(outcome.cell.units)},
      {"sheet", sheetJson(outcome)},
      {"tubes", tubes},
      {"unreachable", unreachableJson(outcome)},
      {"travel_time_s", plan.travel_time},
      {"lower_bound_s", plan.lower_bound},
      {"gap", plan.optimality_gap},
      {"row_by_row_time_s", plan.row_by_row_time},
      {"total_time_s", plan.total_time},
      {"detours", plan.detours},
      {"travel", travelJson(request, plan, outcome.cell.units)},
      {"min_clearance", lengthOf(minClearance(outcome), outcome.cell.units)},
      {"clearance_required", lengthOf(outcome.model.scene.clearance, outcome.cell.units)},
      {"tightest", tightestText(outcome)},
      {"warnings", outcome.cell.warnings},
      {"base", placedBaseJson(outcome.model.X_WB, outcome.standing(), outcome.cell.units)},
      {"counts", countsJson(outcome)},
      {"modes", modeWordsJson()},
      {"step_words", tubesheets::stepWords(outcome.model.tool)},
      {"steps_by", outcome.chances.by_posture.empty() ? "the model alone, taken as exact" : "the most probable"},
      {"probabilities", stepChancesJson(outcome.chances, outcome.cell.units)}};
  if (outcome.conditions.start) result["start"] = jointValuesJson(*outcome.conditions.start, outcome.cell);
  if (plan.departed >= 0) {
    const auto& tube = outcome.model.sheet.tubes[static_cast<std::size_t>(plan.departed)];
    result["start_at"] = {{"row", tube.row}, {"column", tube.column}};
  }
  if (outcome.conditions.end) result["end"] = jointValuesJson(*outcome.conditions.end, outcome.cell);
  if (!outcome.left_out.empty()) result["left_out"] = outcome.left_out;
  if (request.padding > 0)
    result["padding"] = {{"sigmas", request.padding},
                         {"added", outcome.padding / outcome.cell.units.factor(dimension::kLength)},
                         {"covers", outcome.model.row_deviations.empty() ? "base" : "base and arm"}};
  if (outcome.calibration) result["calibration"] = calibrationJson(outcome.calibration->flexible, outcome.cell);
  return result;
}

json planFileJson(const PlanRequest& request, const PlanOutcome& outcome) {
  json plan = planJson(request, outcome);
  plan["path_fingerprint"] = pathFingerprintOf(outcome);
  stateOrigin(plan);
  return plan;
}

std::string planFileText(const PlanRequest& request, const PlanOutcome& outcome) {
  return planFileJson(request, outcome).dump(1) + "\n";
}

std::string pathCsv(const PlanOutcome& outcome) {
  const Cell& cell = outcome.cell;
  const Eigen::VectorXd factors = jointFactors(cell.arm, cell.units);
  std::string text = "time_s,segment,kind";
  for (const auto& joint : cell.arm.joints()) text += "," + tubesheets::csvField(jointColumn(joint, cell.units));
  text += ",leg,row,column\n";
  for (const auto& row : planner::samplePath(outcome.plan, planner::jointSpeedsOf(outcome.model.arm))) {
    text += fmt::format("{},{},{}", row.time, row.segment + 1, planner::nameOf(row.kind));
    for (double q : row.q.cwiseQuotient(factors)) text += fmt::format(",{}", q);
    text += "," + goalOf(outcome, row.segment) + "\n";
  }
  return text;
}

void writePlan(const PlanRequest& request, const PlanOutcome& outcome, OutputFolder& folder) {
  // The origin of plan.json is that of the calling thread, so only the path is written by another.
  std::string path;
  oneapi::tbb::task_group tasks;
  tasks.run([&] { path = pathCsv(outcome); });
  const std::string plan = planFileText(request, outcome), report = renderPlanReport(reportJson(request, outcome));
  tasks.wait();
  folder.write("plan.json", plan);
  folder.write("path.csv", path);
  const auto cell_file = folder.path() / "cell.yaml";
  folder.write("cell.yaml", calibratedText(outcome, cell_file));
  if (!outcome.touches.empty())
    folder.write("touches.csv", touchesCsv(outcome.touches, outcome.cell));
  else if (std::filesystem::exists(folder.path() / "plan.json"))
    folder.remove("touches.csv");  // remove the file of an earlier plan
  folder.write(kWorkListFile, workListCsv(outcome));
  folder.write("report.html", report);
  folder.commit();
}

}  // namespace tubeplan::app
