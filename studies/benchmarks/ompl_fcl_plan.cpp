// Benchmark of plans for the same tubes by OMPL and FCL alone (library_plan.hpp) and by the program's planner, in one
// run. Both paths are then examined in small steps with the program's distance queries.
#include <fmt/format.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/formats/cell/workcell.hpp"
#include "planner/collision/arm_clearance.hpp"
#include "planner/timing/trapezoid_timing.hpp"
#include "planner/visit_plan.hpp"
#include "studies/benchmarks/library_plan.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::benchmarks {
namespace {

using namespace planner;
using Eigen::VectorXd;

constexpr double kInch = 0.0254;

Outcome planByOwn(const Workcell& cell, const std::vector<int>& tubes, std::uint64_t seed) {
  Outcome outcome;
  outcome.name = "tubeplan";
  VisitPlanOptions options;
  options.seed = seed;
  const Watch watch;
  const VisitPlan plan = planVisits(cell, tubes, options);
  outcome.wall = watch.wall();
  outcome.processor = watch.processor();
  outcome.requested = static_cast<int>(tubes.size());
  outcome.visits = static_cast<int>(plan.visits.size());
  outcome.detours = plan.detours;
  for (const PathSegment& segment : plan.segments)
    if (segment.kind == SegmentKind::kTravel) outcome.travels.push_back(segment.waypoints);
  return outcome;
}

/// Times and clearances of all travels of a plan, examined in small steps.
struct Look {
  double time = 0;           ///< time with a stop at every waypoint [s]
  double straight_time = 0;  ///< time of straight joint moves between the same postures in the same order [s]
  double flowing_time = 0;   ///< shortest time, without intermediate stops [s]
  double least_clearance = std::numeric_limits<double>::infinity();  ///< [m]
  /// Number of travels that come closer to an obstacle than the scene's clearance, and number of those that collide.
  int below_clearance = 0, colliding = 0;
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
             outcome.requested, outcome.name, outcome.visits, outcome.processor, outcome.wall, look.straight_time,
             look.flowing_time, look.time, outcome.detours, outcome.failed, look.least_clearance / kInch,
             look.below_clearance, look.colliding);
  return {{"asked", outcome.requested},
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
  CLI::App cli{"Tubes visited by OMPL and FCL alone, compared with this planner"};
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
