#include "planner/motion/motion_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <random>

#include "planner/motion/detour_shaping.hpp"
#include "planner/motion/motion_search.hpp"
#include "planner/motion/roadmap.hpp"
#include "planner/motion/unit_random.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::VectorXd;

double costOf(const MotionProblem& problem, const VectorXd& from, const VectorXd& to) {
  return problem.cost ? problem.cost(from, to) : problem.travel(from, to);
}

double costOf(const MotionProblem& problem, const Waypoints& waypoints) {
  double sum = 0;
  for (std::size_t i = 1; i < waypoints.size(); ++i) sum += costOf(problem, waypoints[i - 1], waypoints[i]);
  return sum;
}

/// Returns the reason why a posture is not allowed; empty if it is allowed.
std::string postureProblem(const VectorXd& q, const MotionProblem& problem) {
  for (Eigen::Index j = 0; j < q.size(); ++j)
    if (!(q[j] >= problem.lower[j] && q[j] <= problem.upper[j]))
      return fmt::format("joint {} is at {:.6g}, beyond its limits {:.6g} to {:.6g}", j + 1, q[j], problem.lower[j],
                         problem.upper[j]);
  const Clearance clearance = problem.clearance_of(q);
  return clearance.margin >= 0 ? "" : describe(clearance);
}

/// Shortens a path by connecting two points on it directly, if the connection is proved free and costs less.
class Shortcutter {
 public:
  Shortcutter(const MotionProblem& problem, const MotionPlannerOptions& options, long& checks)
      : problem_(problem), options_(options), checks_(checks), generator_(options.seed) {}

  void shorten(Waypoints& waypoints) {
    dropWaypoints(waypoints);
    for (int attempt = 0; attempt < options_.shortcut_attempts && waypoints.size() > 2; ++attempt)
      tryShortcut(waypoints);
    dropWaypoints(waypoints);
  }

 private:
  /// A point on the path: on the segment that begins at waypoint `stretch`, at the fraction `s` of the segment.
  struct Place {
    std::size_t stretch;
    double s;
  };

  void dropWaypoints(Waypoints& waypoints) {
    for (std::size_t first = 0; first + 2 < waypoints.size(); ++first)
      for (std::size_t last = waypoints.size() - 1; last > first + 1; --last) {
        if (!isFree(waypoints[first], waypoints[last]) || !isCheaper(waypoints, first, last)) continue;
        waypoints.erase(waypoints.begin() + first + 1, waypoints.begin() + last);
        break;
      }
  }

  bool isCheaper(const Waypoints& waypoints, std::size_t first, std::size_t last) const {
    const Waypoints part(waypoints.begin() + first, waypoints.begin() + last + 1);
    return costOf(problem_, part.front(), part.back()) <= costOf(problem_, part);
  }

  void tryShortcut(Waypoints& waypoints) {
    Place a = randomPlace(waypoints), b = randomPlace(waypoints);
    if (b.stretch < a.stretch) std::swap(a, b);
    if (a.stretch == b.stretch) return;
    Waypoints shorter(waypoints.begin(), waypoints.begin() + a.stretch + 1);
    shorter.push_back(at(waypoints, a));
    shorter.push_back(at(waypoints, b));
    shorter.insert(shorter.end(), waypoints.begin() + b.stretch + 1, waypoints.end());
    if (!(costOf(problem_, shorter) < costOf(problem_, waypoints))) return;
    // The remaining parts of proved segments are free except for the rounding of their new ends, so they are checked
    // again.
    const std::size_t i = a.stretch;
    if (isFree(shorter[i + 1], shorter[i + 2]) && isFree(shorter[i], shorter[i + 1]) &&
        isFree(shorter[i + 2], shorter[i + 3]))
      waypoints = std::move(shorter);
  }

  static VectorXd at(const Waypoints& waypoints, const Place& place) {
    const VectorXd& from = waypoints[place.stretch];
    return from + place.s * (waypoints[place.stretch + 1] - from);
  }

  Place randomPlace(const Waypoints& waypoints) {
    const std::size_t stretch = generator_() % (waypoints.size() - 1);
    return {stretch, unitRandom(generator_)};
  }

  bool isFree(const VectorXd& from, const VectorXd& to) {
    const MotionCheckResult check = checkMotion(from, to, problem_.clearance_of, problem_.travel, options_.check);
    checks_ += check.checks;
    return check.status == MotionCheckStatus::kFree;
  }

  const MotionProblem& problem_;
  const MotionPlannerOptions& options_;
  long& checks_;
  std::mt19937_64 generator_;
};

/// Proves every segment of the plan and records the result. Returns false if a segment is not free.
bool proveStretches(const MotionProblem& problem, const MotionPlannerOptions& options, MotionPlan& plan) {
  plan.proved_margin = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    const auto check =
        checkMotion(plan.waypoints[i - 1], plan.waypoints[i], problem.clearance_of, problem.travel, options.check);
    plan.checks += check.checks;
    if (check.status != MotionCheckStatus::kFree) return false;
    plan.proved_margin = std::min(plan.proved_margin, check.proved_margin);
    if (i == 1 || check.tightest.margin < plan.tightest.margin) plan.tightest = check.tightest;
  }
  plan.cost = costOf(problem, plan.waypoints);
  plan.straight = plan.waypoints.size() == 2;
  plan.status = MotionPlanStatus::kFree;
  plan.reason.clear();
  return true;
}

