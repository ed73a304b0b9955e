#include "app/jobs/touch_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "app/documents/touch_outcome.hpp"
#include "app/files/command_inputs.hpp"
#include "app/files/input_error.hpp"
#include "app/files/workcell.hpp"
#include "app/jobs/cell_estimate.hpp"
#include "app/studies/measurements/reading_candidates.hpp"
#include "app/studies/measurements/touched_holes.hpp"
#include "calibration/design/touch_choice.hpp"
#include "calibration/design/touch_reserve.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::app {

namespace {

using calibration::Estimate, calibration::Measurement, calibration::ReadingCandidate;
using Proposal = TouchOutcome::Proposal;

constexpr int kTouchHoles = 60, kReadingPostures = 600, kWorkPostures = 60;
constexpr int kBaseTouches = 3, kReadings = 10;
constexpr int kExhaustive = 150;         // holes of which all triples are compared; exchange finds the best of more
constexpr int kNearestTried = 400;       // holes round the base, before the nearest three are given up
constexpr double kUsualSigma = 1.27e-4;  // m: 0.005 in, the centring of a calibration tool

/// One job under way.
struct Job {
  const TouchRequest& request;
  TouchOutcome& outcome;
  std::vector<Measurement> readings;
  std::optional<Estimate> of_numbers, of_base;
  std::optional<planner::Workcell> sheet_cell;  ///< of cells with a sheet
  calibration::Work work;
};

bool wants(const Job& job, const std::string& goal) { return job.request.goal == goal || job.request.goal == "both"; }

/// Median of what the readings of that sort have; 0 where there are none.
double medianSigma(const std::vector<Measurement>& readings, bool is_touch) {
  std::vector<double> sigmas;
  for (const auto& reading : readings)
    if (isTouch(reading) == is_touch) sigmas.push_back(reading.sigma);
  return sigmas.empty() ? 0 : calibration::median(std::move(sigmas));
}

/// The noise that a reading to come is taken to have.
ReadingNoise noiseOf(const Job& job, bool is_touch) {
  const Cell& cell = job.outcome.cell;
  if (job.request.sigma > 0) return {cell.units.toInternal(job.request.sigma, dimension::kLength), "--sigma"};
  if (const double median = medianSigma(job.readings, is_touch); median > 0) return {median, "the readings"};
  if (is_touch && cell.tool) return {touchSigmaOf(*cell.tool), "the calibration tool"};
  return {kUsualSigma, "usual; --sigma says otherwise"};
}

void settleLoads(Job& job) {
  std::set<double> loads;
  for (const double load : job.request.loads) {
    if (!std::isfinite(load) || load < 0)
      throw InputError("--loads", fmt::format("{}", load),
                       "finite weights in " + std::string(job.outcome.cell.units.force().name) + ", zero or more");
    loads.insert(job.outcome.cell.units.toInternal(load, dimension::kForce));
  }
  if (loads.empty())
    for (const auto& reading : job.readings) loads.insert(reading.load);
  if (loads.empty()) loads.insert(0);
  job.outcome.loads.assign(loads.begin(), loads.end());
}

/// Where the tip must be known: at the holes of the work list, or in random postures.
void findWork(Job& job) {
  auto& outcome = job.outcome;
  if (!job.sheet_cell) {
    if (outcome.cell.scene.bodies.empty())
      outcome.notes.push_back("the cell says nothing of its links' shapes: postures are not checked for collisions");
    job.work.postures = clearPostures(armAndScene(outcome.cell), {0}, kWorkPostures, job.request.seed + 1);
  } else {
    const auto tubes =
        readTubes(job.request.tubes.empty() ? "spread:60" : job.request.tubes, job.sheet_cell->sheet).tube_indices;
    for (const auto& hole : reachHoles(*job.sheet_cell, tubes, false)) job.work.postures.push_back(hole.q);
    outcome.work_lost = static_cast<int>(tubes.size() - job.work.postures.size());
  }
  outcome.work = static_cast<int>(job.work.postures.size());
}

std::vector<int> spreadHoles(const Job& job) {
  const int count = job.request.candidates > 0 ? job.request.candidates : kTouchHoles;
  const auto& sheet = job.sheet_cell->sheet;
  return readTubes(tubesheets::spreadRequest(sheet, static_cast<std::size_t>(count)), sheet).tube_indices;
}

/// The three holes nearest the base that can be touched and are not on a line.
std::vector<ReachedHole> nearestHoles(const planner::Workcell& cell) {
  std::vector<int> order(cell.sheet.tubes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](int tube) { return planner::holeCentre(cell.sheet.tubes[static_cast<std::size_t>(tube)]); };
  const auto distance = [&](int tube) { return (place(tube) - cell.X_WB.translation()).head<2>().norm(); };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return distance(a) < distance(b); });
  std::vector<ReachedHole> nearest;
  for (std::size_t k = 0; k < order.size() && k < kNearestTried && nearest.size() < 3; ++k) {
    const auto reached = reachHoles(cell, {order[k]}, false);
    if (reached.empty()) continue;
    nearest.push_back(reached.front());
    if (nearest.size() < 3) continue;
    const Eigen::Vector3d a = place(nearest[1].tube) - place(nearest[0].tube),
                          b = place(nearest[2].tube) - place(nearest[0].tube);
    if (a.cross(b).norm() < 0.1 * a.squaredNorm()) nearest.pop_back();
  }
  return nearest;
}

