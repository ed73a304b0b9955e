// Branches of the inverse kinematics compared with postures from many random starts, for any arm under the holes of its
// cell.
//
// If an arm has more joints than its goals require, each goal has a continuous family of postures. A posture then
// counts as found if the search finds one with equal values of the redundant joints. If a wrist rotates the tool, the
// roll must agree too; if two axes of the wrist are aligned, also the rotation between them.
#pragma once

#include <chrono>
#include <ctime>

#include "deflection/inverse/goal_newton.hpp"
#include "deflection/inverse/inverse_solver.hpp"
#include "deflection/inverse/rigid_search.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner::testing {

struct BranchCount {
  int goals = 0;
  long brute = 0;      ///< distinct postures from the random starts that are within the limits
  long missed = 0;     ///< postures of `brute` that the search does not find
  long branches = 0;   ///< usable branches of the flexible arm
  long wrong = 0;      ///< number of `branches` that miss the goal or exceed the joint limits or the tilt
  int without = 0;     ///< goals that random starts reach within the allowed tilt but the search does not
  double seconds = 0;  ///< processor time for all branches of all goals of the flexible arm [s]

  BranchCount& operator+=(const BranchCount& other) {
    goals += other.goals, brute += other.brute, missed += other.missed, branches += other.branches;
    wrong += other.wrong, without += other.without, seconds += other.seconds;
    return *this;
  }
};

inline double postureDifference(const deflection::Arm& arm, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double most = 0;
  for (Eigen::Index k = 0; k < a.size(); ++k)
    most = std::max(most, arm.joint(k).type == deflection::JointType::kPrismatic
                              ? std::abs(a[k] - b[k]) / deflection::reachOf(arm)
                              : std::abs(std::remainder(a[k] - b[k], 2 * std::numbers::pi)));
  return most;
}

/// Returns the distinct postures of the rigid arm that `starts` random starts lead to.
inline std::vector<Eigen::VectorXd> bruteForce(const deflection::Arm& rigid, const deflection::ToolGoal& goal,
                                               const Eigen::Vector3d& gravity_B, double max_tilt, int starts,
                                               std::mt19937_64& generator) {
  deflection::InverseKinematicsOptions options;
  options.max_tilt = max_tilt;
  options.position_tolerance = options.pitch_tolerance = 1e-9;
  options.singular_floor = 1e-6;  // singular postures are refined as long as possible
  deflection::InverseSolver solver(rigid, 0, gravity_B, options);
  std::vector<Eigen::VectorXd> from, found;
  for (int k = 0; k < starts; ++k) from.push_back(randomPosture(rigid, generator));
  for (const auto& branch : solver.refine(std::vector(from.size(), goal), from)) {
    if (branch.status != deflection::BranchStatus::kConverged) continue;
    if (std::ranges::all_of(found, [&](const auto& other) { return postureDifference(rigid, other, branch.q) > 1e-4; }))
      found.push_back(branch.q);
  }
  return found;
}

/// Returns true if the search finds posture `q` when the joints that it samples have the values of `q`. The other
/// joints of each posture found are first refined to reach the goal.
inline bool isFound(const deflection::RigidSearch& search, const deflection::Arm& arm, const deflection::ToolGoal& goal,
                    const Eigen::VectorXd& q) {
  using namespace deflection;
  const std::vector<int> held(search.sampled().begin(), search.sampled().end());
  std::vector<int> moved;
  Arm slice = arm;
  slice.rows.clear();
  for (int k = 0; k < q.size(); ++k)
    if (std::ranges::find(held, k) == held.end()) moved.push_back(k), slice.rows.emplace_back().joint = arm.joint(k);
  slice.rows.front().placement = Origin<double>{{0, 0, reachOf(arm)}, {0, 0, 0}};
  const AxesAtZero axes = axesAtZero(arm);
  InverseKinematicsOptions options;
  options.singular_floor = 1e-6;
  const auto place = [&](const Eigen::Ref<const Eigen::MatrixXd>& some, std::span<TipMotion> tips) {
    for (std::size_t k = 0; k < tips.size(); ++k) {
      Eigen::VectorXd all = q;
      all(moved) = some.col(static_cast<Eigen::Index>(k));
      placeRigidTip(axes, all, tips[k]);
      tips[k].columns = Eigen::MatrixXd(tips[k].columns(Eigen::all, moved));
    }
  };
  GoalProblem problem(slice, false, place, options);
  std::vector<Eigen::VectorXd> roots;
  search.addPosturesLike(goal, q, roots);
  std::vector<Eigen::VectorXd> starts;
  for (const auto& root : roots) starts.emplace_back(root(moved));
  for (const Branch& branch : leadToGoals(problem, std::vector(starts.size(), goal), starts)) {
    Eigen::VectorXd led = q;
    led(moved) = branch.q;
    if (postureDifference(arm, led, q) < 1e-3) return true;
  }
  return false;
}

