// Data for report.html, in file units.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/base_verdict.hpp"
#include "app/documents/calibration_json.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/plan_files.hpp"
#include "app/documents/sheet_json.hpp"
#include "app/documents/step_chances_json.hpp"
#include "app/formats/units.hpp"
#include "app/formats/units_json.hpp"
#include "app/storage/count_text.hpp"
#include "app/storage/origin.hpp"
#include "deflection/flexible_kinematics.hpp"
#include "planner/scene/scene_shapes.hpp"

namespace tubeplan::app {

namespace {

using Eigen::Vector3d;
using nlohmann::json;

constexpr int kSideViews = 6;

json centringData(const std::optional<planner::Centring>& score, const Units& units) {
  if (!score) return nullptr;
  return {{"error", lengthOf(score->error, units)},
          {"dx", lengthOf(score->offset.x(), units)},
          {"dy", lengthOf(score->offset.y(), units)},
          {"steps", score->steps},
          {"approach_deviation", lengthOf(score->approach_deviation, units)}};
}

json tubesData(const PlanOutcome& outcome) {
  const Units& units = outcome.cell.units;
  json tubes = json::array();
  for (std::size_t k = 0; k < outcome.plan.visits.size(); ++k) {
    const auto& visit = outcome.plan.visits[k];
    const auto& tube = outcome.model.sheet.tubes[static_cast<std::size_t>(visit.tube)];
    json entry = {{"order", k + 1},
                  {"row", tube.row},
                  {"column", tube.column},
                  {"x", lengthOf(tube.x, units)},
                  {"y", lengthOf(tube.y, units)},
                  {"tilt", angleOf(visit.branch.tilt, units)},
                  {"predicted_error", lengthOf(outcome.predicted[k].error, units)},
                  {"steps", expectedSteps(outcome, k)},
                  {"probability_by_steps",
                   outcome.chances.by_posture.empty() ? json(nullptr) : json(outcome.chances.by_posture[k])}};
    if (visit.dwell > 0) entry["dwell_s"] = visit.dwell;
    for (std::size_t mode = 0; mode < kModeKeys.size(); ++mode)
      entry[kModeKeys[mode]] = outcome.scores.empty() ? json(nullptr) : centringData(outcome.scores[k][mode], units);
    tubes.push_back(entry);
  }
  return tubes;
}

json unreachableData(const PlanOutcome& outcome) {
  json list = json::array();
  for (const auto& missed : outcome.plan.unreachable) {
    const auto& tube = outcome.model.sheet.tubes[static_cast<std::size_t>(missed.tube)];
    list.push_back({{"row", tube.row},
                    {"column", tube.column},
                    {"x", lengthOf(tube.x, outcome.cell.units)},
                    {"y", lengthOf(tube.y, outcome.cell.units)},
                    {"reason", missed.reason}});
  }
  return list;
}

json tourData(const PlanOutcome& outcome, const std::vector<planner::PathRow>& path) {
  json tour = json::array();
  for (const auto& row : path) {
    const Vector3d tip = planner::predictTip(outcome.model, row.q).p_WT;
    tour.push_back({lengthOf(tip.x(), outcome.cell.units), lengthOf(tip.y(), outcome.cell.units)});
  }
  return tour;
}

json touchesData(const PlanOutcome& outcome) {
  if (!outcome.calibration) return nullptr;
  const Units& units = outcome.cell.units;
  json list = json::array();
  for (std::size_t k = 0; k < outcome.touches.size(); ++k) {
    const auto& touch = outcome.touches[k];
    const auto& residual = outcome.calibration->flexible.residuals[k];
    const auto name = tubesheets::parseTubeName(touch.point);
    list.push_back({{"id", touch.id},
                    {"hole", touch.point},
                    {"row", name ? name->row : 0},
                    {"column", name ? name->column : 0},
                    {"x", lengthOf(touch.p_W->x(), units)},
                    {"y", lengthOf(touch.p_W->y(), units)},
                    {"residual", vectorJson(residual.residual_W, units, dimension::kLength)},
                    {"sigma", vectorJson(residual.sigma_W, units, dimension::kLength)}});
  }
  return list;
}

/// Vertical plane of a side view, through the axis of the first joint; `outwards` is the horizontal direction to the
/// tip.
struct SidePlane {
  Vector3d origin, outwards;
  json at(const Vector3d& p_W, const Units& units) const {
    return {lengthOf((p_W - origin).dot(outwards), units), lengthOf(p_W.z(), units)};
  }
};

json chainData(const PlanOutcome& outcome, const deflection::FlexibleKinematics& shape, bool rigid,
               const SidePlane& plane) {
  json chain = json::array();
  const auto add = [&](const Vector3d& p_B) {
    chain.push_back(plane.at(outcome.model.X_WB * p_B, outcome.cell.units));
  };
  for (const auto& row : shape.rows) add(rigid ? row.X_BL_rigid.p : row.X_BL.p);
  add(rigid ? shape.X_BT.p : shape.X_BD.p);
  return chain;
}

json sideView(const PlanOutcome& outcome, std::size_t k) {
  const auto& visit = outcome.plan.visits[k];
  const auto& cell = outcome.model;
  const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(visit.tube)];
  const auto shape = deflection::solveFlexibleKinematics(
      cell.arm, {visit.branch.q, cell.load, deflection::gravityInBase(cell.arm, cell.X_WB)});
  const auto first = static_cast<std::size_t>(deflection::activeRows(cell.arm).front());
  SidePlane plane;
  plane.origin = cell.X_WB * shape.rows[first].X_BL.p;
  plane.outwards = cell.X_WB * shape.X_BD.p - plane.origin;
  plane.outwards.z() = 0;
  plane.outwards.normalize();
  const auto frames = deflection::rowFramesInWorld(shape, cell.X_WB);
  json shapes = json::array();
  for (const auto& body : cell.scene.bodies) {
    const auto& capsule = static_cast<const planner::Solid&>(*body.shape).around();
    const auto& X_WL = frames[static_cast<std::size_t>(body.frame_index)];
    shapes.push_back({{"from", plane.at(X_WL * capsule.from, outcome.cell.units)},
                      {"to", plane.at(X_WL * capsule.to, outcome.cell.units)},
                      {"radius", lengthOf(capsule.radius, outcome.cell.units)}});
  }
  // Each plane cuts the sphere of the bowl differently, so the page draws the cut from the sphere's centre and radius.
  return {{"label", "R" + std::to_string(tube.row) + " C" + std::to_string(tube.column)},
          {"rigid", chainData(outcome, shape, true, plane)},
          {"flexible", chainData(outcome, shape, false, plane)},
          {"shapes", shapes},
          {"hole", plane.at(planner::holeCentre(tube), outcome.cell.units)},
          {"world_centre", plane.at(Vector3d::Zero(), outcome.cell.units)},
          {"centre_aside", lengthOf(std::abs(plane.origin.cross(plane.outwards).z()), outcome.cell.units)}};
}

/// Returns side views of some visits, spread evenly over the tour.
json sideViews(const PlanOutcome& outcome) {
  json views = json::array();
  const std::size_t count = outcome.plan.visits.size();
  const std::size_t shown = std::min<std::size_t>(kSideViews, count);
  for (std::size_t k = 0; k < shown; ++k) views.push_back(sideView(outcome, k * count / shown));
  return views;
}

json clearanceData(const PlanOutcome& outcome, const std::vector<planner::PathRow>& path) {
  const planner::ArmClearance clearance(outcome.model);
  json curve = json::array();
  for (const auto& row : path) {
    const auto rule =
        row.kind == planner::SegmentKind::kTravel ? planner::ContactRule::kTravel : planner::ContactRule::kApproach;
    curve.push_back({rounded(row.time), lengthOf(clearance.at(row.q, rule).distance, outcome.cell.units)});
  }
  return curve;
}

/// Returns the radius of the first obstacle that is the inside of a sphere, to be drawn as the boundary of the side
/// views; null if there is none.
json bowlRadius(const PlanOutcome& outcome) {
  const YamlNode* scene = outcome.cell.source.root.find("scene");
  if (!scene) return nullptr;
  for (const auto& obstacle : scene->items)
    if (const auto* inside = obstacle.find("inside_of"))
      if (const auto* sphere = inside->find("sphere"))
        if (const auto* radius = sphere->find("radius")) return radius->number();
  return nullptr;
}

json calibrationData(const PlanOutcome& outcome) {
  if (!outcome.calibration) return nullptr;
  json data = calibrationJson(outcome.calibration->flexible, outcome.cell);
  data["base_sigma"] = data["sigma"];
  return data;
}

/// Returns a string that states the mean and the largest centring error of a compensation mode over the scored tubes.
std::string errorText(const PlanOutcome& outcome, std::size_t mode) {
  double sum = 0, worst = 0;
  int count = 0;
  for (const auto& scores : outcome.scores)
    if (scores[mode]) {
      sum += scores[mode]->error;
      worst = std::max(worst, scores[mode]->error);
      ++count;
    }
  if (!count) return "not scored";
  const Units& units = outcome.cell.units;
  return fmt::format("{} mean, {} worst", lengthText(sum / count, units, 3), lengthText(worst, units, 3));
}

/// Returns a string that states, for each number of steps, in how many tubes it is expected to enter, and the
/// uncertainties considered.
std::string chancesText(const PlanOutcome& outcome) {
  std::string text;
  const auto counts = expectedCounts(outcome.chances);
  for (std::size_t k = 0; k < counts.size(); ++k)
    text += fmt::format("{} in {:.1f} tubes{}", countText(k, "step"), counts[k], k + 1 < counts.size() ? ", " : "; ");
  text += stepChancesText(outcome.chances, outcome.cell.units);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

json summaryData(const PlanOutcome& outcome) {
  const auto& plan = outcome.plan;
  const auto travels = std::count_if(plan.segments.begin(), plan.segments.end(),
                                     [](const auto& segment) { return segment.kind == planner::SegmentKind::kTravel; });
  json rows = json::array();
  rows.push_back(
      {"tubes planned", fmt::format("{} of {}", plan.visits.size(), plan.visits.size() + plan.unreachable.size())});
  if (!outcome.left_out.empty()) rows.push_back({"left out", outcome.left_out});
  rows.push_back({"compensation", planner::nameOf(outcome.compensation)});
  rows.push_back({"error without compensation", errorText(outcome, 0)});
  rows.push_back({"error with compensation", errorText(outcome, 2)});
  rows.push_back({"base", fmt::format("{}{}", nameOf(outcome.standing().placing),
                                      outcome.calibration ? fmt::format(", {} touches, rms {}", outcome.touches.size(),
                                                                        lengthText(outcome.calibration->flexible.rms,
                                                                                   outcome.cell.units))
                                                          : "")});
  for (const auto& warning : outcome.cell.warnings) rows.push_back({"warning", warning});
  if (outcome.calibration)
    for (const auto& warning : judgeBase(outcome.calibration->flexible, outcome.cell).warnings)
      rows.push_back({"warning", warning});
  rows.push_back({"steps, as predicted", chancesText(outcome)});
  if (plan.lines > 0)
    rows.push_back(
        {"travels with the tip on a straight line", fmt::format("{} of {}, within {} of it", plan.lines, travels,
                                                                lengthText(plan.line_deviation, outcome.cell.units))});
  rows.push_back({"whole path", fmt::format("{:.0f} s, {} detours", plan.total_time, plan.detours)});
  return rows;
}

}  // namespace

json reportJson(const PlanRequest& request, const PlanOutcome& outcome) {
  const Units& units = outcome.cell.units;
  auto path = planner::samplePath(outcome.plan, planner::jointSpeedsOf(outcome.model.arm), 1.);
  json steps = json::array();
  for (const auto& step : outcome.model.tool.steps)
    steps.push_back({{"diameter", lengthOf(step.diameter, units)}, {"tolerance", lengthOf(step.tolerance, units)}});
  const json plan = planJson(request, outcome);
  const json calibration = calibrationData(outcome);
  json report = {{"title", outcome.cell.name + ": plan of tube visits"},
                 {"sentence", plan["sentence"]},
                 {"cell", outcome.cell.name},
                 {"seed", request.seed},
                 {"base", plan["base"]},
                 {"units", unitsJson(units)},
                 {"sheet", sheetPageJson(outcome.model.sheet, outcome.cell)},
                 {"bowl_radius", bowlRadius(outcome)},
                 {"steps", steps},
                 {"tubes", tubesData(outcome)},
                 {"unreachable", unreachableData(outcome)},
                 {"tour", tourData(outcome, path)},
                 {"touches", touchesData(outcome)},
                 {"distances", calibration.is_null() ? json(nullptr) : calibration["distances"]},
                 {"calibration", calibration},
                 {"side_views", sideViews(outcome)},
                 {"counts", plan["counts"]},
                 {"modes", plan["modes"]},
                 {"step_words", plan["step_words"]},
                 {"times",
                  {{"travel_time_s", plan["travel_time_s"]},
                   {"lower_bound_s", plan["lower_bound_s"]},
                   {"gap", plan["gap"]},
                   {"row_by_row_time_s", plan["row_by_row_time_s"]}}},
                 {"min_clearance", plan["min_clearance"]},
                 {"clearance_required", plan["clearance_required"]},
                 {"tightest", plan["tightest"]},
                 {"clearance_along", clearanceData(outcome, path)},
                 {"summary", summaryData(outcome)}};
  stateOrigin(report);
  return report;
}

}  // namespace tubeplan::app