/// Holes still in reach where a base that nothing tells of yet stands otherwise than named; all, where too few are.
std::vector<ReachedHole> surelyReached(Job& job, const std::vector<ReachedHole>& holes, int count) {
  const auto& cell = *job.sheet_cell;
  std::vector<calibration::TouchPlan> plans;
  for (std::size_t k = 0; k < holes.size(); ++k)
    plans.push_back({std::to_string(k), "",
                     planner::holeCentre(cell.sheet.tubes[static_cast<std::size_t>(holes[k].tube)]), holes[k].q});
  std::vector<ReachedHole> kept;
  for (const auto& plan : calibration::keepTouchable(cell.arm, cell.X_WB, plans))
    kept.push_back(holes[std::stoul(plan.id)]);
  if (static_cast<int>(kept.size()) < count) return holes;
  if (kept.size() < holes.size())
    job.outcome.notes.push_back(fmt::format(
        "{} of {} holes are left out as touches for the base: where it stands otherwise they may be out of reach",
        holes.size() - kept.size(), holes.size()));
  return kept;
}

/// The best three (and more) of all, where no reading tells anything yet.
calibration::Design exhaustiveChoice(const Job& job, const Estimate& estimate, const std::vector<ReachedHole>& holes,
                                     const calibration::PosedDesign& posed, int count) {
  std::vector<calibration::TouchPlan> plans;
  for (const int k : posed.candidates) plans.push_back({"", "", {}, holes[static_cast<std::size_t>(k)].q});
  const auto placed = calibration::placedAsEstimated(estimate);
  const auto choice = calibration::chooseTouches(placed.arm, placed.base_poses.back().X_WB, plans, job.work.postures,
                                                 {count, job.outcome.base_noise.sigma});
  if (choice.status == calibration::TouchChoiceStatus::kDone)
    return calibration::judgeReadings(posed.problem, choice.chosen);
  calibration::Design none;
  none.status = calibration::DesignStatus::kTooFewCandidates;
  none.reason = choice.reason;
  return none;
}

void compareWithNearest(Job& job, const Estimate& estimate) {
  const auto nearest = nearestHoles(*job.sheet_cell);
  if (nearest.size() < 3) return;
  const auto touches = holeTouches(*job.sheet_cell, nearest, job.outcome.base_noise.sigma);
  const auto posed = calibration::poseDesign(estimate, touches, job.work);
  if (posed.candidates.size() < 3) return;
  for (const auto& touch : touches) job.outcome.nearest_holes.push_back(touch.readings.front().point);
  const auto design = calibration::judgeReadings(posed.problem, {0, 1, 2});
  job.outcome.tip_nearest = calibration::tipSigma(posed.problem.work, design.covariance);
}

