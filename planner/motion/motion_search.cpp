#include "planner/motion/motion_search.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "planner/motion/unit_random.hpp"

namespace tubeplan::planner {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Eigen::VectorXd;
using Space = ob::RealVectorStateSpace;

/// Coordinates of the search in metres of travel, so that one step length suits revolute and prismatic joints, near the
/// base or the tip.
struct TravelCoordinates {
  VectorXd scale;  ///< travel per rad (or m) of each joint [m]
  VectorXd lower, upper;

  static TravelCoordinates of(const VectorXd& q0, const VectorXd& q1, const MotionProblem& problem) {
    const VectorXd& reach = problem.travel.reach_per_joint;
    const double floor = reach.maxCoeff() > 0 ? 1e-3 * reach.maxCoeff() : 1.0;
    const auto finiteOr = [](double limit, double instead) { return std::isfinite(limit) ? limit : instead; };
    TravelCoordinates coordinates{reach.cwiseMax(floor), problem.lower, problem.upper};
    for (Eigen::Index j = 0; j < q0.size(); ++j) {
      coordinates.lower[j] = finiteOr(problem.lower[j], std::min(q0[j], q1[j]) - std::numbers::pi);
      coordinates.upper[j] = finiteOr(problem.upper[j], std::max(q0[j], q1[j]) + std::numbers::pi);
    }
    return coordinates;
  }

  VectorXd posture(const ob::State* state) const {
    const double* x = state->as<Space::StateType>()->values;
    return Eigen::Map<const VectorXd>(x, scale.size()).cwiseQuotient(scale);
  }
  void write(const VectorXd& q, ob::State* state) const {
    Eigen::Map<VectorXd>(state->as<Space::StateType>()->values, scale.size()) = q.cwiseProduct(scale);
  }
};

/// A sampler with its own seed; OMPL's own samplers share a seed that is global to the process.
class SeededSampler : public ob::StateSampler {
 public:
  SeededSampler(const ob::StateSpace* space, std::uint64_t seed) : ob::StateSampler(space), generator_(seed) {}

  void sampleUniform(ob::State* state) override {
    const ob::RealVectorBounds& bounds = space_->as<Space>()->getBounds();
    for (std::size_t j = 0; j < bounds.low.size(); ++j) set(state, j, bounds.low[j], bounds.high[j]);
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    const ob::RealVectorBounds& bounds = space_->as<Space>()->getBounds();
    for (std::size_t j = 0; j < bounds.low.size(); ++j) {
      const double centre = near->as<Space::StateType>()->values[j];
      set(state, j, std::max(bounds.low[j], centre - distance), std::min(bounds.high[j], centre + distance));
    }
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    sampleUniformNear(state, mean, 2 * deviation);
  }

 private:
  void set(ob::State* state, std::size_t j, double low, double high) {
    state->as<Space::StateType>()->values[j] = randomBetween(low, high, generator_);
  }
  std::mt19937_64 generator_;
};

/// Data shared by the posture and motion checkers: the problem, and counts of the postures checked and of the pairs
/// that blocked them.
struct Referee {
  const MotionProblem& problem;
  const MotionPlannerOptions& options;
  TravelCoordinates coordinates;
  MotionSearchResult result;

  bool postureFree(const VectorXd& q) {
    ++result.checks;
    const Clearance clearance = problem.clearance_of(q);
    const bool free = clearance.margin >= 0;
    if (!free) ++result.blockers[{clearance.body, clearance.other}];
    return free;
  }

  bool motionFree(const VectorXd& from, const VectorXd& to) {
    const MotionCheckResult check = checkMotion(from, to, problem.clearance_of, problem.travel, options.check);
    result.checks += check.checks;
    const bool free = check.status == MotionCheckStatus::kFree;
    if (!free) ++result.blockers[{check.tightest.body, check.tightest.other}];
    return free;
  }
};

class PostureChecker : public ob::StateValidityChecker {
 public:
  PostureChecker(const ob::SpaceInformationPtr& information, Referee& referee)
      : ob::StateValidityChecker(information), referee_(referee) {}
  bool isValid(const ob::State* state) const override {
    return referee_.postureFree(referee_.coordinates.posture(state));
  }

