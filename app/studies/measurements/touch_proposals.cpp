#include "app/studies/measurements/touch_proposals.hpp"

#include <algorithm>
#include <numeric>

#include "app/studies/measurements/measurement_candidates.hpp"
#include "calibration/design/touch_choice.hpp"
#include "calibration/design/touch_reserve.hpp"
#include "calibration/estimation/base_calibration.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

namespace {

using calibration::Estimate, calibration::MeasurementCandidate;

constexpr int kTouchHoles = 60, kMeasurementPostures = 600, kWorkPostures = 60;
constexpr int kBaseTouches = 3, kMeasurements = 10;
// Largest number of holes for which all triples are compared; an exchange search is used for more.
constexpr int kExhaustive = 150;
constexpr int kNearestTried = 400;  // number of holes around the base that are tried to find the nearest three

/// Returns the three holes nearest to the base that can be touched and do not lie on a line.
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

/// Search for the proposals of one task.
class TouchSearch {
 public:
  explicit TouchSearch(const TouchTask& task) : task_(task) {}

  TouchProposals run() {
    findWork();
    if (work_.postures.empty()) return withoutWork();
    if (task_.of_base) proposeForBase();
    if (task_.of_numbers) proposeForNumbers();
    return std::move(result_);
  }

 private:
  /// Finds the postures in which the tip's uncertainty matters: at the holes of the work list, or at random if there is
  /// no sheet.
  void findWork() {
    if (task_.under_sheet) {
      for (const auto& hole : reachHoles(*task_.under_sheet, task_.tubes, false)) work_.postures.push_back(hole.q);
      result_.work_lost = static_cast<int>(task_.tubes.size() - work_.postures.size());
    } else {
      work_.postures = clearPostures(armAndScene(task_.cell), {0}, kWorkPostures, task_.seed + 1);
    }
    result_.work = static_cast<int>(work_.postures.size());
  }

  TouchProposals withoutWork() {
    const std::string reason = task_.under_sheet ? "no tube of the work list can be reached" : "no posture is clear";
    if (task_.of_base) result_.base.emplace().reason = reason;
    if (task_.of_numbers) result_.parameters.emplace().reason = reason;
    return std::move(result_);
  }

  [[nodiscard]] std::vector<int> spreadHoles() const {
    const int count = task_.candidates > 0 ? task_.candidates : kTouchHoles;
    const auto& sheet = task_.under_sheet->sheet;
    return tubesheets::selectTubes(sheet, tubesheets::spreadRequest(sheet, static_cast<std::size_t>(count)))
        .tube_indices;
  }

  /// Returns the holes that remain in reach for other likely poses of the uncalibrated base; all holes if too few
  /// remain.
  std::vector<ReachedHole> robustlyReached(const std::vector<ReachedHole>& holes, int count) {
    const auto& cell = *task_.under_sheet;
    std::vector<calibration::TouchPlan> plans;
    for (std::size_t k = 0; k < holes.size(); ++k)
      plans.push_back({std::to_string(k), "",
                       planner::holeCentre(cell.sheet.tubes[static_cast<std::size_t>(holes[k].tube)]), holes[k].q});
    std::vector<ReachedHole> kept;
    for (const auto& plan : calibration::robustlyTouchable(cell.arm, cell.X_WB, plans, count))
      kept.push_back(holes[std::stoul(plan.id)]);
    result_.holes = static_cast<int>(holes.size());
    result_.holes_uncertain = static_cast<int>(holes.size() - kept.size());
    return kept;
  }

  /// For a first calibration, without earlier measurements, returns the best `count` (three or more) of all holes.
  [[nodiscard]] static calibration::Design exhaustiveChoice(const calibration::DesignProblem& problem, int count) {
    const auto choice = calibration::chooseTouches(problem, count);
    if (choice.status == calibration::TouchChoiceStatus::kDone)
      return calibration::judgeMeasurements(problem, choice.chosen);
    calibration::Design none;
    none.status = calibration::DesignStatus::kTooFewCandidates;
    none.reason = choice.reason;
    return none;
  }

