#include "app/jobs/touches.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "app/documents/touch_outcome.hpp"
#include "app/formats/cell/command_inputs.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/jobs/cell_estimate.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/measurements/touched_holes.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::app {

namespace {

using calibration::Estimate, calibration::Measurement;

constexpr double kUsualSigma = 1.27e-4;  // default noise [m] (0.005 in): centring tolerance of a calibration tool

bool isGoal(const TouchRequest& request, const std::string& goal) {
  return request.goal == goal || request.goal == "both";
}

/// Returns the median sigma of the touches (`is_touch`), or of all other measurements [m]; 0 if there are none.
double medianSigma(const std::vector<Measurement>& measurements, bool is_touch) {
  std::vector<double> sigmas;
  for (const auto& measurement : measurements)
    if (isTouch(measurement) == is_touch) sigmas.push_back(measurement.sigma);
  return sigmas.empty() ? 0 : calibration::median(std::move(sigmas));
}

/// Returns the noise assumed for a future touch (`is_touch`) or other measurement, with its source.
MeasurementNoise noiseOf(const TouchRequest& request, const Cell& cell, const std::vector<Measurement>& measurements,
                         bool is_touch) {
  if (request.sigma > 0) return {cell.units.toInternal(request.sigma, dimension::kLength), "--sigma"};
  if (const double median = medianSigma(measurements, is_touch); median > 0) return {median, "the readings"};
  if (is_touch && cell.tool) return {touchSigmaOf(*cell.tool), "the calibration tool"};
  return {kUsualSigma, "default; --sigma changes it"};
}

/// Returns the requested loads, else the loads of the measurements, else zero load [N]; sorted and without duplicates.
std::vector<double> loadsOf(const TouchRequest& request, const Cell& cell,
                            const std::vector<Measurement>& measurements) {
  std::set<double> loads;
  for (const double load : request.loads) {
    if (!std::isfinite(load) || load < 0)
      throw InputError("--loads", fmt::format("{}", load),
                       "a weight of zero or more, in " + std::string(cell.units.force().name));
    loads.insert(cell.units.toInternal(load, dimension::kForce));
  }
  if (loads.empty())
    for (const auto& measurement : measurements) loads.insert(measurement.load);
  if (loads.empty()) loads.insert(0);
  return {loads.begin(), loads.end()};
}

/// Returns the set-up of the latest measurements, to which new measurements will belong.
std::string lastSetup(const Estimate& estimate) { return estimate.start.base_poses.back().setup; }

/// Adds notes on a failed fit, lack of fit and several set-ups. `known` is the model error that the cell states [m].
void noteEstimate(const Estimate& estimate, double known, const Units& units, std::vector<std::string>& notes) {
  if (!estimate.note.empty())
    notes.push_back("the readings could not be fitted (" + estimate.note + "): the cell's values are used instead");
  if (estimate.model_error > known)
    notes.push_back(
        fmt::format("lack of fit: the model error in each coordinate is {:.4g} {} beyond the stated noise; it is added "
                    "to the noise of every reading",
                    estimate.model_error / units.factor(dimension::kLength), units.length().name));
  if (estimate.start.base_poses.size() > 1)
    notes.push_back("new readings belong to the last set-up, '" + lastSetup(estimate) + "'");
}

/// Adds the estimates from the measurements to the task, and puts the estimated arm and base into the outcome's cell.
void learn(const TouchRequest& request, const std::vector<Measurement>& measurements, const std::string& named_by,
           TouchTask& task, TouchOutcome& outcome) {
  if (isGoal(request, "parameters")) {
    task.of_numbers =
        estimateOf(outcome.cell, measurements, {request.free, !outcome.cell.base_known, outcome.cell.priors}, named_by);
    noteEstimate(*task.of_numbers, 0, outcome.cell.units, outcome.notes);
    outcome.setup = lastSetup(*task.of_numbers);
    outcome.cell = cellAsEstimated(outcome.cell, *task.of_numbers);
  }
  if (!isGoal(request, "base")) return;
  Cell unplaced = outcome.cell;
  unplaced.base_known = false;
  if (!measurements.empty() && !isGoal(request, "parameters")) unplaced.arm = unplaced.filedArm();
  const calibration::AdditionalUncertainty additional = additionalUncertainty(unplaced);
  task.of_base = estimateOf(unplaced, measurements, {{}, true}, named_by, additional);
  if (isGoal(request, "parameters")) return;
  outcome.setup = lastSetup(*task.of_base);
  noteEstimate(*task.of_base, additional.model_error, outcome.cell.units, outcome.notes);
  outcome.cell = cellAsEstimated(outcome.cell, *task.of_base);
}

/// Returns the checked request with defaults filled in.
TouchRequest completed(TouchRequest request, const Cell& cell) {
  if (!std::isfinite(request.sigma) || request.sigma < 0)
    throw InputError("--sigma", fmt::format("{}", request.sigma),
                     "a noise above zero, in " + std::string(cell.units.length().name));
  const bool frees = !request.free.empty() || !cell.identify.empty();
  if (request.free.empty()) request.free = cell.identify;
  if (request.kind.empty()) request.kind = cell.sheet ? "touch" : "position";
  if (request.goal.empty()) request.goal = !cell.sheet ? "parameters" : frees ? "both" : "base";
  if (request.goal != "base" && !frees && cell.base_known)
    throw InputError::problem(cell.path, "no parameter is free",
                              "free one with a list `identify`, or --free NAME; `tubeplan touches --help` lists the "
                              "numbers that can be freed");
  if (request.goal != "parameters") (void)requireSheet(cell, "choose holes to touch for the base");
  if (!request.tubes.empty()) (void)requireSheet(cell, "choose --tubes");
  requireWorkList(request.columns, {request.tubes});
  return request;
}

void requireEnough(const TouchRequest& request, const TouchOutcome& outcome) {
  if (isGoal(request, "base") && request.count > 0 && request.count < 3)
    throw InputError("--count", std::to_string(request.count), "three or more touches to place a base");
  const bool needs_loads = isGoal(request, "parameters") && request.kind == "touch" && !outcome.cell.sheet;
  if (needs_loads && outcome.loads.size() < 2)
    throw InputError(
        "--loads", fmt::format("{} load", outcome.loads.size()),
        "two or more, because a point of unknown position is informative only when touched under several loads",
        "give --loads=0,20 or --kind position");
}

/// Copies the options of the request to the task and, for a cell with a sheet, sets the workcell and the tubes of the
/// work list.
void settleTask(const TouchRequest& request, TouchTask& task, TouchOutcome& outcome) {
  task.cell = outcome.cell;
  task.by_touch = request.kind == "touch";
  task.base_sigma = outcome.base_noise.sigma;
  task.sigma = outcome.noise.sigma;
  task.loads = outcome.loads;
  task.count = request.count;
  task.candidates = request.candidates;
  task.optimality = request.optimality;
  task.seed = request.seed;
  if (!outcome.cell.sheet) {
    if (outcome.cell.scene.bodies.empty())
      outcome.notes.push_back("the cell has no link shapes: postures are not checked for collisions");
    return;
  }
  task.under_sheet = workcellOf(outcome.cell, "find holes to touch");
  const auto& sheet = task.under_sheet->sheet;
  auto selection = readTubes(tubesOrSpread(request.tubes, sheet, 60), sheet, request.columns);
  for (auto& note : listNotes(selection)) outcome.notes.push_back(std::move(note));
  task.tubes = std::move(selection.tube_indices);
}

}  // namespace