 private:
  Referee& referee_;
};

class MotionProver : public ob::MotionValidator {
 public:
  MotionProver(const ob::SpaceInformationPtr& information, Referee& referee)
      : ob::MotionValidator(information), referee_(referee) {}
  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return referee_.motionFree(referee_.coordinates.posture(from), referee_.coordinates.posture(to));
  }
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    last_valid.second = 0;
    return checkMotion(from, to);
  }

 private:
  Referee& referee_;
};

ob::StateSpacePtr makeSpace(const TravelCoordinates& coordinates, std::uint64_t seed) {
  const auto dimensions = static_cast<unsigned>(coordinates.scale.size());
  auto space = std::make_shared<Space>(dimensions);
  ob::RealVectorBounds bounds(dimensions);
  for (unsigned j = 0; j < dimensions; ++j) {
    bounds.setLow(j, coordinates.lower[j] * coordinates.scale[j]);
    bounds.setHigh(j, coordinates.upper[j] * coordinates.scale[j]);
  }
  space->setBounds(bounds);
  space->setStateSamplerAllocator(
      [seed](const ob::StateSpace* of) { return std::make_shared<SeededSampler>(of, seed); });
  return space;
}

/// Returns the path's postures. The first and last are exactly the start and the goal, without rounding errors from
/// scaling.
std::vector<VectorXd> waypointsOf(const og::PathGeometric& path, const TravelCoordinates& coordinates,
                                  const VectorXd& q0, const VectorXd& q1) {
  std::vector<VectorXd> waypoints;
  for (std::size_t i = 0; i < path.getStateCount(); ++i) waypoints.push_back(coordinates.posture(path.getState(i)));
  waypoints.front() = q0;
  waypoints.back() = q1;
  return waypoints;
}

bool allStretchesFree(const std::vector<VectorXd>& waypoints, Referee& referee) {
  for (std::size_t i = 1; i < waypoints.size(); ++i)
    if (!referee.motionFree(waypoints[i - 1], waypoints[i])) return false;
  return true;
}

}  // namespace

// Searches with OMPL 1.5.2, with precautions against its faults. Every query has a new planner, space and problem
// definition, because trees of an earlier query are not completely discarded. Neighbours are in a linear list, because
// the tree-shaped list is wrong after a rebuild and draws from the global random generator. Only exact solutions are
// accepted, because an approximate solution may start at the goal. The whole path is proved a second time.
MotionSearchResult searchMotion(const VectorXd& q0, const VectorXd& q1, const MotionProblem& problem,
                                const MotionPlannerOptions& options) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  Referee referee{problem, options, TravelCoordinates::of(q0, q1, problem), {}};
  const auto information = std::make_shared<ob::SpaceInformation>(makeSpace(referee.coordinates, options.seed));
  information->setStateValidityChecker(std::make_shared<PostureChecker>(information, referee));
  information->setMotionValidator(std::make_shared<MotionProver>(information, referee));
  information->setup();

  const auto definition = std::make_shared<ob::ProblemDefinition>(information);
  ob::ScopedState<> start(information), goal(information);
  referee.coordinates.write(q0, start.get());
  referee.coordinates.write(q1, goal.get());
  definition->setStartAndGoalStates(start, goal);

  og::RRTConnect planner(information);
  planner.setProblemDefinition(definition);
  planner.setRange(options.range > 0 ? options.range : 0.2 * information->getMaximumExtent());
  planner.setNearestNeighbors<ompl::NearestNeighborsLinear>();
  int& iterations = referee.result.iterations;
  const ob::PlannerTerminationCondition spent([&] { return ++iterations > options.max_iterations; });
  const ob::PlannerStatus status = planner.solve(spent);
  if (status == ob::PlannerStatus::EXACT_SOLUTION) {
    const auto& path = *definition->getSolutionPath()->as<og::PathGeometric>();
    auto waypoints = waypointsOf(path, referee.coordinates, q0, q1);
    if (allStretchesFree(waypoints, referee)) referee.result.waypoints = std::move(waypoints);
  }
  iterations = std::min(iterations, options.max_iterations);
  return referee.result;
}

}  // namespace tubeplan::planner
