// Routes of the base calibration: holes to touch, the list of touches, and the resulting base.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/documents/pose_json.hpp"
#include "app/documents/touch_proposals.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/formats/units.hpp"
#include "app/formats/units_json.hpp"
#include "app/jobs/calibration.hpp"
#include "app/jobs/touches.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/measurements/touched_holes.hpp"
#include "app/workbench/job_routes.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/routes.hpp"
#include "app/workbench/state_json.hpp"
#include "calibration/simulation/simulated_touch.hpp"
#include "planner/reach/compensation.hpp"
#include "tubesheets/csv_table.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

namespace {

constexpr std::size_t kMostTouches = 200;

Answer propose(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  TouchRequest touch_request;
  touch_request.goal = textOf(body, "goal", "base");
  if (touch_request.goal != "base" && touch_request.goal != "parameters" && touch_request.goal != "both")
    throw InputError("request (goal)", inQuotes(touch_request.goal), "base, parameters or both");
  touch_request.count = integerOf(body, "count", 0, 1, 50);
  const Session now = workbench.session();
  const Cell& cell = currentModel(now).cell;
  if (cell.sheet && body.contains("tubes"))
    touch_request.tubes = tubesText(body, *cell.sheet, tubesheets::spreadRequest(*cell.sheet, 60));
  if (body.contains("loads") && !body["loads"].is_null()) touch_request.loads = numbersOf(body, "loads");
  touch_request.seed = seedOf(body);
  return beginResultJob(workbench, "touches", "Holes to touch", JobInput::kModelAndMeasurements,
                        [touch_request](const Session& began, JobContext& context) {
                          beginStage(context, "proposals");
                          const auto outcome =
                              proposeTouches(touch_request, currentModel(began).cell,
                                             began.measurements ? measurementsInUse(*began.measurements)
                                                                : std::vector<calibration::Measurement>());
                          nlohmann::json figures = proposalsJson(outcome);
                          figures["seed"] = touch_request.seed;
                          figures["optimality"] = "D";
                          return figures;
                        });
}

/// Returns the first posture of the model whose tip is under the hole. Throws InputError if the arm does not reach the
/// hole.
Eigen::VectorXd postureUnder(const Cell& cell, int hole) {
  planner::CompensationOptions options;
  options.with_approach = false;
  const auto work = workcellOf(cell, "touch a hole");
  for (const auto& branch :
       planner::compensate(work, planner::holeCentre(work.sheet.tubes[static_cast<std::size_t>(hole)]), options))
    if (branch.status == deflection::BranchStatus::kConverged) return branch.q;
  const auto& tube = work.sheet.tubes[static_cast<std::size_t>(hole)];
  throw InputError::problem("request (hole)",
                            "the arm does not reach hole " + tubesheets::tubeName(tube.row, tube.column),
                            "choose another hole");
}

/// Returns a simulated touch: a measurement of the true arm, or of the opened cell's arm if no true arm is known.
calibration::Measurement simulatedTouch(const Session& now, const calibration::TouchPlan& plan, double load) {
  const Cell& model = currentModel(now).cell;
  const Cell truth = now.truth.empty() ? now.models.front()->cell : readCell(now.truth);
  calibration::TouchSimulationOptions options;
  options.sigma = touchSigmaOf(requireTool(model, "touch a hole"));
  options.load = load;
  options.seed = static_cast<std::uint64_t>(now.next_touch);
  const auto simulation = calibration::simulateTouches(truth.arm, truth.X_WB, {plan}, options);
  if (simulation.status != calibration::TouchSimulationStatus::kDone)
    throw InputError::problem("request (hole)", simulation.reason, "choose another hole");
  return simulation.touches.front();
}

Answer addTouch(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const Session now = workbench.session();
  const Cell& cell = currentModel(now).cell;
  if (now.touches.size() >= kMostTouches)
    return refusal(409,
                   InputError::problem("touches", fmt::format("the list is full, with {} touches", now.touches.size()),
                                       "remove a touch from the list first"));
  TouchMade made;
  made.tube = requiredHoleOf(body, cell);
  made.is_simulated = booleanOf(body, "simulate", !body.contains("joints"));
  const auto& tube = cell.sheet->tubes[static_cast<std::size_t>(made.tube)];
  calibration::TouchPlan plan{fmt::format("T{}", now.next_touch), tubesheets::tubeName(tube.row, tube.column),
                              planner::holeCentre(tube),
                              body.contains("joints") ? jointsOf(body, cell) : postureUnder(cell, made.tube)};
  const double load = loadOf(body, cell);
  if (made.is_simulated)
    made.touch = simulatedTouch(now, plan, load);
  else
    made.touch = calibration::plannedTouch(plan, plan.q_start, load, touchSigmaOf(requireTool(cell, "touch a hole")));
  workbench.change([&](Session& session) {
    session.touches.push_back(made);
    ++session.next_touch;
    return true;
  });
  return answerOf(stateJson(workbench));
}

Answer removeTouch(Workbench& workbench, const Request& request) {
  const auto index = tubesheets::parseNumber(request.words[1]);
  const bool done = workbench.change([&](Session& session) {
    const bool is_one = index && *index >= 0 && *index < static_cast<double>(session.touches.size());
    if (is_one) session.touches.erase(session.touches.begin() + static_cast<std::ptrdiff_t>(*index));
    return is_one;
  });
  if (!done)
    return refusal(404, InputError("touch", inQuotes(request.words[1]), "the index of a touch in the list, from 0"));
  return answerOf(stateJson(workbench));
}

Answer touches(Workbench& workbench, const Request&) {
  const Session now = workbench.session();
  const Cell& cell = currentModel(now).cell;
  nlohmann::json list = nlohmann::json::array();
  for (const auto& made : now.touches)
    list.push_back({{"id", made.touch.id},
                    {"hole", made.tube},
                    {"name", made.touch.point},
                    {"joints", jointValuesJson(made.touch.q, cell)},
                    {"load", cell.units.toFile(made.touch.load, dimension::kForce)},
                    {"sigma", lengthOf(made.touch.sigma, cell.units)},
                    {"simulated", made.is_simulated}});
  return answerOf({{"units", unitsJson(cell.units)}, {"touches", list}});
}

/// Returns the listed touches, or if there are none, the loaded touch measurements that are not set aside. The touches
/// are written as a measurement file and read again, so that the result equals that of `tubeplan calibrate`.
std::vector<calibration::Measurement> touchesToUse(const Session& session, const Cell& cell) {
  if (session.touches.empty() && session.measurements)
    return touchesOf(measurementsInUse(*session.measurements), cell, session.measurements->name);
  std::vector<calibration::Measurement> made;
  for (const auto& touch : session.touches) made.push_back(touch.touch);
  if (made.empty())
    throw InputError::problem("touches", "no hole has been touched yet", "touch at least three holes first");
  return touchesOf(parseMeasurementText(touchesCsv(made, cell), "touches.csv", cell), cell, "touches.csv");
}

/// Calibrates the base from the touches. If the touches do not determine the base, the model is unchanged and the
/// result document gives the reason.
Answer calibrate(Workbench& workbench, const Request& request) {
  (void)objectOf(request);
  return beginJob(workbench, "calibrate", "Calibration", [&workbench](JobContext& context) {
    const Session began = workbench.session();
    const Cell& cell = currentModel(began).cell;
    beginStage(context, "calibration");
    CalibrationOutcome outcome = calibrateCell(cell, touchesToUse(began, cell), "touches.csv");
    if (const auto simulated = std::ranges::count_if(began.touches, &TouchMade::is_simulated); simulated > 0)
      outcome.figures["warnings"].push_back(fmt::format(
          "{} of {} touches are simulated, not made: the base is a practice result", simulated, began.touches.size()));
    std::optional<Cell> calibrated;
    if (outcome.calibration.status == calibration::CalibrationStatus::kDone)
      calibrated = rereadCell(cell, calibratedCellText(cell, outcome, cell.path));
    finishJob(workbench, began, JobInput::kModel, [&, &document = outcome.figures](Session& session) {
      const int id =
          calibrated ? pushModel(session, "base calibrated", "calibration", *calibrated) : currentModel(session).id;
      putResult(session, "calibrate", id, document);
    });
    return "calibrate";
  });
}

constexpr Route kCalibrateRoutes[] = {
    {"POST", "touches", propose},       {"GET", "touches", touches},      {"POST", "touch", addTouch},
    {"DELETE", "touch/*", removeTouch}, {"POST", "calibrate", calibrate},
};

}  // namespace

std::span<const Route> calibrateRoutes() { return kCalibrateRoutes; }

}  // namespace tubeplan::app
