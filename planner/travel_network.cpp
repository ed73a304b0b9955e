#include "planner/travel_network.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "deflection/inverse/inverse_solver.hpp"
#include "planner/motion/side_by_side.hpp"
#include "planner/reach/compensation.hpp"
#include "planner/timing/flowing_timing.hpp"

namespace tubeplan::planner {

namespace {

constexpr int kRoadmapPostures = 2400;  ///< largest number of roadmap postures that are standoffs of tubes
constexpr int kRoughShaping = 25;       // number of attempts to shape a detour when its time is only estimated

/// Returns the number of tubes, spread over the sheet, whose standoffs become postures of the roadmap.
std::size_t roadmapTubes(const deflection::Arm& arm, const deflection::InverseKinematicsOptions& options) {
  return static_cast<std::size_t>(std::max(1, kRoadmapPostures / std::max(1, deflection::mostBranches(arm, options))));
}

MotionPlan reversed(MotionPlan plan) {
  std::reverse(plan.waypoints.begin(), plan.waypoints.end());
  return plan;
}

/// Returns a seed for the travel between two tubes, so that its path is independent of the order of requests and of the
/// rest of the work list.
std::uint64_t pairSeed(std::uint64_t seed, TubePosture a, TubePosture b) {
  for (int part : {a.tube, a.branch, b.tube, b.branch})
    seed = (seed ^ static_cast<std::uint64_t>(part + 1)) * 0x9E3779B97F4A7C15ULL;
  return seed;
}

}  // namespace

MotionProblem travelProblemOf(const PlanContext& context) {
  MotionProblem problem;
  const auto& arm = context.cell.arm;
  problem.lower.resize(arm.jointCount());
  problem.upper.resize(problem.lower.size());
  for (int k = 0; k < problem.lower.size(); ++k) {
    problem.lower[k] = arm.joint(k).lower;
    problem.upper[k] = arm.joint(k).upper;
  }
  problem.clearance_of = sideBySide(context.clearance, ContactRule::kTravel, context.options.reach.spare);
  problem.travel = context.clearance.travel();
  problem.speeds = context.speeds;
  problem.cost = [speeds = context.speeds](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return straightMoveDuration(a, b, speeds);
  };
  return problem;
}

const Roadmap& TravelRoadmap::get() {
  if (roadmap_) return *roadmap_;
  const auto& [cell, compensation] = std::tie(context_.cell, context_.options.reach.compensation);
  const auto& tubes = cell.sheet.tubes;
  const std::size_t wanted = roadmapTubes(cell.arm, compensation.inverse);
  const std::size_t step = std::max<std::size_t>(1, tubes.size() / wanted);
  std::vector<Eigen::VectorXd> postures;
  for (std::size_t tube = 0; tube < tubes.size(); tube += step)
    for (const auto& branch : compensate(cell, holeCentre(tubes[tube]), compensation))
      if (branch.status == deflection::BranchStatus::kConverged) postures.push_back(branch.approach.front());
  RoadmapOptions options;
  options.seed = context_.options.seed;
  options.check = context_.options.motion.check;
  return roadmap_.emplace(travelProblemOf(context_), std::move(postures), options);
}

bool TravelRoadmap::bridge(const std::vector<Eigen::VectorXd>& postures) {
  get();
  MotionPlannerOptions motion = context_.options.motion;
  motion.seed = context_.options.seed;
  if (!roadmap_->bridge(postures, motion)) return false;
  return is_bridged_ = true;
}

TravelNetwork::TravelNetwork(const PlanContext& context, const std::vector<TubeReach>& reach, TravelRoadmap& roadmap)
    : context_(context), reach_(reach), roadmap_(roadmap), problem_(travelProblemOf(context)) {
  problem_.roadmap = [&roadmap](const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, long& checks) {
    return roadmap.get().between(q0, q1, checks);
  };
  if (const auto& options = context.options; options.travel == TravelKind::kLine)
    lines_.emplace(context.cell, context.speeds, options.reach.compensation.inverse, options.line);
}

const Eigen::VectorXd& TravelNetwork::standoff(Stop stop) const {
  if (stop.visit == kStartPosture) return *context_.options.conditions.start;
  if (stop.visit == kEndPosture) return *context_.options.conditions.end;
  return reach_[static_cast<std::size_t>(stop.visit)].branches[static_cast<std::size_t>(stop.branch)].approach.front();
}

TubePosture TravelNetwork::postureOf(Stop stop) const {
  if (stop.visit < 0) return {stop.visit, 0};
  return {reach_[static_cast<std::size_t>(stop.visit)].tube, stop.branch};
}

/// Plans a straight travel of the tool. The status is kNotRun if no line connects the two postures, kNoPath if an
/// obstacle blocks the line.
MotionPlan TravelNetwork::onLine(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1) {
  MotionPlan plan;
  LineTravel line = lines_->between(q0, q1);
  if (line.status != LineTravelStatus::kOnLine) return plan;
  setFlowingPath(std::move(line.waypoints), problem_, context_.options.motion.check, plan);
  plan.line_deviation = line.deviation;
  return plan;
}

MotionPlan TravelNetwork::planned(Stop a, Stop b, int shaping_attempts) {
  if (lines_ && a.visit >= 0 && b.visit >= 0)
    if (MotionPlan line = onLine(standoff(a), standoff(b)); line.status == MotionPlanStatus::kFree) return line;
  MotionPlannerOptions motion = context_.options.motion;
  motion.seed = pairSeed(context_.options.seed, postureOf(a), postureOf(b));
  motion.shaping_attempts = shaping_attempts;
  return planMotion(standoff(a), standoff(b), problem_, motion);
}

MotionPlan TravelNetwork::planned(Stop a, Stop b) { return planned(a, b, context_.options.motion.shaping_attempts); }

TravelEstimate TravelNetwork::estimate(Stop a, Stop b) {
  if (postureOf(b) < postureOf(a)) std::swap(a, b);
  const MotionPlan plan = planned(a, b, kRoughShaping);
  const bool is_shaped = plan.flows && std::isnan(plan.line_deviation);
  return {timeOf(plan), !is_shaped, plan.is_disconnected, plan.tightest, plan.checks};
}

std::vector<int> TravelNetwork::partsOf(const std::vector<Stop>& stops) {
  std::vector<Eigen::VectorXd> postures;
  for (const Stop& stop : stops) postures.push_back(standoff(stop));
  return roadmap_.get().partsOf(postures);
}

/// Returns the travel from stop a to stop b; the posture of a must be the smaller.
const MotionPlan& TravelNetwork::forward(Stop a, Stop b) {
  const MotionEnds ends{postureOf(a), postureOf(b)};
  auto known = context_.cache.travels.find(ends);
  if (known == context_.cache.travels.end()) known = context_.cache.travels.emplace(ends, planned(a, b)).first;
  if (!known->second.is_disconnected || !roadmap_.isBridged()) return known->second;
  auto rejoined = roadmap_.rejoined().find(ends);
  if (rejoined == roadmap_.rejoined().end()) rejoined = roadmap_.rejoined().emplace(ends, planned(a, b)).first;
  return rejoined->second;
}

const MotionPlan& TravelNetwork::between(Stop a, Stop b) {
  const bool is_backward = postureOf(b) < postureOf(a);
  if (is_backward) std::swap(a, b);
  const TubePosture first = postureOf(a), second = postureOf(b);
  const MotionPlan& known = forward(a, b);
  if (!is_backward) return known;
  const auto backward = backward_.find({second, first});
  if (backward != backward_.end()) return backward->second;
  return backward_.emplace(MotionEnds{second, first}, reversed(known)).first->second;
}

double TravelNetwork::timeOf(const MotionPlan& plan) const {
  if (plan.status != MotionPlanStatus::kFree) return std::numeric_limits<double>::infinity();
  return plan.flows ? timeFlow(plan.waypoints, context_.speeds).duration
                    : timePolyline(plan.waypoints, context_.speeds).duration;
}

}  // namespace tubeplan::planner