inline BranchCount countBranches(const Workcell& cell, std::span<const Eigen::Vector3d> places_W, int starts,
                                 std::uint64_t seed) {
  using namespace deflection;
  const Arm rigid = rigidCopy(cell.arm);
  const Eigen::Vector3d gravity_B = gravityInBase(cell.arm, cell.X_WB);
  InverseKinematicsOptions options;
  options.max_tilt = std::min(options.max_tilt, tubesheets::toleratedTilt(cell.tool));
  const bool turret = isTurretArm(rigid);
  std::optional<RigidSearch> search;
  if (!turret) search.emplace(rigid, axesAtZero(rigid));
  InverseSolver rigid_solver(rigid, 0, gravity_B, options), solver(cell.arm, cell.load, gravity_B, options);
  std::mt19937_64 generator(seed);
  std::vector<ToolGoal> goals;
  for (const auto& place_W : places_W)
    goals.push_back({cell.X_WB.inverse() * place_W, cell.X_WB.linear().transpose() * kHoleAxis_W});
  (void)solver.solve(goals.front());  // the first call computes data that later calls reuse

  BranchCount count;
  count.goals = static_cast<int>(goals.size());
  const std::clock_t before = std::clock();
  const auto solutions = solver.solve(goals);
  count.seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  for (std::size_t g = 0; g < goals.size(); ++g) {
    for (const Branch& branch : solutions[g].branches) {
      if (branch.status != BranchStatus::kConverged) continue;
      ++count.branches;
      const auto shape = solveFlexibleKinematics(cell.arm, {branch.q, cell.load, gravity_B}, {1e-14, 200});
      count.wrong += (shape.X_BD.p - goals[g].p_BT).norm() > 1e-9 * reachOf(cell.arm) ||
                     !withinLimits(cell.arm, branch.q) || branch.tilt > options.max_tilt;
    }
    const auto brute = bruteForce(rigid, goals[g], gravity_B, options.max_tilt, starts, generator);
    count.brute += static_cast<long>(brute.size());
    const auto known = rigid_solver.solve(goals[g]);
    count.without += !brute.empty() && known.status != BranchStatus::kConverged;
    for (const auto& q : brute) {
      const bool is_known = std::ranges::any_of(
          known.branches, [&](const Branch& branch) { return postureDifference(rigid, branch.q, q) < 2e-3; });
      count.missed += !is_known && (turret || !isFound(*search, rigid, goals[g], q));
    }
  }
  return count;
}

/// Returns a cell with a random arm of `joints` joints, with any geometry, limits and base; joint `slide` is prismatic
/// (-1 if none).
inline Workcell drawnArm(int joints, int slide, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const auto angle = [&](double most) { return uniform(generator, -most, most); };
  Workcell cell = alone(mockup("puma.yaml"));
  cell.arm = {};
  for (int k = 0; k < joints; ++k) {
    auto& row = cell.arm.rows.emplace_back();
    row.name = "row" + std::to_string(k);
    row.placement = deflection::DenavitHartenberg<double>{angle(3), uniform(generator, 0, 0.4), angle(0.2), 0};
    row.joint.name = "joint" + std::to_string(k);
    row.joint.type = k == slide ? deflection::JointType::kPrismatic : deflection::JointType::kRevolute;
    const double middle = k == slide ? 0.4 : angle(1), half = k == slide ? 0.3 : uniform(generator, 1.8, 3);
    row.joint.lower = middle - half;
    row.joint.upper = middle + half;
    row.joint_stiffness.z() = k == slide ? deflection::kRigid : 4e4;
    row.weight.lumps.push_back({40, {0.1, 0, 0}});
  }
  cell.arm.p_LT = {angle(0.1), angle(0.1), 0.2};
  cell.scene.bodies.clear();
  cell.X_WB = Eigen::Translation3d(angle(0.3), angle(0.3), angle(0.3)) *
              Eigen::AngleAxisd(angle(3), Eigen::Vector3d(angle(1), angle(1), angle(1)).normalized());
  return cell;
}

/// Returns `count` tip positions [m]. Each is reached, with the tool upright, by a posture within the limits that is
/// refined from a random one.
inline std::vector<Eigen::Vector3d> placesOf(const Workcell& cell, int count, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const Eigen::Vector3d gravity_B = deflection::gravityInBase(cell.arm, cell.X_WB);
  const Eigen::Vector3d axis_B = cell.X_WB.linear().transpose() * kHoleAxis_W;
  deflection::InverseKinematicsOptions options;
  options.singular_floor = 1e-4;
  std::vector<Eigen::Vector3d> places;
  for (int draws = 0; static_cast<int>(places.size()) < count && draws < 4000 * count; ++draws) {
    const Eigen::VectorXd q = randomPosture(cell.arm, generator);
    const PredictedTip tip = predictTip(cell, q);
    if (tip.tilt > 0.4) continue;
    const auto led =
        deflection::refineBranch(cell.arm, {cell.X_WB.inverse() * tip.p_WT, axis_B}, cell.load, gravity_B, q, options);
    if (led.status == deflection::BranchStatus::kConverged && led.tilt < 1e-6) places.push_back(tip.p_WT);
  }
  return places;
}

struct CountedArm {
  std::string name;
  Workcell cell;
  std::vector<Eigen::Vector3d> places_W;
};

/// Returns eight arms, six shipped and two random, each with `count` goals.
inline std::vector<CountedArm> countedArms(int count) {
  std::vector<CountedArm> arms;
  for (const char* file :
       {"mockup.yaml", "tsm-cobra.yaml", "column.yaml", "puma.yaml", "iiwa.yaml", "scenes/upside-down.yaml"}) {
    const Workcell cell = mockup(file);
    std::vector<Eigen::Vector3d> places;
    for (const int tube : tubesOf(cell, "spread:" + std::to_string(count))) places.push_back(holeOf(cell, tube));
    arms.push_back({file, cell, places});
  }
  for (const auto& [joints, slide] : {std::pair(5, -1), std::pair(6, 2)}) {
    const Workcell cell = drawnArm(joints, slide, 11);
    arms.push_back({"drawn, " + std::to_string(joints) + " joints", cell, placesOf(cell, count, 4)});
  }
  return arms;
}

}  // namespace tubeplan::planner::testing
