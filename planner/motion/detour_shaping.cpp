#include "planner/motion/detour_shaping.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <random>

#include "planner/motion/unit_random.hpp"
#include "planner/timing/flowing_timing.hpp"

namespace tubeplan::planner {

namespace {

using Eigen::VectorXd;

// Displacements by one joint, as travel of the arm's farthest point [m]: offsets from the straight move at which a
// detour is searched for, and step sizes for shaping the detour.
constexpr std::array kSideways{0.03, 0.06, 0.12, 0.25, 0.5, 1.0};
constexpr std::array kFinerAndFiner{0.8, 0.4, 0.2, 0.1, 0.05, 0.025, 0.012};
constexpr int kAttemptsForOneMore = 8;    // one attempt in this many adds a waypoint
constexpr long kMostChecks = 200'000;     // largest number of postures checked for one detour
constexpr double kLeastTimeSaved = 1e-3;  // smallest saving for which waypoints are replaced [s]

bool isWithinLimits(const VectorXd& q, const MotionProblem& problem) {
  return (q.array() >= problem.lower.array()).all() && (q.array() <= problem.upper.array()).all();
}

bool isFree(const MotionCheckResult& check) { return check.status == MotionCheckStatus::kFree; }

/// Returns the step of each joint that moves the arm's farthest point by about one metre; zero for a joint that does
/// not move any body.
VectorXd stepsPerMetre(const MotionProblem& problem) {
  const VectorXd& reach = problem.travel.reach_per_joint;
  const double least = 1e-3 * reach.maxCoeff();
  return reach.unaryExpr([least](double r) { return r > least ? 1 / r : 0.0; });
}

/// Returns postures within the joint limits that differ from `middle` in one or two joints.
std::vector<VectorXd> posturesNear(const VectorXd& middle, const MotionProblem& problem) {
  const VectorXd steps = stepsPerMetre(problem);
  std::vector<VectorXd> postures;
  const auto add = [&](VectorXd q) {
    if (isWithinLimits(q, problem)) postures.push_back(std::move(q));
  };
  for (const double metres : kSideways)
    for (Eigen::Index j = 0; j < middle.size(); ++j)
      for (const double sign : {1., -1.}) {
        VectorXd changed = middle;
        changed[j] += sign * metres * steps[j];
        add(changed);
        for (Eigen::Index k = 0; k < j; ++k)
          for (const double other : {1., -1.}) {
            VectorXd changed_twice = changed;
            changed_twice[k] += other * metres * steps[k];
            add(changed_twice);
          }
      }
  return postures;
}

struct Shaping {
  const MotionProblem& problem;
  const MotionCheckOptions& options;
  std::mt19937_64 generator;
  long& checks;
  Waypoints& best;
  double time;
  long checks_before = checks;

  [[nodiscard]] bool isSpent() const { return checks - checks_before > kMostChecks; }

  /// Replaces the best waypoints with `shape` if the motion through `shape` without stops is faster and is proved free
  /// of collision. Returns true if they were replaced.
  bool take(Waypoints shape) {
    if (isSpent()) return false;
    const double now = flowTime(shape, problem);
    if (!(now < time - kLeastTimeSaved) || !isFree(checkFlow(shape, problem, options, checks))) return false;
    best = std::move(shape);
    time = now;
    return true;
  }

  bool dropOne() {
    for (std::size_t k = 1; k + 1 < best.size(); ++k) {
      Waypoints fewer = best;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
      if (take(std::move(fewer))) return true;
    }
    return false;
  }

  void dropAll() {
    while (dropOne()) {
    }
  }

  /// Displaces all joints of a random inner waypoint or, in some attempts, of a new waypoint that is added before it.
  void moveOne(const VectorXd& steps) {
    Waypoints moved = best;
    const std::size_t k = 1 + generator() % (best.size() - 2);
    if (generator() % kAttemptsForOneMore == 0)
      moved.insert(moved.begin() + static_cast<std::ptrdiff_t>(k), (best[k - 1] + best[k]) / 2);
    for (Eigen::Index j = 0; j < steps.size(); ++j) moved[k][j] += steps[j] * randomBetween(-1, 1, generator);
    if (isWithinLimits(moved[k], problem)) take(std::move(moved));
  }
};

}  // namespace

double flowTime(const Waypoints& waypoints, const MotionProblem& problem) {
  assert(problem.speeds);
  return timeFlow(waypoints, *problem.speeds).duration;
}

MotionCheckResult checkFlow(const Waypoints& waypoints, const MotionProblem& problem, const MotionCheckOptions& options,
                            long& checks) {
  assert(problem.speeds);
  const auto corners = cornersOf(timeFlow(waypoints, *problem.speeds));
  MotionCheckResult combined;
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const MotionCheckResult part =
        checkMotion(corners[k - 1], corners[k], problem.clearance_of, problem.travel, options);
    checks += part.checks;
    if (!isFree(part)) return part;
    if (k == 1 || part.tightest.margin < combined.tightest.margin) combined.tightest = part.tightest;
    combined.proved_margin = k == 1 ? part.proved_margin : std::min(combined.proved_margin, part.proved_margin);
    combined.status = MotionCheckStatus::kFree;
  }
  return combined;
}

Waypoints detourByOnePosture(const VectorXd& q0, const VectorXd& q1, const MotionProblem& problem,
                             const MotionCheckOptions& options, long& checks) {
  struct Way {
    double time;
    Waypoints waypoints;
  };
  std::vector<Way> ways;
  for (auto& q : posturesNear((q0 + q1) / 2, problem)) {
    Waypoints waypoints{q0, std::move(q), q1};
    ways.push_back({flowTime(waypoints, problem), std::move(waypoints)});
  }
  std::ranges::stable_sort(ways, {}, &Way::time);
  for (auto& way : ways)
    if (isFree(checkFlow(way.waypoints, problem, options, checks))) return std::move(way.waypoints);
  return {};
}

void quicken(Waypoints& waypoints, const MotionProblem& problem, const MotionPlannerOptions& options, long& checks) {
  Shaping shaping{problem, options.check, std::mt19937_64(options.seed),
                  checks,  waypoints,     flowTime(waypoints, problem)};
  const VectorXd steps = stepsPerMetre(problem);
  for (const double metres : kFinerAndFiner) {
    shaping.dropAll();
    for (int k = 0; k < options.shaping_attempts && waypoints.size() > 2 && !shaping.isSpent(); ++k)
      shaping.moveOne(metres * steps);
  }
  shaping.dropAll();
}

}  // namespace tubeplan::planner
