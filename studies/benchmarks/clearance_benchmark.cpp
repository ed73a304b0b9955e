// Benchmark of the clearance of a posture and of a move in the mock-up cell, computed by the program's distance queries
// and by the library FCL in the same run. The deflected shape of the arm, which both need at every posture, is timed
// separately.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "app/formats/cell/workcell.hpp"
#include "deflection/frames_along_chords.hpp"
#include "deflection/prepared_arm.hpp"
#include "planner/collision/arm_clearance.hpp"
#include "planner/collision/nearest_pairs.hpp"
#include "planner/motion/motion_check.hpp"
#include "planner/motion/side_by_side.hpp"
#include "planner/reach/tube_reach.hpp"
#include "planner/scene/separation.hpp"
#include "studies/benchmarks/run_benchmarks.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::benchmarks {
namespace {

using namespace planner;
using Eigen::Isometry3d, Eigen::VectorXd;
using Clock = std::chrono::steady_clock;

struct Move {
  VectorXd from, to;
};

/// Cell, with moves all over the sheet between the standoff postures of neighbouring tubes in the same branch.
struct Bench {
  const Workcell cell = app::workcellOf(app::readCell(TUBEPLAN_SOURCE_DIR "/app/cells/mockup.yaml"), "time clearance");
  const ArmClearance clearance{cell};
  std::vector<Move> moves;

  Bench() {
    for (const char* pair :
         {"R5C30,R5C31", "R5C85,R6C85", "R10C20,R10C21", "R10C57,R11C57", "R15C40,R15C41", "R20C80,R21C80",
          "R20C57,R20C58", "R25C30,R25C31", "R30C90,R31C90", "R35C45,R35C46", "R8C100,R8C101"}) {
      const auto tubes = tubesheets::selectTubes(cell.sheet, pair).tube_indices;
      const TubeReach a = reachTube(clearance, tubes.at(0)), b = reachTube(clearance, tubes.at(1));
      for (const TubeBranch& from : a.branches)
        for (const TubeBranch& to : b.branches)
          if ((from.q - to.q).cwiseAbs().maxCoeff() < 0.3)
            moves.push_back({from.approach.front(), to.approach.front()});
    }
  }

  /// Returns the standoff postures; their number is a multiple of the number of kernel lanes.
  [[nodiscard]] PostureColumns standoffs() const {
    PostureColumns q(moves.front().from.size(), 64);
    for (Eigen::Index k = 0; k < q.cols(); ++k) q.col(k) = moves[static_cast<std::size_t>(k) % moves.size()].from;
    return q;
  }
};

const Bench& bench() {
  static const Bench made;
  return made;
}

/// Returns the smallest distance between bodies, or between a body and an obstacle, minus the required clearance [m].
/// FCL computes the distances between solids.
double marginByLibrary(const Scene& scene, const std::vector<Isometry3d>& X_WL) {
  double least = std::numeric_limits<double>::infinity();
  const auto solidOf = [](const ShapePointer& shape) { return dynamic_cast<const Solid*>(shape.get()); };
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    const Isometry3d& X_WB = X_WL[static_cast<std::size_t>(body.frame_index)];
    const Solid& solid = *solidOf(body.shape);
    for (const Obstacle& obstacle : scene.obstacles) {
      if (mayTouch(obstacle, body)) continue;
      const Solid* other = solidOf(obstacle.shape);
      least = std::min(least, (other ? separationByLibrary(X_WB, solid, Isometry3d::Identity(), *other)
                                     : obstacle.shape->separationFrom(X_WB, solid))
                                  .distance);
    }
    for (std::size_t k = 0; k < i; ++k) {
      const Body& other = scene.bodies[k];
      if (!areJudged(scene, static_cast<int>(k), static_cast<int>(i)) || mayTouch(other, body)) continue;
      const Isometry3d& X_WO = X_WL[static_cast<std::size_t>(other.frame_index)];
      least = std::min(least, separationByLibrary(X_WB, solid, X_WO, *solidOf(other.shape)).distance);
    }
  }
  return least - scene.clearance;
}

void shape(benchmark::State& state) {
  std::size_t k = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(bodyFrames(bench().cell, bench().moves[k++ % bench().moves.size()].from, nullptr));
}

void distancesByLibrary(benchmark::State& state) {
  std::vector<std::vector<Isometry3d>> frames;
  for (const Move& move : bench().moves) frames.push_back(bodyFrames(bench().cell, move.from, nullptr));
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(marginByLibrary(bench().cell.scene, frames[k++ % frames.size()]));
}

