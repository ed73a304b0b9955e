#include "app/studies/measurements/measurement_candidates.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cmath>
#include <deque>
#include <optional>

#include "planner/reach/tube_reach.hpp"

namespace tubeplan::app {

namespace {

using calibration::MeasurementKind, calibration::ProposedMeasurement, calibration::MeasurementCandidate;
using Eigen::VectorXd;

constexpr int kTriesPerPosture = 40;  // maximum number of random attempts per requested posture
// Largest distance from a limit for a joint near its limit, as a fraction of the joint's range.
constexpr double kNearLimits = 0.02;
constexpr double kSamePlace = 1e-7;  // largest position error when a point is touched under another load [m]

VectorXd drawPosture(const deflection::Arm& arm, PostureChoice choice, boost::random::mt19937_64& random) {
  VectorXd q(arm.jointCount());
  for (Eigen::Index k = 0; k < arm.jointCount(); ++k) {
    const auto [lower, upper] = deflection::rangeOf(arm, arm.joint(k));
    const double within = choice == PostureChoice::kNearLimits ? kNearLimits * (upper - lower) : 0;
    q[k] = boost::random::uniform_real_distribution<double>(lower + within, upper - within)(random);
    // With equal probability, each joint keeps the drawn value or moves near its lower or its upper limit.
    if (choice != PostureChoice::kNearLimits) continue;
    const int where = boost::random::uniform_int_distribution<int>(0, 2)(random);
    if (where > 0) q[k] = where == 1 ? lower + within : upper - within;
  }
  return q;
}

/// Clearance checks of postures under several loads.
class ClearUnderLoads {
 public:
  ClearUnderLoads(const planner::Workcell& cell, const std::vector<double>& loads) : cells_(loads.size(), cell) {
    for (std::size_t k = 0; k < loads.size(); ++k) {
      cells_[k].load = loads[k];
      clearances_.emplace_back(cells_[k]);
    }
  }

  [[nodiscard]] bool at(const VectorXd& q, std::size_t load) const {
    return clearances_[load].at(q, planner::ContactRule::kTravel).margin >= 0;
  }
  [[nodiscard]] bool atAll(const VectorXd& q) const {
    for (std::size_t k = 0; k < clearances_.size(); ++k)
      if (!at(q, k)) return false;
    return true;
  }
  [[nodiscard]] const planner::Workcell& cell(std::size_t load) const { return cells_[load]; }