void proposeForBase(Job& job) {
  auto& proposal = job.outcome.base.emplace();
  const int count = job.request.count > 0 ? job.request.count : kBaseTouches;
  if (count < 3) throw InputError("--count", std::to_string(count), "three or more touches to place a base");
  const Estimate& estimate = *job.of_base;
  const bool is_first = job.readings.empty();
  auto holes = reachHoles(*job.sheet_cell, spreadHoles(job), false);
  if (is_first) holes = surelyReached(job, holes, count);
  proposal.candidates = holeTouches(*job.sheet_cell, holes, job.outcome.base_noise.sigma);
  const auto posed = calibration::poseDesign(estimate, proposal.candidates, job.work);
  calibration::NextReadingsOptions options;
  options.seed = job.request.seed;
  options.design.count = count;
  options.design.optimality = calibration::Optimality::kMeanTip;
  auto design = is_first && holes.size() <= kExhaustive ? exhaustiveChoice(job, estimate, holes, posed, count)
                                                        : calibration::chooseReadings(posed.problem, options.design);
  proposal.next = calibration::forecastReadings(estimate, posed, std::move(design), options);
  proposal.reason = proposal.next.reason;
  if (is_first) compareWithNearest(job, estimate);
}

/// What could be read: holes or postures, each under each load.
std::vector<ReadingCandidate> findCandidates(const Job& job) {
  const auto& outcome = job.outcome;
  const int count = job.request.candidates > 0 ? job.request.candidates : kReadingPostures;
  if (job.request.kind == "touch" && job.sheet_cell) {
    std::vector<ReadingCandidate> candidates;
    planner::Workcell loaded = *job.sheet_cell;
    for (const double load : outcome.loads) {
      loaded.load = load;
      for (auto& touch : holeTouches(loaded, reachHoles(loaded, spreadHoles(job), true), outcome.noise.sigma))
        candidates.push_back(std::move(touch));
    }
    return candidates;
  }
  const auto cell = armAndScene(outcome.cell);
  if (job.request.kind == "position")
    return positionReadings(clearPostures(cell, outcome.loads, count, job.request.seed), outcome.loads,
                            outcome.noise.sigma);
  if (outcome.loads.size() < 2)
    throw InputError("--loads", fmt::format("{} load", outcome.loads.size()),
                     "two or more: a point that nobody measured tells something only when touched under several loads",
                     "say --loads=0,20 or --kind position");
  return pointTouches(cell, clearPostures(cell, outcome.loads, count, job.request.seed), outcome.loads,
                      outcome.noise.sigma);
}

void proposeForParameters(Job& job) {
  auto& proposal = job.outcome.parameters.emplace();
  proposal.candidates = findCandidates(job);
  calibration::NextReadingsOptions options;
  options.seed = job.request.seed;
  options.design.count = job.request.count > 0 ? job.request.count : kReadings;
  options.design.optimality = job.request.optimality;
  proposal.next = calibration::proposeReadings(*job.of_numbers, proposal.candidates, job.work, options);
  proposal.reason = proposal.next.reason;
}

/// New readings are made where the arm stands now.
std::string lastSetup(const Estimate& estimate) { return estimate.start.base_poses.back().setup; }

void noteEstimate(const Estimate& estimate, const Units& units, std::vector<std::string>& notes) {
  if (!estimate.note.empty())
    notes.push_back("the readings could not be fitted (" + estimate.note + "): the cell's own values stand in");
  if (estimate.model_error > 0)
    notes.push_back(fmt::format(
        "lack of fit: beyond the stated noise the model is off by {:.4g} {} in each coordinate, which counts "
        "as noise of every reading",
        estimate.model_error / units.factor(dimension::kLength), units.length().name));
  if (estimate.start.base_poses.size() > 1)
    notes.push_back("new readings belong to the last set-up, '" + lastSetup(estimate) + "'");
}