/// Measures the distance queries at the standoff postures, one posture at a time or one per kernel lane.
void distances(benchmark::State& state, bool side_by_side) {
  static const NearestPairs pairs(bench().cell.scene);
  const PostureColumns q = bench().standoffs();
  deflection::RowPlacing placing(bench().cell.arm, bench().cell.load, bench().cell.X_WB);
  const int at_once = side_by_side ? placing.lanes() : 1;
  std::vector<deflection::PlacedRows> blocks;
  for (Eigen::Index first = 0; first + at_once <= q.cols(); first += at_once)
    blocks.push_back(side_by_side ? placing.place(q, first) : placing.place(q.col(first)));
  std::vector<NearestPair> found(static_cast<std::size_t>(at_once));
  std::size_t k = 0;
  while (state.KeepRunningBatch(at_once)) {
    pairs.find(blocks[k++ % blocks.size()], found);
    benchmark::DoNotOptimize(found.data());
  }
}

/// Measures the deflected shape together with the distance queries.
template <class ClearanceAt>
void postures(benchmark::State& state, const ClearanceAt& clearance_at) {
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(clearance_at(bench().moves[k++ % bench().moves.size()].from));
}

void posturesSideBySide(benchmark::State& state) {
  const PostureColumns q = bench().standoffs();
  while (state.KeepRunningBatch(q.cols()))
    benchmark::DoNotOptimize(bench().clearance.together(q, ContactRule::kApproach));
}

/// Times the proofs that moves are collision-free, and reports the mean and the median over all moves.
void proveMoves(benchmark::State& state, const PostureClearance& clearance_of) {
  const auto& moves = bench().moves;
  std::vector<double> seconds, checks;
  std::size_t k = 0;
  for (auto _ : state) {
    const Move& move = moves[k++ % moves.size()];
    const auto start = Clock::now();
    const auto result = checkMotion(move.from, move.to, clearance_of, bench().clearance.travel());
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    checks.push_back(result.checks);
    if (result.status != MotionCheckStatus::kFree) state.SkipWithError("a move is not free");
  }
  const auto median = [](std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  state.counters["median_us"] = 1e6 * median(seconds);
  state.counters["postures"] = median(checks);
  state.counters["moves"] = static_cast<double>(moves.size());
}

void registerAll() {
  const auto us = benchmark::kMicrosecond;
  benchmark::RegisterBenchmark("posture/shape", shape)->Unit(us);
  benchmark::RegisterBenchmark("posture/distances", distances, false)->Unit(us);
  benchmark::RegisterBenchmark("posture/distances/side by side", distances, true)->Unit(us);
  benchmark::RegisterBenchmark("posture/distances/fcl", distancesByLibrary)->Unit(us);
  const auto at = [](const VectorXd& q) { return bench().clearance.at(q, ContactRule::kApproach); };
  const auto atByLibrary = [](const VectorXd& q) {
    double bow = 0;
    const auto frames = bodyFrames(bench().cell, q, &bow);
    Clearance clearance;
    clearance.margin = marginByLibrary(bench().cell.scene, frames) - bow;
    clearance.distance = clearance.margin + bench().cell.scene.clearance;
    return clearance;
  };
  benchmark::RegisterBenchmark("posture", [=](benchmark::State& s) { postures(s, at); })->Unit(us);
  benchmark::RegisterBenchmark("posture/side by side", posturesSideBySide)->Unit(us);
  benchmark::RegisterBenchmark("posture/fcl", [=](benchmark::State& s) { postures(s, atByLibrary); })->Unit(us);
  static const PostureClearance together = sideBySide(bench().clearance, ContactRule::kApproach, 0);
  benchmark::RegisterBenchmark("neighbour move", [=](benchmark::State& s) { proveMoves(s, together); })->Unit(us);
  benchmark::RegisterBenchmark("neighbour move/one by one", [=](benchmark::State& s) { proveMoves(s, at); })->Unit(us);
  benchmark::RegisterBenchmark("neighbour move/fcl", [=](benchmark::State& s) {
    proveMoves(s, atByLibrary);
  })->Unit(us);
}

}  // namespace
}  // namespace tubeplan::benchmarks

int main(int argc, char** argv) {
  tubeplan::benchmarks::registerAll();
  return tubeplan::benchmarks::runBenchmarks(argc, argv);
}
