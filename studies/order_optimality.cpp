// Study of visit orders and their lower bounds relative to the optimum with straight joint moves, for each shipped arm.
// For few tubes, dynamic programming over sets of tubes gives the exact optimum (Held and Karp 1962, with a state for
// each posture).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <ctime>

#include "planner/order/posture_table.hpp"
#include "planner/real_order.hpp"
#include "tests/planner/workcell.hpp"

namespace {

using namespace tubeplan;
using namespace tubeplan::planner;
using namespace tubeplan::planner::testing;

/// Returns the exact minimum time over all orders and postures [s].
double optimumOf(const Route& route) {
  const PostureTable table(route);
  const int visits = table.visits(), postures = table.postures();
  const std::size_t sets = std::size_t{1} << visits;
  std::vector<float> least(sets * static_cast<std::size_t>(postures), std::numeric_limits<float>::infinity());
  std::vector<float> between(static_cast<std::size_t>(postures * postures));
  for (int p = 0; p < postures; ++p)
    for (int q = 0; q < postures; ++q)
      between[static_cast<std::size_t>(p * postures + q)] = float(table.straight(p, q));
  const auto at = [&](std::size_t set, int p) -> float& { return least[set * postures + static_cast<std::size_t>(p)]; };
  for (int p = 0; p < postures; ++p) at(std::size_t{1} << table.nodeOf(p), p) = 0;
  for (std::size_t set = 1; set < sets; ++set)
    for (int v = 0; v < visits; ++v) {
      if (!(set >> v & 1)) continue;
      for (int p = table.first(v); p < table.last(v); ++p) {
        const float time_before = at(set, p);
        if (!std::isfinite(time_before)) continue;
        for (int w = 0; w < visits; ++w) {
          if (set >> w & 1) continue;
          const std::size_t next = set | std::size_t{1} << w;
          for (int q = table.first(w); q < table.last(w); ++q)
            at(next, q) = std::min(at(next, q), time_before + between[static_cast<std::size_t>(p * postures + q)]);
        }
      }
    }
  float best = std::numeric_limits<float>::infinity();
  for (int p = 0; p < postures; ++p) best = std::min(best, at(sets - 1, p));
  return best;
}

Route routeOver(const Workcell& cell, const std::string& list) {
  const ArmClearance clearance(cell);
  std::vector<TubeReach> reach;
  for (const int tube : tubesOf(cell, list)) {
    reach.push_back(reachTube(clearance, tube));
    if (reach.back().status != ReachStatus::kReachable) reach.pop_back();
  }
  return routeOf(allBranches(std::move(reach)), jointSpeedsOf(cell.arm), {});
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli{"Orders and bounds against the optimum"};
  int exact = 12, many = 100, effort = 1;
  std::uint64_t seed = 1;
  std::string only;
  cli.add_option("--exact", exact, "tubes of the exact solution");
  cli.add_option("--many", many, "tubes without it");
  cli.add_option("--effort", effort, "times as many kicks of the search");
  cli.add_option("--seed", seed, "of the search");
  cli.add_option("--arm", only, "whose file has this in its name");
  CLI11_PARSE(cli, argc, argv);
  fmt::print("{:<16} {:>5} {:>8} {:>9} {:>9} {:>9} {:>8} {:>8} {:>7}\n", "arm", "tubes", "postures", "optimum", "order",
             "bound", "order %", "bound %", "CPU s");
  for (const std::string file : {"mockup.yaml", "tsm-cobra.yaml", "column.yaml", "puma.yaml", "iiwa.yaml"}) {
    if (file.find(only) == std::string::npos) continue;
    const Workcell cell = mockup(file);
    for (const int count : {exact, many}) {
      const Route route = routeOver(cell, fmt::format("spread:{}", count));
      std::size_t postures = 0;
      for (const auto& visit : route.visits) postures += visit.branches.size();
      const double optimum = count == exact ? optimumOf(route) : std::numeric_limits<double>::quiet_NaN();
      const std::clock_t before = std::clock();
      VisitOrderOptions options;
      options.seed = seed;
      options.kicks_per_visit *= effort;
      options.least_kicks *= effort;
      options.most_kicks *= effort;
      const VisitOrder order = orderVisits(route, options);
      const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
      const double best = count == exact ? optimum : order.travel_time;
      fmt::print("{:<16} {:>5} {:>8} {:>9.3f} {:>9.3f} {:>9.3f} {:>8.2f} {:>8.2f} {:>7.2f}\n", file,
                 route.visits.size(), postures, optimum, order.travel_time, order.lower_bound,
                 100 * (order.travel_time / best - 1), 100 * (1 - order.lower_bound / best), seconds);
      std::fflush(stdout);
    }
  }
}