/// Learns from the readings what they tell, and stands the cell accordingly.
void learn(Job& job, const std::string& named_by) {
  auto& outcome = job.outcome;
  if (wants(job, "parameters")) {
    job.of_numbers = estimateOf(outcome.cell, job.readings,
                                {job.request.free, !outcome.cell.base_known, outcome.cell.priors}, named_by);
    noteEstimate(*job.of_numbers, outcome.cell.units, outcome.notes);
    outcome.setup = lastSetup(*job.of_numbers);
    outcome.cell = cellAsEstimated(outcome.cell, *job.of_numbers);
  }
  if (!wants(job, "base")) return;
  Cell unplaced = outcome.cell;
  unplaced.base_known = false;
  job.of_base = estimateOf(unplaced, job.readings, {{}, true}, named_by);
  if (wants(job, "parameters")) return;
  outcome.setup = lastSetup(*job.of_base);
  noteEstimate(*job.of_base, outcome.cell.units, outcome.notes);
  outcome.cell = cellAsEstimated(outcome.cell, *job.of_base);
}

void refuseWithoutWork(Job& job) {
  const std::string reason = job.sheet_cell ? "no tube of the work list can be reached" : "no posture is clear";
  if (wants(job, "base")) job.outcome.base.emplace().reason = reason;
  if (wants(job, "parameters")) job.outcome.parameters.emplace().reason = reason;
}

/// What is asked for where the request leaves it open.
TouchRequest completed(TouchRequest request, const Cell& cell) {
  if (!std::isfinite(request.sigma) || request.sigma < 0)
    throw InputError("--sigma", fmt::format("{}", request.sigma),
                     "a noise above zero, in " + std::string(cell.units.length().name));
  const bool frees = !request.free.empty() || !cell.identify.empty();
  if (request.free.empty()) request.free = cell.identify;
  if (request.kind.empty()) request.kind = cell.sheet ? "touch" : "position";
  if (request.goal.empty()) request.goal = !cell.sheet ? "parameters" : frees ? "both" : "base";
  if (request.goal != "base" && !frees && cell.base_known)
    throw InputError(cell.path, "no free parameter", "a list `identify`, or --free NAME",
                     "`tubeplan touches --help` says what may be freed");
  if (request.goal != "parameters") (void)requireSheet(cell, "choose holes to touch for the base");
  if (!request.tubes.empty()) (void)requireSheet(cell, "choose --tubes");
  return request;
}

}  // namespace

TouchOutcome proposeTouches(const TouchRequest& asked) {
  Cell cell = readCell(asked.cell);
  const TouchRequest request = completed(asked, cell);
  const auto made =
      readingsMade(request.readings, cell, cell.units.toInternal(request.sigma, dimension::kLength), request.assume);
  TouchOutcome outcome = proposeTouches(asked, cell, made.readings);
  outcome.checks = made.checks;
  return outcome;
}

TouchOutcome proposeTouches(const TouchRequest& asked, const Cell& cell, const std::vector<Measurement>& readings) {
  TouchOutcome outcome;
  outcome.cell = cell;
  const TouchRequest request = completed(asked, outcome.cell);
  Job job{request, outcome, readings, {}, {}, {}, {}};
  outcome.noise = noiseOf(job, request.kind == "touch");
  outcome.base_noise = noiseOf(job, true);
  settleLoads(job);
  learn(job, asked.free.empty() ? outcome.cell.path + " (identify)" : "--free");
  if (outcome.cell.sheet) job.sheet_cell = workcellOf(outcome.cell, "find holes to touch");
  findWork(job);
  if (job.work.postures.empty())
    refuseWithoutWork(job);
  else {
    if (wants(job, "base")) proposeForBase(job);
    if (wants(job, "parameters")) proposeForParameters(job);
  }
  return outcome;
}

}  // namespace tubeplan::app