void takeQuickest(Waypoints flow, const MotionProblem& problem, const MotionPlannerOptions& options, MotionPlan& plan) {
  quicken(flow, problem, options, plan.checks);
  setFlowingPath(std::move(flow), problem, options.check, plan);
}

/// Finds a detour through one posture; returns false if there is none.
bool goRound(const VectorXd& q0, const VectorXd& q1, const MotionProblem& problem, const MotionPlannerOptions& options,
             MotionPlan& plan) {
  if (!problem.speeds) return false;
  Waypoints way = detourByOnePosture(q0, q1, problem, options.check, plan.checks);
  if (way.empty()) return false;
  takeQuickest(std::move(way), problem, options, plan);
  return true;
}

/// Replaces the stops at the waypoints by continuous motion if it is proved free and saves time.
void letFlow(const MotionProblem& problem, const MotionPlannerOptions& options, MotionPlan& plan) {
  if (!problem.speeds || !(flowTime(plan.waypoints, problem) < plan.cost)) return;
  const MotionCheckResult check = checkFlow(plan.waypoints, problem, options.check, plan.checks);
  if (check.status == MotionCheckStatus::kFree) takeQuickest(plan.waypoints, problem, options, plan);
}

std::string noPathReason(const MotionSearchResult& search, const MotionCheckResult& straight) {
  std::string reason =
      fmt::format("no detour found in {} iterations; on the straight motion, {}", search.iterations, straight.reason);
  const auto more = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto most = std::max_element(search.blockers.begin(), search.blockers.end(), more);
  if (most != search.blockers.end())
    reason += fmt::format("; in the search mostly {} and {} collided", most->first.first, most->first.second);
  return reason;
}

/// Finds a detour of straight segments with the roadmap or, failing that, a search. Returns false if there is none,
/// with the reason in the plan.
bool findWay(const VectorXd& q0, const VectorXd& q1, const MotionProblem& problem, const MotionPlannerOptions& options,
             const MotionCheckResult& straight, MotionPlan& plan) {
  plan.status = MotionPlanStatus::kNoPath;
  if (problem.roadmap) {
    RoadmapWay way = problem.roadmap(q0, q1, plan.checks);
    if (way.status == RoadmapStatus::kFound) {
      plan.waypoints = std::move(way.waypoints);
      return true;
    }
    if (way.status == RoadmapStatus::kDisconnected) {
      plan.is_disconnected = true;
      plan.reason =
          "the two ends lie in disconnected parts of the free space; on the straight motion, " + straight.reason;
      return false;
    }
  }
  MotionSearchResult search = searchMotion(q0, q1, problem, options);
  plan.iterations = search.iterations;
  plan.checks += search.checks;
  plan.waypoints = std::move(search.waypoints);
  if (plan.waypoints.empty()) plan.reason = noPathReason(search, straight);
  return !plan.waypoints.empty();
}

}  // namespace

void setFlowingPath(Waypoints flow, const MotionProblem& problem, const MotionCheckOptions& options, MotionPlan& plan) {
  const MotionCheckResult check = checkFlow(flow, problem, options, plan.checks);
  plan.status = check.status == MotionCheckStatus::kFree ? MotionPlanStatus::kFree : MotionPlanStatus::kNoPath;
  plan.reason = check.reason;
  plan.cost = flowTime(flow, problem);
  plan.waypoints = std::move(flow);
  plan.flows = true;
  plan.proved_margin = check.proved_margin;
  plan.tightest = check.tightest;
}

MotionPlan planMotion(const VectorXd& q0, const VectorXd& q1, const MotionProblem& problem,
                      const MotionPlannerOptions& options) {
  assert(q0.size() == q1.size() && q0.size() == problem.lower.size() && q0.size() == problem.upper.size());
  assert(q0.size() == problem.travel.reach_per_joint.size() && problem.clearance_of);
  MotionPlan plan;
  const auto stopAt = [&plan](MotionPlanStatus status, std::string reason) {
    plan.status = status;
    plan.reason = std::move(reason);
    return plan;
  };
  if (auto reason = postureProblem(q0, problem); !reason.empty())
    return stopAt(MotionPlanStatus::kStartBlocked, "start: " + reason);
  if (auto reason = postureProblem(q1, problem); !reason.empty())
    return stopAt(MotionPlanStatus::kGoalBlocked, "goal: " + reason);

  const MotionCheckResult straight = checkMotion(q0, q1, problem.clearance_of, problem.travel, options.check);
  plan.checks = 2 + straight.checks;
  plan.tightest = straight.tightest;
  if (straight.status == MotionCheckStatus::kFree) {
    plan.waypoints = {q0, q1};
    plan.straight = true;
    plan.cost = costOf(problem, q0, q1);
    plan.proved_margin = straight.proved_margin;
    return stopAt(MotionPlanStatus::kFree, "");
  }

  if (goRound(q0, q1, problem, options, plan)) return plan;
  if (!findWay(q0, q1, problem, options, straight, plan)) return plan;
  Shortcutter(problem, options, plan.checks).shorten(plan.waypoints);
  if (proveStretches(problem, options, plan)) {
    letFlow(problem, options, plan);
    return plan;
  }
  // Every segment was proved when it was added, so a repeated proof fails only if the clearance does not depend on the
  // posture alone.
  plan.waypoints.clear();
  return stopAt(MotionPlanStatus::kNoPath,
                "a motion proved free was not free when checked again: its clearance changes between calls");
}

}  // namespace tubeplan::planner
