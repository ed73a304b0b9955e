#include "app/formats/checkpoint/plan_cache_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/formats/checkpoint/whole_number.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;
using planner::MotionEnds;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Returns a number as JSON: "nan", "inf" or "-inf" for values that are not finite.
json numberJson(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

double numberFrom(const json& value) {
  if (!value.is_string()) return value.get<double>();
  const auto word = value.get<std::string>();
  return word == "inf" ? kInfinity : word == "-inf" ? -kInfinity : std::numeric_limits<double>::quiet_NaN();
}

template <class Vector>
json numbersJson(const Vector& values) {
  json list = json::array();
  for (const double value : values) list.push_back(numberJson(value));
  return list;
}

Eigen::VectorXd vectorFrom(const json& list) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(list.size()));
  for (std::size_t k = 0; k < list.size(); ++k) values[static_cast<Eigen::Index>(k)] = numberFrom(list[k]);
  return values;
}

Eigen::Vector3d pointFrom(const json& list) {
  return {numberFrom(list.at(0)), numberFrom(list.at(1)), numberFrom(list.at(2))};
}

json posturesJson(const std::vector<Eigen::VectorXd>& postures) {
  json list = json::array();
  for (const auto& q : postures) list.push_back(numbersJson(q));
  return list;
}

std::vector<Eigen::VectorXd> posturesFrom(const json& list) {
  std::vector<Eigen::VectorXd> postures;
  for (const auto& q : list) postures.push_back(vectorFrom(q));
  return postures;
}

json clearanceJson(const planner::Clearance& clearance) {
  return {numberJson(clearance.distance), numberJson(clearance.margin), clearance.body, clearance.other,
          numbersJson(clearance.point_W)};
}

planner::Clearance clearanceFrom(const json& list) {
  return {numberFrom(list.at(0)), numberFrom(list.at(1)), list.at(2), list.at(3), pointFrom(list.at(4))};
}

json branchJson(const planner::TubeBranch& branch) {
  return {{"q", numbersJson(branch.q)},
          {"approach", posturesJson(branch.approach)},
          {"tip", numbersJson(branch.predicted_tip_W)},
          {"tilt", numberJson(branch.tilt)},
          {"deviation", numberJson(branch.path_deviation)}};
}

// Reads a branch of a tube's reach. A reach contains only branches whose computation converged.
planner::TubeBranch branchFrom(const json& object) {
  planner::TubeBranch branch;
  branch.status = deflection::BranchStatus::kConverged;
  branch.q = vectorFrom(object.at("q"));
  branch.approach = posturesFrom(object.at("approach"));
  branch.predicted_tip_W = pointFrom(object.at("tip"));
  branch.tilt = numberFrom(object.at("tilt"));
  branch.path_deviation = numberFrom(object.at("deviation"));
  return branch;
}

json endsJson(const MotionEnds& ends) {
  return {ends.first.tube, ends.first.branch, ends.second.tube, ends.second.branch};
}

MotionEnds endsFrom(const json& list) {
  return {{wholeNumber<int>(list.at(0)), wholeNumber<int>(list.at(1))},
          {wholeNumber<int>(list.at(2)), wholeNumber<int>(list.at(3))}};
}

json orderJson(const planner::VisitOrder& order) {
  return {{"status", static_cast<int>(order.status)},
          {"reason", order.reason},
          {"order", order.order},
          {"branches", order.branches},
          {"travel_time", numberJson(order.travel_time)},
          {"lower_bound", numberJson(order.lower_bound)},
          {"gap", numberJson(order.optimality_gap)}};
}

planner::VisitOrder orderFrom(const json& object) {
  planner::VisitOrder order;
  order.status = static_cast<planner::VisitOrderStatus>(wholeNumber<int>(object.at("status")));
  order.reason = object.at("reason");
  order.order = wholeNumbers<int>(object.at("order"));
  order.branches = wholeNumbers<int>(object.at("branches"));
  order.travel_time = numberFrom(object.at("travel_time"));
  order.lower_bound = numberFrom(object.at("lower_bound"));
  order.optimality_gap = numberFrom(object.at("gap"));
  return order;
}

json postureJson(const std::optional<Eigen::VectorXd>& q) { return q ? numbersJson(*q) : json(); }

std::optional<Eigen::VectorXd> postureFrom(const json& list) {
  return list.is_null() ? std::nullopt : std::optional(vectorFrom(list));
}

json boundJson(const planner::KnownBound& bound) {
  return {{"lower_bound", numberJson(bound.lower_bound)},
          {"start", postureJson(bound.start)},
          {"end", postureJson(bound.end)}};
}

planner::KnownBound boundFrom(const json& object) {
  return {numberFrom(object.at("lower_bound")), postureFrom(object.at("start")), postureFrom(object.at("end"))};
}

}  // namespace