 private:
  std::vector<planner::Workcell> cells_;  // must outlive `clearances_`
  std::deque<planner::ArmClearance> clearances_;
};

ProposedMeasurement measurementOf(MeasurementKind kind, const VectorXd& q, double load, double sigma) {
  ProposedMeasurement measurement;
  measurement.kind = kind;
  measurement.q = q;
  measurement.load = load;
  measurement.sigma = sigma;
  return measurement;
}

/// Returns joint values near `near` that bring the tip to `goal` under the load of `cell`; std::nullopt if there are
/// none.
std::optional<VectorXd> touchAgain(const planner::Workcell& cell, const deflection::ToolGoal& goal,
                                   const VectorXd& near) {
  const auto branch =
      deflection::refineBranch(cell.arm, goal, cell.load, deflection::gravityInBase(cell.arm, cell.X_WB), near);
  if (branch.status != deflection::BranchStatus::kConverged || branch.position_error > kSamePlace) return std::nullopt;
  return branch.q;
}

std::optional<MeasurementCandidate> touchPoint(const ClearUnderLoads& clear, const VectorXd& q, std::size_t loads,
                                               double sigma) {
  const auto& first = clear.cell(0);
  const auto shape = deflection::solveFlexibleKinematics(
      first.arm, {q, first.load, deflection::gravityInBase(first.arm, first.X_WB)}, {1e-13, 100});
  const deflection::ToolGoal goal{shape.X_BD.p, shape.X_BD.R * first.arm.tool_axis_L};
  MeasurementCandidate candidate;
  for (std::size_t k = 0; k < loads; ++k) {
    const auto again = touchAgain(clear.cell(k), goal, q);
    if (!again || !clear.at(*again, k)) return std::nullopt;
    candidate.measurements.push_back(measurementOf(MeasurementKind::kTouch, *again, clear.cell(k).load, sigma));
  }
  return candidate;
}

}  // namespace

planner::Workcell armAndScene(const CellModel& cell) {
  planner::Workcell work;
  work.arm = cell.arm;
  work.X_WB = cell.X_WB;
  work.scene = cell.scene;
  // If the default tool axis coincides with the last joint's axis, the last joint cannot turn it, and a goal for its
  // direction would leave the last joint free. Use the direction to the tip instead.
  if (!cell.tool_axis_stated && cell.arm.p_LT.norm() > 0) work.arm.tool_axis_L = cell.arm.p_LT.normalized();
  return work;
}

std::vector<ReachedHole> reachHoles(const planner::Workcell& cell, const std::vector<int>& tubes, bool all_branches) {
  const planner::ArmClearance clearance(cell);
  std::vector<planner::TubeReach> reaches(tubes.size());
  oneapi::tbb::parallel_for(std::size_t{0}, tubes.size(),
                            [&](std::size_t k) { reaches[k] = planner::reachTube(clearance, tubes[k]); });
  std::vector<ReachedHole> holes;
  for (const auto& reach : reaches)
    for (const auto& branch : reach.branches) {
      holes.push_back({reach.tube, branch.q});
      if (!all_branches) break;
    }
  return holes;
}

std::vector<VectorXd> clearPostures(planner::Workcell cell, const std::vector<double>& loads, int count,
                                    std::uint64_t seed, const PostureQuestion& is_allowed, PostureChoice choice) {
  const ClearUnderLoads clear(cell, loads);
  const auto isAllowed = [&](const VectorXd& q) {
    return !is_allowed || std::all_of(loads.begin(), loads.end(), [&](double load) { return is_allowed(q, load); });
  };
  boost::random::mt19937_64 random(seed);
  std::vector<VectorXd> found;
  for (int round = 0; round < kTriesPerPosture && static_cast<int>(found.size()) < count; ++round) {
    std::vector<VectorXd> drawn;
    for (int k = 0; k < count; ++k) drawn.push_back(drawPosture(cell.arm, choice, random));
    std::vector<char> is_clear(drawn.size());
    oneapi::tbb::parallel_for(std::size_t{0}, drawn.size(),
                              [&](std::size_t k) { is_clear[k] = clear.atAll(drawn[k]) && isAllowed(drawn[k]); });
    for (std::size_t k = 0; k < drawn.size() && static_cast<int>(found.size()) < count; ++k)
      if (is_clear[k]) found.push_back(drawn[k]);
  }
  return found;
}

std::vector<MeasurementCandidate> holeTouches(const planner::Workcell& cell, const std::vector<ReachedHole>& holes,
                                              double sigma) {
  std::vector<MeasurementCandidate> candidates;
  for (const auto& hole : holes) {
    const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(hole.tube)];
    ProposedMeasurement touch = measurementOf(MeasurementKind::kTouch, hole.q, cell.load, sigma);
    touch.point = tubesheets::tubeName(tube.row, tube.column);
    touch.known_W = planner::holeCentre(tube);
    candidates.push_back({{touch}});
  }
  return candidates;
}

std::vector<MeasurementCandidate> positionMeasurements(const std::vector<VectorXd>& postures,
                                                       const std::vector<double>& loads, double sigma) {
  std::vector<MeasurementCandidate> candidates;
  for (const auto& q : postures)
    for (const double load : loads) candidates.push_back({{measurementOf(MeasurementKind::kPosition, q, load, sigma)}});
  return candidates;
}

std::vector<MeasurementCandidate> pointTouches(planner::Workcell cell, const std::vector<VectorXd>& postures,
                                               const std::vector<double>& loads, double sigma) {
  const ClearUnderLoads clear(cell, loads);
  std::vector<std::optional<MeasurementCandidate>> touched(postures.size());
  oneapi::tbb::parallel_for(std::size_t{0}, postures.size(),
                            [&](std::size_t k) { touched[k] = touchPoint(clear, postures[k], loads.size(), sigma); });
  std::vector<MeasurementCandidate> candidates;
  for (auto& candidate : touched)
    if (candidate) candidates.push_back(std::move(*candidate));
  return candidates;
}

}  // namespace tubeplan::app
