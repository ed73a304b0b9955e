#include "planner/travel_network.hpp"

#include <algorithm>

namespace tubeplan::planner {

namespace {

MotionPlan reversed(MotionPlan plan) {
  std::reverse(plan.waypoints.begin(), plan.waypoints.end());
  return plan;
}

/// A seed of its own for each pair, so that the order of asking does not matter.
std::uint64_t pairSeed(std::uint64_t seed, Stop a, Stop b) {
  for (int part : {a.visit, a.branch, b.visit, b.branch})
    seed = (seed ^ static_cast<std::uint64_t>(part + 1)) * 0x9E3779B97F4A7C15ULL;
  return seed;
}

}  // namespace

TravelNetwork::TravelNetwork(const ArmClearance& clearance, const std::vector<TubeReach>& reach,
                             const JointSpeeds& speeds, const VisitPlanOptions& options)
    : clearance_(clearance), reach_(reach), speeds_(speeds), options_(options) {
  const auto& arm = clearance.cell().arm;
  const auto active = deflection::activeRows(arm);
  problem_.lower.resize(static_cast<Eigen::Index>(active.size()));
  problem_.upper.resize(problem_.lower.size());
  for (int k = 0; k < problem_.lower.size(); ++k) {
    problem_.lower[k] = arm.rows[active[k]].joint.lower;
    problem_.upper[k] = arm.rows[active[k]].joint.upper;
  }
  problem_.clearance_of = [&clearance, spare = options.reach.spare](const Eigen::VectorXd& q) {
    return clearance.withSpare(q, ContactRule::kTravel, spare);
  };
  problem_.travel = clearance.travel();
  problem_.cost = [&speeds](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return straightMoveDuration(a, b, speeds);
  };
}

const Eigen::VectorXd& TravelNetwork::standoff(Stop stop) const {
  return reach_[static_cast<std::size_t>(stop.visit)].branches[static_cast<std::size_t>(stop.branch)].approach.front();
}

bool TravelNetwork::knows(Stop a, Stop b) const { return plans_.contains({a, b}); }

const MotionPlan& TravelNetwork::between(Stop a, Stop b) {
  if (const auto known = plans_.find({a, b}); known != plans_.end()) return known->second;
  const Stop first = std::min(a, b), second = std::max(a, b);
  MotionPlannerOptions motion = options_.motion;
  motion.seed = pairSeed(options_.seed, first, second);
  const MotionPlan plan = planMotion(standoff(first), standoff(second), problem_, motion);
  plans_[{second, first}] = reversed(plan);
  plans_[{first, second}] = plan;
  return plans_.at({a, b});
}

double TravelNetwork::timeOf(const MotionPlan& plan) const {
  if (plan.status != MotionPlanStatus::kFree) return std::numeric_limits<double>::infinity();
  return timePolyline(plan.waypoints, speeds_).duration;
}

}  // namespace tubeplan::planner
