#include "studies/benchmarks/library_plan.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <algorithm>

#include "planner/collision/arm_clearance.hpp"
#include "planner/reach/compensation.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::benchmarks {

namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using namespace planner;
using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;

constexpr double kSolveSeconds = 5;  // time limit of one travel [s]; RRTConnect usually needs a thousandth of this time

/// Solid in FCL, enlarged by `padding`. Spheres and capsules are enlarged in all directions, boxes and cylinders by
/// moving their faces outwards.
struct LibraryBody {
  std::shared_ptr<fcl::CollisionGeometryd> geometry;
  Isometry3d X_FC;
};

LibraryBody libraryBody(const Solid& solid, double padding) {
  const RoundedCore& core = solid.core();
  if (const auto* sphere = dynamic_cast<const fcl::Sphered*>(core.geometry.get()))
    return {std::make_shared<fcl::Sphered>(sphere->radius + core.rounding + padding), core.X_FC};
  if (const auto* capsule = dynamic_cast<const fcl::Capsuled*>(core.geometry.get()))
    return {std::make_shared<fcl::Capsuled>(capsule->radius + core.rounding + padding, capsule->lz), core.X_FC};
  if (const auto* box = dynamic_cast<const fcl::Boxd*>(core.geometry.get()))
    return {std::make_shared<fcl::Boxd>(box->side + Vector3d::Constant(2 * padding)), core.X_FC};
  const auto& cylinder = dynamic_cast<const fcl::Cylinderd&>(*core.geometry);
  return {std::make_shared<fcl::Cylinderd>(cylinder.radius + padding, cylinder.lz + 2 * padding), core.X_FC};
}

/// Collision checks of postures by FCL.
class LibraryChecker {
 public:
  LibraryChecker(const Workcell& cell, double padding) : cell_(cell), padding_(padding) {
    for (const Body& body : cell.scene.bodies) {
      const auto& solid = dynamic_cast<const Solid&>(*body.shape);
      padded_.push_back(libraryBody(solid, padding));
      plain_.push_back(libraryBody(solid, 0));
    }
    for (const Obstacle& obstacle : cell.scene.obstacles) {
      const auto* solid = dynamic_cast<const Solid*>(obstacle.shape.get());
      obstacles_.push_back(solid ? libraryBody(*solid, 0) : LibraryBody{});
    }
  }

  /// Returns true if the posture is collision-free. With `may_enter`, the contacts that the scene allows during an
  /// approach are permitted.
  [[nodiscard]] bool isFree(const VectorXd& q, bool may_enter) const {
    ++checks;
    const auto X_WL = bodyFrames(cell_, q, nullptr);
    if (X_WL.empty()) return false;
    const Scene& scene = cell_.scene;
    const auto poseOf = [&](std::size_t i) { return X_WL[static_cast<std::size_t>(scene.bodies[i].frame_index)]; };
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Body& body = scene.bodies[i];
      const bool is_tool = body.link == scene.links.back().name;
      for (std::size_t k = 0; k < scene.obstacles.size(); ++k) {
        if (mayTouch(scene.obstacles[k], body) && (may_enter || !is_tool)) continue;
        if (meetsObstacle(i, poseOf(i), k)) return false;
      }
      for (std::size_t k = 0; k < i; ++k)
        if (areJudged(scene, static_cast<int>(k), static_cast<int>(i)) && !mayTouch(scene.bodies[k], body) &&
            meet(padded_[i], poseOf(i), plain_[k], poseOf(k)))
          return false;
    }
    return true;
  }

  mutable long checks = 0;

 private:
  [[nodiscard]] bool meetsObstacle(std::size_t body, const Isometry3d& X_WB, std::size_t obstacle) const {
    if (obstacles_[obstacle].geometry) return meet(padded_[body], X_WB, obstacles_[obstacle], Isometry3d::Identity());
    const auto& solid = dynamic_cast<const Solid&>(*cell_.scene.bodies[body].shape);
    return cell_.scene.obstacles[obstacle].shape->separationFrom(X_WB, solid).distance < padding_;
  }

  static bool meet(const LibraryBody& a, const Isometry3d& X_WA, const LibraryBody& b, const Isometry3d& X_WB) {
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    try {
      return fcl::collide(a.geometry.get(), X_WA * a.X_FC, b.geometry.get(), X_WB * b.X_FC, request, result) > 0;
    } catch (const std::logic_error&) {
      return true;  // thrown for touching bodies
    }
  }

  const Workcell& cell_;
  double padding_;
  std::vector<LibraryBody> padded_, plain_, obstacles_;
};