json reachJson(const planner::TubeReach& reach) {
  json branches = json::array();
  for (const auto& branch : reach.branches) branches.push_back(branchJson(branch));
  return {{"tube", reach.tube},
          {"branches", branches},
          {"reason", reach.reason},
          {"blocking", clearanceJson(reach.blocking)}};
}

planner::TubeReach reachFrom(const json& object) {
  planner::TubeReach reach;
  reach.tube = wholeNumber<int>(object.at("tube"));
  for (const auto& branch : object.at("branches")) reach.branches.push_back(branchFrom(branch));
  reach.status = reach.branches.empty() ? planner::ReachStatus::kUnreachable : planner::ReachStatus::kReachable;
  reach.reason = object.at("reason");
  reach.blocking = clearanceFrom(object.at("blocking"));
  return reach;
}

json travelJson(const MotionEnds& ends, const planner::MotionPlan& plan) {
  return {{"ends", endsJson(ends)},
          {"status", static_cast<int>(plan.status)},
          {"reason", plan.reason},
          {"waypoints", posturesJson(plan.waypoints)},
          {"flows", plan.flows},
          {"apart", plan.is_disconnected},
          {"line_deviation", numberJson(plan.line_deviation)},
          {"cost", numberJson(plan.cost)},
          {"margin", numberJson(plan.proved_margin)},
          {"tightest", clearanceJson(plan.tightest)},
          {"iterations", plan.iterations},
          {"checks", plan.checks}};
}

planner::MotionPlan travelFrom(const json& object) {
  planner::MotionPlan plan;
  plan.status = static_cast<planner::MotionPlanStatus>(wholeNumber<int>(object.at("status")));
  plan.reason = object.at("reason");
  plan.waypoints = posturesFrom(object.at("waypoints"));
  plan.straight = plan.waypoints.size() == 2;
  plan.flows = object.at("flows");
  plan.is_disconnected = object.at("apart");
  if (object.contains("line_deviation")) plan.line_deviation = numberFrom(object["line_deviation"]);
  plan.cost = numberFrom(object.at("cost"));
  plan.proved_margin = numberFrom(object.at("margin"));
  plan.tightest = clearanceFrom(object.at("tightest"));
  plan.iterations = wholeNumber<decltype(plan.iterations)>(object.at("iterations"));
  plan.checks = wholeNumber<decltype(plan.checks)>(object.at("checks"));
  return plan;
}

json proofJson(const MotionEnds& ends, const planner::SegmentProof& proof) {
  return {{"ends", endsJson(ends)}, {"margin", numberJson(proof.margin)}, {"tightest", clearanceJson(proof.tightest)}};
}

planner::SegmentProof proofFrom(const json& object) {
  return {numberFrom(object.at("margin")), clearanceFrom(object.at("tightest"))};
}

json wholePlanJson(const planner::PlanCache& cache) {
  json orders = json::array();
  for (const auto& order : cache.orders) orders.push_back(orderJson(order));
  return {{"orders", orders},
          {"visiting_order", cache.visiting_order},
          {"visiting_branches", cache.visiting_branches},
          {"bound", boundJson(cache.bound)}};
}

planner::PlanCache wholePlanFrom(const json& object) {
  planner::PlanCache cache;
  for (const auto& entry : object.at("orders")) cache.orders.push_back(orderFrom(entry));
  cache.visiting_order = wholeNumbers<int>(object.at("visiting_order"));
  // Files of version 1.0 have neither the branches nor the bound.
  if (object.contains("visiting_branches")) cache.visiting_branches = wholeNumbers<int>(object["visiting_branches"]);
  if (object.contains("bound")) cache.bound = boundFrom(object["bound"]);
  return cache;
}

json cacheJson(const planner::PlanCache& cache) {
  json result = wholePlanJson(cache), reach = json::array(), travels = json::array(), proofs = json::array();
  for (const auto& [tube, found] : cache.reach) reach.push_back(reachJson(found));
  for (const auto& [ends, plan] : cache.travels) travels.push_back(travelJson(ends, plan));
  for (const auto& [ends, proof] : cache.proofs) proofs.push_back(proofJson(ends, proof));
  result["reach"] = reach;
  result["travels"] = travels;
  result["proofs"] = proofs;
  return result;
}

planner::PlanCache cacheFrom(const json& object) {
  planner::PlanCache cache = wholePlanFrom(object);
  for (const auto& entry : object.at("reach")) {
    planner::TubeReach reach = reachFrom(entry);
    cache.reach[reach.tube] = std::move(reach);
  }
  for (const auto& entry : object.at("travels")) cache.travels[endsFrom(entry.at("ends"))] = travelFrom(entry);
  for (const auto& entry : object.at("proofs")) cache.proofs[endsFrom(entry.at("ends"))] = proofFrom(entry);
  return cache;
}

}  // namespace tubeplan::app