  void compareWithNearest() {
    const auto nearest = nearestHoles(*task_.under_sheet);
    if (nearest.size() < 3) return;
    const auto touches = holeTouches(*task_.under_sheet, nearest, task_.base_sigma);
    const auto posed = calibration::poseDesign(*task_.of_base, touches, work_);
    if (posed.candidates.size() < 3) return;
    for (const auto& touch : touches) result_.nearest_holes.push_back(touch.measurements.front().point);
    const auto design = calibration::judgeMeasurements(posed.problem, {0, 1, 2});
    result_.tip_nearest = calibration::tipSigma(posed.problem.work, design.covariance);
  }

  void proposeForBase() {
    auto& proposal = result_.base.emplace();
    const int count = task_.count > 0 ? task_.count : kBaseTouches;
    auto holes = reachHoles(*task_.under_sheet, spreadHoles(), false);
    if (task_.is_first) holes = robustlyReached(holes, count);
    proposal.candidates = holeTouches(*task_.under_sheet, holes, task_.base_sigma);
    const auto posed = calibration::poseDesign(*task_.of_base, proposal.candidates, work_);
    calibration::NextMeasurementsOptions options;
    options.seed = task_.seed;
    options.design.count = count;
    options.design.optimality = calibration::Optimality::kMeanTip;
    auto design = task_.is_first && holes.size() <= kExhaustive
                      ? exhaustiveChoice(posed.problem, count)
                      : calibration::chooseMeasurements(posed.problem, options.design);
    proposal.next = calibration::forecastMeasurements(*task_.of_base, posed, std::move(design), options);
    proposal.reason = proposal.next.reason;
    if (!task_.is_first) return;
    // Checks that a calibration with the chosen touches would not be refused.
    std::vector<calibration::Measurement> touches;
    for (const auto& step : proposal.next.design.steps)
      touches.push_back(calibration::conditionsOf(proposal.chosen(step).measurements.front()));
    if (proposal.reason.empty()) proposal.reason = calibration::findTouchProblem(touches);
    compareWithNearest();
  }

  [[nodiscard]] std::vector<MeasurementCandidate> touchesUnderLoads() const {
    std::vector<MeasurementCandidate> candidates;
    planner::Workcell loaded = *task_.under_sheet;
    for (const double load : task_.loads) {
      loaded.load = load;
      for (auto& touch : holeTouches(loaded, reachHoles(loaded, spreadHoles(), true), task_.sigma))
        candidates.push_back(std::move(touch));
    }
    return candidates;
  }

  /// Returns the possible measurements: holes or postures, each under every load.
  [[nodiscard]] std::vector<MeasurementCandidate> findCandidates() const {
    if (task_.by_touch && task_.under_sheet) return touchesUnderLoads();
    const int count = task_.candidates > 0 ? task_.candidates : kMeasurementPostures;
    const auto cell = armAndScene(task_.cell);
    const auto postures = clearPostures(cell, task_.loads, count, task_.seed);
    return task_.by_touch ? pointTouches(cell, postures, task_.loads, task_.sigma)
                          : positionMeasurements(postures, task_.loads, task_.sigma);
  }

  void proposeForNumbers() {
    auto& proposal = result_.parameters.emplace();
    proposal.candidates = findCandidates();
    calibration::NextMeasurementsOptions options;
    options.seed = task_.seed;
    options.design.count = task_.count > 0 ? task_.count : kMeasurements;
    options.design.optimality = task_.optimality;
    proposal.next = calibration::proposeMeasurements(*task_.of_numbers, proposal.candidates, work_, options);
    proposal.reason = proposal.next.reason;
  }

  const TouchTask& task_;
  calibration::Work work_;
  TouchProposals result_;
};

}  // namespace

TouchProposals proposeTouches(const TouchTask& task) { return TouchSearch(task).run(); }

}  // namespace tubeplan::app
