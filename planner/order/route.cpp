#include "planner/order/route.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tubeplan::planner {
namespace {

std::uint64_t packedEnd(int visit, int branch) {
  assert(visit >= kEndPosture && visit < (1 << 24) && branch >= 0 && branch < 256);
  return (static_cast<std::uint64_t>(visit + 2) << 8) | static_cast<std::uint64_t>(branch);
}

std::uint64_t packedMove(int visit_a, int branch_a, int visit_b, int branch_b) {
  const std::uint64_t a = packedEnd(visit_a, branch_a), b = packedEnd(visit_b, branch_b);
  return (std::min(a, b) << 32) | std::max(a, b);
}

std::string postureProblem(const Eigen::VectorXd& posture, Eigen::Index joints) {
  if (posture.size() != joints) {
    return "has " + std::to_string(posture.size()) + " joints where others have " + std::to_string(joints);
  }
  return posture.allFinite() ? "" : "has a joint that is not a finite number";
}

void addPostureProblems(const Route& route, Eigen::Index joints, std::vector<std::string>& problems) {
  const auto check = [&](const std::string& name, const Eigen::VectorXd& posture) {
    const std::string problem = postureProblem(posture, joints);
    if (!problem.empty()) problems.push_back(name + " " + problem);
  };
  for (std::size_t v = 0; v < route.visits.size(); ++v) {
    const std::string name = "visit " + std::to_string(v);
    if (route.visits[v].branches.empty()) problems.push_back(name + " has no posture");
    for (const Eigen::VectorXd& posture : route.visits[v].branches) check(name, posture);
  }
  if (route.start) check("the start posture", *route.start);
  if (route.end) check("the end posture", *route.end);
}

}  // namespace

void EdgePenalties::set(int visit_a, int branch_a, int visit_b, int branch_b, double seconds) {
  assert(seconds >= 0);
  seconds_[packedMove(visit_a, branch_a, visit_b, branch_b)] = seconds;
  for (const int visit : {visit_a, visit_b}) {
    if (touched_.size() <= static_cast<std::size_t>(visit + 2)) touched_.resize(visit + 3, 0);
    touched_[visit + 2] = 1;
  }
}

double EdgePenalties::operator()(int visit_a, int branch_a, int visit_b, int branch_b) const {
  if (!touches(visit_a) || !touches(visit_b)) return 0;
  const auto found = seconds_.find(packedMove(visit_a, branch_a, visit_b, branch_b));
  return found == seconds_.end() ? 0 : found->second;
}

std::vector<std::string> findRouteProblems(const Route& route) {
  if (route.speeds.max_speed.size() == 0) return {"an arm without joints cannot be timed"};
  std::vector<std::string> problems = findSpeedProblems(route.speeds, route.speeds.max_speed.size());
  addPostureProblems(route, route.speeds.max_speed.size(), problems);
  return problems;
}

}  // namespace tubeplan::planner
