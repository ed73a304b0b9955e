// Benchmark of the visit order and its lower bound on all cores: computing time and largest gap to the optimum, for
// work lists of the mock-up and for the whole sheet, with straight joint moves.
#include <benchmark/benchmark.h>

#include "app/formats/cell/workcell.hpp"
#include "planner/order/visit_order.hpp"
#include "planner/reach/tube_reach.hpp"
#include "planner/real_order.hpp"
#include "studies/benchmarks/run_benchmarks.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::benchmarks {
namespace {

using namespace planner;

Route routeTo(const Workcell& cell, const std::string& list) {
  const ArmClearance clearance(cell);
  std::vector<TubeReach> reach;
  for (const int tube : tubesheets::selectTubes(cell.sheet, list).tube_indices) {
    TubeReach one = reachTube(clearance, tube);
    if (one.status == ReachStatus::kReachable) reach.push_back(std::move(one));
  }
  return routeOf(allBranches(std::move(reach)), jointSpeedsOf(cell.arm), {});
}

void order(benchmark::State& state, const std::string& list) {
  const Workcell cell =
      app::workcellOf(app::readCell(TUBEPLAN_SOURCE_DIR "/app/cells/mockup.yaml"), "time the order of visits");
  const Route route = routeTo(cell, list);
  VisitOrder found;
  for (auto _ : state) found = orderVisits(route);
  if (found.status != VisitOrderStatus::kSolved) state.SkipWithError(found.reason.c_str());
  state.counters["visits"] = static_cast<double>(found.order.size());
  state.counters["gap_%"] = 100 * found.optimality_gap;
}

void registerAll() {
  for (const char* list : {"spread:50", "spread:100", "spread:200", "spread:500", "all"})
    benchmark::RegisterBenchmark((std::string("order/") + list).c_str(), order, list)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

}  // namespace
}  // namespace tubeplan::benchmarks

int main(int argc, char** argv) {
  tubeplan::benchmarks::registerAll();
  return tubeplan::benchmarks::runBenchmarks(argc, argv);
}