TouchOutcome proposeTouches(const TouchRequest& stated_request) {
  Cell cell = readCell(stated_request.cell);
  const TouchRequest request = completed(stated_request, cell);
  const auto made = measurementsMade(request.measurements, cell,
                                     cell.units.toInternal(request.sigma, dimension::kLength), request.assume);
  TouchOutcome outcome = proposeTouches(stated_request, cell, made.measurements);
  outcome.checks = made.checks;
  return outcome;
}

TouchOutcome proposeTouches(const TouchRequest& stated_request, const Cell& cell,
                            const std::vector<Measurement>& measurements) {
  TouchOutcome outcome;
  outcome.cell = cell;
  const TouchRequest request = completed(stated_request, cell);
  outcome.noise = noiseOf(request, cell, measurements, request.kind == "touch");
  outcome.base_noise = noiseOf(request, cell, measurements, true);
  outcome.loads = loadsOf(request, cell, measurements);
  requireEnough(request, outcome);
  TouchTask task;
  task.is_first = measurements.empty();
  learn(request, measurements, stated_request.free.empty() ? cell.path + " (identify)" : "--free", task, outcome);
  settleTask(request, task, outcome);
  static_cast<TouchProposals&>(outcome) = proposeTouches(task);
  if (outcome.holes_uncertain > 0)
    outcome.notes.push_back(fmt::format(
        "{} of {} holes are excluded as touches for the base: they may be out of reach if the base is elsewhere",
        outcome.holes_uncertain, outcome.holes));
  return outcome;
}

}  // namespace tubeplan::app
