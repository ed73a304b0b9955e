#include "app/workbench/reach_jobs.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/formats/cell/workcell.hpp"
#include "app/formats/units.hpp"
#include "app/formats/units_json.hpp"
#include "app/storage/input_error.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "planner/reach/scoring.hpp"
#include "planner/reach/tube_reach.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

/// Calls `work` for every hole in parallel. Each thread checks for cancellation before its next hole.
void forAllHoles(std::size_t count, const char* stage, JobContext& context,
                 const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> done = 0;
  beginStage(context, stage, 0, count);
  oneapi::tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
    if (context.stopRequested()) return;
    work(k);
    context.progress(stage, ++done, count);
  });
  if (context.stopRequested()) throw JobStopped{};
}

/// Returns the first posture that brings the tip under a hole; nullopt if there is none.
std::optional<Eigen::VectorXd> postureUnder(const planner::Workcell& work, std::size_t hole,
                                            planner::Compensation mode) {
  planner::CompensationOptions options;
  options.mode = mode;
  options.with_approach = false;
  for (const auto& branch : planner::compensate(work, planner::holeCentre(work.sheet.tubes[hole]), options))
    if (branch.status == deflection::BranchStatus::kConverged) return branch.q;
  return std::nullopt;
}

double sagOf(const planner::Workcell& work, std::size_t hole) {
  const auto q = postureUnder(work, hole, planner::Compensation::kGoalPoint);
  if (!q) return std::numeric_limits<double>::quiet_NaN();
  const auto shape =
      deflection::solveFlexibleKinematics(work.arm, {*q, work.load, deflection::gravityInBase(work.arm, work.X_WB)});
  return (shape.X_BD.p - shape.X_BT.p).norm();
}

/// Returns the lateral distance of the tip from the hole's centre; NaN if the arm does not reach the hole.
double centringOf(const planner::Workcell& model, const std::optional<planner::Workcell>& truth, std::size_t hole) {
  const auto mode = truth ? planner::Compensation::kGoalPoint : planner::Compensation::kNone;
  const auto q = postureUnder(model, hole, mode);
  if (!q) return std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d off =
      planner::predictTip(truth ? *truth : model, *q).p_WT - planner::holeCentre(model.sheet.tubes[hole]);
  return off.head<2>().norm();
}

std::vector<double> residuals(const Session& session, const tubesheets::Sheet& sheet) {
  std::vector<double> values(sheet.tubes.size(), std::numeric_limits<double>::quiet_NaN());
  const Cell& cell = currentModel(session).cell;
  std::vector<calibration::Measurement> measurements;
  if (session.measurements) measurements = session.measurements->measurements;
  for (const auto& made : session.touches) measurements.push_back(made.touch);
  if (measurements.empty())
    throw InputError::problem("measurements", "no readings are loaded and no hole has been touched",
                              "touch some holes first");
  for (const auto& measurement : measurements) {
    const auto name = tubesheets::parseTubeName(measurement.point);
    const auto hole = name ? sheet.indexOf(name->row, name->column) : std::nullopt;
    if (!hole || !calibration::touchesKnownPoint(measurement)) continue;
    const auto tip = calibration::predictMeasurement(cell.arm, cell.X_WB, measurement);
    if (tip.ok) values[static_cast<std::size_t>(*hole)] = (tip.value - *measurement.p_W).norm();
  }
  return values;
}

std::string meaningOf(const std::string& of, bool with_truth) {
  if (of == "sag") return "deflection of the tip from the rigid arm's";
  if (of == "residual") return "distance of the model's tip from the touched hole";
  return with_truth ? "centring error of the true arm commanded by this model"
                    : "centring error of this model commanded by rigid kinematics";
}

}  // namespace

void requireField(const std::string& of) {
  if (of != "centring" && of != "residual" && of != "sag")
    throw InputError("request (of)", inQuotes(of), "centring, residual or sag");
}

json reachOfAll(const Cell& cell, JobContext& context) {
  const auto work = workcellOf(cell, "reach its holes");
  const planner::ArmClearance clearance(work);
  const std::size_t count = work.sheet.tubes.size();
  std::vector<planner::TubeReach> reaches(count);
  forAllHoles(count, "reach", context,
              [&](std::size_t k) { reaches[k] = planner::reachTube(clearance, static_cast<int>(k)); });
  json reachable = json::array(), reason = json::array(), branches = json::array();
  for (const auto& reach : reaches) {
    reachable.push_back(reach.status == planner::ReachStatus::kReachable ? 1 : 0);
    reason.push_back(reach.reason);
    branches.push_back(reach.branches.size());
  }
  return {{"reachable", reachable}, {"reason", reason}, {"branches", branches}};
}

json fieldOf(const Session& session, const std::string& of, JobContext& context) {
  requireField(of);
  const Cell& cell = currentModel(session).cell;
  const auto work = workcellOf(cell, "show its holes");
  std::optional<planner::Workcell> truth;
  if (!session.truth.empty()) truth = workcellOf(readCell(session.truth), "compare the model with it");
  std::vector<double> values(work.sheet.tubes.size(), std::numeric_limits<double>::quiet_NaN());
  if (of == "residual")
    values = residuals(session, work.sheet);
  else
    forAllHoles(values.size(), "field", context,
                [&](std::size_t k) { values[k] = of == "sag" ? sagOf(work, k) : centringOf(work, truth, k); });
  json figures = json::array(), steps = json::array();
  for (const double value : values) {
    figures.push_back(std::isfinite(value) ? json(lengthOf(value, cell.units)) : json());
    steps.push_back(std::isfinite(value) ? tubesheets::stepsInserted(work.tool, value) : -1);
  }
  json field = {{"of", of},
                {"meaning", meaningOf(of, truth.has_value())},
                {"unit", cell.units.length().name},
                {"units", unitsJson(cell.units)},
                {"values", figures}};
  if (of == "centring") field["steps"] = steps;
  return field;
}

}  // namespace tubeplan::app
