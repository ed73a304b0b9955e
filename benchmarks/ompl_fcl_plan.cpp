// The same tubes visited as one would plan it with OMPL and FCL alone, beside this planner, in one run.
//
// The library way: the first posture of the flexible inverse kinematics that is free, nearest neighbour by the time of
// the straight joint move, each travel by OMPL's RRTConnect with default settings and OMPL's own simplification,
// postures checked by FCL at OMPL's default resolution. It is given what would cost it dear: the bent bodies, padded by
// the clearance asked for and their greatest bow; and the bowl and the planes, which FCL has no quick shapes for, in
// closed form. Both paths are then looked at in small steps by the same distances.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fmt/format.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/workcell.hpp"
#include "planner/arm_clearance.hpp"
#include "planner/compensation.hpp"
#include "planner/trapezoid_timing.hpp"
#include "planner/visit_plan.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::benchmarks {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using namespace planner;
using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;
using Waypoints = std::vector<VectorXd>;

constexpr double kInch = 0.0254;
constexpr double kSolveSeconds = 5;  // for one travel; RRTConnect mostly needs a thousandth of it

/// Wall and processor time since it was made.
class Watch {
 public:
  [[nodiscard]] double wall() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  [[nodiscard]] double processor() const { return static_cast<double>(std::clock() - ticks_) / CLOCKS_PER_SEC; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  std::clock_t ticks_ = std::clock();
};

/// A solid as FCL has it, grown by `padding`; a capsule grows wholly, others with their flat faces.
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

/// Whether a posture is free, by FCL.
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

  /// `may_enter`: the tool may touch what the scene lets it, as on an approach.
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
        if (std::abs(groups_[i] - groups_[k]) > 1 && !mayTouch(scene.bodies[k], body) &&
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
      return true;  // thrown on touching bodies
    }
  }

  const Workcell& cell_;
  double padding_;
  std::vector<int> groups_ = rigidGroups(cell_.scene);
  std::vector<LibraryBody> padded_, plain_, obstacles_;
};

/// What either way of planning comes to.
struct Outcome {
  std::string name;
  int visits = 0, asked = 0, detours = 0, failed = 0;
  double wall = 0, processor = 0;  ///< s
  long checks = 0;                 ///< of postures by the library
  std::vector<Waypoints> travels;
};

struct LibraryOptions {
  std::uint64_t seed;
  double most_seconds;
};

/// Standoffs of the first free posture of each tube.
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
  const auto active = deflection::activeRows(arm);
  const auto space = std::make_shared<ob::RealVectorStateSpace>();
  for (const int row : active) {
    const auto& joint = arm.rows[static_cast<std::size_t>(row)].joint;
    space->addDimension(joint.lower, joint.upper);
  }
  return space;
}

VectorXd postureOf(const ob::State* state, Eigen::Index joints) {
  return Eigen::Map<const VectorXd>(state->as<ob::RealVectorStateSpace::StateType>()->values, joints);
}

/// Empty where no exact solution was found.
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