/// Returns the standoff posture of the first collision-free inverse solution of each tube; omits tubes without one.
Waypoints libraryStandoffs(const Workcell& cell, const std::vector<int>& tubes, const LibraryChecker& checker) {
  Waypoints standoffs;
  for (const int tube : tubes)
    for (const TubeBranch& branch : compensate(cell, holeCentre(cell.sheet.tubes.at(static_cast<std::size_t>(tube))))) {
      if (branch.approach.empty() || !checker.isFree(branch.approach.front(), false)) continue;
      if (!std::ranges::all_of(branch.approach, [&](const VectorXd& q) { return checker.isFree(q, true); })) continue;
      standoffs.push_back(branch.approach.front());
      break;
    }
  return standoffs;
}

Waypoints nearestNeighbourOrder(Waypoints open, const JointSpeeds& speeds) {
  Waypoints order;
  while (!open.empty()) {
    const auto time = [&](const VectorXd& q) {
      return order.empty() ? 0 : straightMoveDuration(order.back(), q, speeds);
    };
    const auto next = std::ranges::min_element(open, {}, time);
    order.push_back(*next);
    open.erase(next);
  }
  return order;
}

ob::StateSpacePtr jointSpace(const deflection::Arm& arm) {
  const auto space = std::make_shared<ob::RealVectorStateSpace>();
  for (const auto& joint : arm.joints()) space->addDimension(joint.lower, joint.upper);
  return space;
}

VectorXd postureOf(const ob::State* state, Eigen::Index joints) {
  return Eigen::Map<const VectorXd>(state->as<ob::RealVectorStateSpace::StateType>()->values, joints);
}

/// Returns the path of a travel; empty if no exact solution was found.
Waypoints libraryTravel(const Workcell& cell, const LibraryChecker& checker, const VectorXd& from, const VectorXd& to) {
  og::SimpleSetup setup(jointSpace(cell.arm));
  setup.setStateValidityChecker(
      [&](const ob::State* state) { return checker.isFree(postureOf(state, from.size()), false); });
  ob::ScopedState<> start(setup.getStateSpace()), goal(setup.getStateSpace());
  for (Eigen::Index j = 0; j < from.size(); ++j) {
    start[static_cast<unsigned>(j)] = from[j];
    goal[static_cast<unsigned>(j)] = to[j];
  }
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<og::RRTConnect>(setup.getSpaceInformation()));
  if (setup.solve(kSolveSeconds) != ob::PlannerStatus::EXACT_SOLUTION) return {};
  setup.simplifySolution();
  Waypoints travel;
  for (const ob::State* state : setup.getSolutionPath().getStates()) travel.push_back(postureOf(state, from.size()));
  return travel;
}

}  // namespace

Outcome planByLibraries(const Workcell& cell, const std::vector<int>& tubes, const LibraryOptions& options) {
  Outcome outcome;
  outcome.name = "OMPL + FCL";
  const Watch watch;
  double bow = 0, greatest_bow = 0;
  for (const auto& q : deflection::latticeStarts(cell.arm, 96))
    if (!bodyFrames(cell, q, &bow).empty()) greatest_bow = std::max(greatest_bow, bow);
  const LibraryChecker checker(cell, cell.scene.clearance + greatest_bow);
  const Waypoints order = nearestNeighbourOrder(libraryStandoffs(cell, tubes, checker), jointSpeedsOf(cell.arm));
  outcome.requested = static_cast<int>(tubes.size());
  outcome.visits = order.empty() ? 0 : 1;
  for (std::size_t k = 0; k + 1 < order.size() && watch.processor() < options.most_seconds; ++k) {
    ++outcome.visits;
    Waypoints travel = libraryTravel(cell, checker, order[k], order[k + 1]);
    outcome.failed += travel.empty();
    outcome.detours += travel.size() > 2;
    if (!travel.empty()) outcome.travels.push_back(std::move(travel));
  }
  outcome.wall = watch.wall();
  outcome.processor = watch.processor();
  outcome.checks = checker.checks;
  return outcome;
}

}  // namespace tubeplan::benchmarks
