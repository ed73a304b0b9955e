// Benchmark of the mock-up's whole sheet on one core. It times the inverse kinematics at every hole: alone, with the
// approaches into the holes, and also with collision checks. It also times the scoring of visits.
#include <benchmark/benchmark.h>

#include "app/formats/cell/workcell.hpp"
#include "planner/reach/scoring.hpp"
#include "planner/reach/tube_reach.hpp"

namespace tubeplan::benchmarks {
namespace {

using namespace planner;
using deflection::BranchStatus;

struct Sheet {
  const Workcell cell = app::workcellOf(app::readCell(TUBEPLAN_SOURCE_DIR "/app/cells/mockup.yaml"), "time the sheet");
  const ArmClearance clearance{cell};
  std::vector<Eigen::Vector3d> holes_W;
  std::vector<TubeBranch> visits;  ///< visited branch of each hole, in the order of `holes_W`

  Sheet() {
    for (const auto& tube : cell.sheet.tubes)
      for (TubeBranch& branch : compensate(cell, holeCentre(tube))) {
        if (branch.status != BranchStatus::kConverged) continue;
        holes_W.push_back(holeCentre(tube));
        visits.push_back(std::move(branch));
        break;
      }
  }
};

const Sheet& sheet() {
  static const Sheet made;
  return made;
}

void postures(benchmark::State& state, bool with_approach) {
  CompensationOptions options;
  options.with_approach = with_approach;
  const Sheet& all = sheet();
  for (auto _ : state)
    for (const auto& tube : all.cell.sheet.tubes)
      benchmark::DoNotOptimize(compensate(all.cell, holeCentre(tube), options));
  state.counters["tubes"] = static_cast<double>(all.cell.sheet.tubes.size());
}

void reach(benchmark::State& state) {
  const Sheet& all = sheet();
  for (auto _ : state)
    for (std::size_t k = 0; k < all.cell.sheet.tubes.size(); ++k)
      benchmark::DoNotOptimize(reachTube(all.clearance, static_cast<int>(k)));
  state.counters["tubes"] = static_cast<double>(all.cell.sheet.tubes.size());
}

void score(benchmark::State& state) {
  const Sheet& all = sheet();
  for (auto _ : state) {
    TipPrediction tips(all.cell);
    for (std::size_t k = 0; k < all.visits.size(); ++k)
      benchmark::DoNotOptimize(scoreVisit(tips, all.cell, all.holes_W[k], all.visits[k]));
  }
  state.counters["visits"] = static_cast<double>(all.visits.size());
}

BENCHMARK_CAPTURE(postures, hole, false)->Name("sheet/postures at the holes")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(postures, approach, true)->Name("sheet/and their approaches")->Unit(benchmark::kMillisecond);
BENCHMARK(reach)->Name("sheet/and collision checks: reach")->Unit(benchmark::kMillisecond);
BENCHMARK(score)->Name("sheet/scoring")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tubeplan::benchmarks

BENCHMARK_MAIN();