Outcome planByLibraries(const Workcell& cell, const std::vector<int>& tubes, const LibraryOptions& options) {
  Outcome outcome;
  outcome.name = "OMPL + FCL";
  const Watch watch;
  double bow = 0, greatest_bow = 0;
  for (const auto& q : deflection::latticeStarts(cell.arm, 96))
    if (!bodyFrames(cell, q, &bow).empty()) greatest_bow = std::max(greatest_bow, bow);
  const LibraryChecker checker(cell, cell.scene.clearance + greatest_bow);
  const Waypoints order = nearestNeighbourOrder(libraryStandoffs(cell, tubes, checker), jointSpeedsOf(cell.arm));
  outcome.asked = static_cast<int>(tubes.size());
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

Outcome planByOwn(const Workcell& cell, const std::vector<int>& tubes, std::uint64_t seed) {
  Outcome outcome;
  outcome.name = "tubeplan";
  VisitPlanOptions options;
  options.seed = seed;
  const Watch watch;
  const VisitPlan plan = planVisits(cell, tubes, options);
  outcome.wall = watch.wall();
  outcome.processor = watch.processor();
  outcome.asked = static_cast<int>(tubes.size());
  outcome.visits = static_cast<int>(plan.visits.size());
  outcome.detours = plan.detours;
  for (const PathSegment& segment : plan.segments)
    if (segment.kind == SegmentKind::kTravel) outcome.travels.push_back(segment.waypoints);
  return outcome;
}

/// The travels of an outcome, looked at closely.
struct Look {
  double time = 0;           ///< s, at rest at every waypoint
  double straight_time = 0;  ///< s, were every travel a straight move: the order and the postures alone
  double flowing_time = 0;   ///< s, at best, without a rest on the way
  double least_clearance = std::numeric_limits<double>::infinity();  ///< m
  int below_clearance = 0, colliding = 0;                            ///< travels
};

double flowingTime(const Waypoints& travel, const JointSpeeds& speeds) {
  VectorXd way = VectorXd::Zero(travel.front().size());
  for (std::size_t k = 1; k < travel.size(); ++k) way += (travel[k] - travel[k - 1]).cwiseAbs();
  return moveDuration(VectorXd::Zero(way.size()), way, speeds);
}

Look lookAt(const Workcell& cell, const std::vector<Waypoints>& travels, int samples) {
  const ArmClearance clearance(cell);
  const JointSpeeds speeds = jointSpeedsOf(cell.arm);
  Look look;
  for (const Waypoints& travel : travels) {
    const TimedPolyline timed = timePolyline(travel, speeds);
    look.time += timed.duration;
    look.straight_time += straightMoveDuration(travel.front(), travel.back(), speeds);
    look.flowing_time += flowingTime(travel, speeds);
    double least = std::numeric_limits<double>::infinity();
    const int each = std::max(2, samples / std::max(1, static_cast<int>(travel.size()) - 1));
    for (std::size_t k = 1; k < travel.size(); ++k)
      for (int i = 0; i <= each; ++i) {
        const VectorXd q = travel[k - 1] + double(i) / each * (travel[k] - travel[k - 1]);
        least = std::min(least, clearance.at(q, ContactRule::kTravel).distance);
      }
    look.least_clearance = std::min(look.least_clearance, least);
    look.below_clearance += least < cell.scene.clearance;
    look.colliding += least < 0;
  }
  return look;
}

nlohmann::json report(const Outcome& outcome, const Look& look) {
  fmt::print("{:>6} {:<12} {:>6} {:>9.2f} {:>9.2f} {:>10.1f} {:>10.1f} {:>10.1f} {:>8} {:>7} {:>11.4f} {:>8} {:>8}\n",
             outcome.asked, outcome.name, outcome.visits, outcome.processor, outcome.wall, look.straight_time,
             look.flowing_time, look.time, outcome.detours, outcome.failed, look.least_clearance / kInch,
             look.below_clearance, look.colliding);
  return {{"asked", outcome.asked},
          {"by", outcome.name},
          {"visits", outcome.visits},
          {"processor_s", outcome.processor},
          {"wall_s", outcome.wall},
          {"travel_time_s", look.time},
          {"straight_time_s", look.straight_time},
          {"travel_time_without_rests_s", look.flowing_time},
          {"detours", outcome.detours},
          {"without_path", outcome.failed},
          {"least_clearance_in", look.least_clearance / kInch},
          {"travels", outcome.travels.size()},
          {"travels_below_clearance", look.below_clearance},
          {"travels_colliding", look.colliding},
          {"library_checks", outcome.checks}};
}

}  // namespace
}  // namespace tubeplan::benchmarks

int main(int argc, char** argv) {
  using namespace tubeplan;
  using namespace tubeplan::benchmarks;
  CLI::App cli{"Tubes visited by OMPL and FCL alone, beside this planner"};
  std::string file = TUBEPLAN_SOURCE_DIR "/app/cells/mockup.yaml", json;
  std::vector<std::string> lists{"spread:60", "spread:500"};
  LibraryOptions options{1, 180};
  int samples = 1000;
  cli.add_option("--cell", file, "the cell file")->capture_default_str();
  cli.add_option("--tubes", lists, "work lists, one after another");
  cli.add_option("--seed", options.seed, "of both")->capture_default_str();
  cli.add_option("--seconds", options.most_seconds, "of processor time, after which the libraries are stopped")
      ->capture_default_str();
  cli.add_option("--samples", samples, "of each travel, when its clearance is looked at")->capture_default_str();
  cli.add_option("--json", json, "write the figures to this file");
  CLI11_PARSE(cli, argc, argv);
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(options.seed));
  const planner::Workcell cell = app::workcellOf(app::readCell(file), "compare plans");
  fmt::print("{:>6} {:<12} {:>6} {:>9} {:>9} {:>10} {:>10} {:>10} {:>8} {:>7} {:>11} {:>8} {:>8}\n", "tubes", "by",
             "visits", "cpu s", "wall s", "straight s", "no rests s", "travel s", "detours", "no path", "nearest in",
             "too near", "collide");
  nlohmann::json rows = nlohmann::json::array();
  for (const std::string& list : lists) {
    const auto tubes = tubesheets::selectTubes(cell.sheet, list).tube_indices;
    for (const Outcome& outcome : {planByOwn(cell, tubes, options.seed), planByLibraries(cell, tubes, options)})
      rows.push_back(report(outcome, lookAt(cell, outcome.travels, samples)));
  }
  if (!json.empty()) std::ofstream(json) << rows.dump(1) << "\n";
  return 0;
}
