// Study of equivalent forms of one task: in other units, rotated about the sheet's normal, or expressed in another base
// frame. The plan must visit the same tubes in all forms. The travel times are printed for comparison. With a tilted
// base or tilted gravity, the tubes may differ, but every tube that random starts reach must be visited.
#include "tests/planner/turned_cells.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <set>

#include "tests/planner/reach/brute_reach.hpp"
#include "tests/planner/verification/stated_plan.hpp"

namespace {

using namespace tubeplan;
using namespace tubeplan::planner;
using namespace tubeplan::planner::testing;

struct Task {
  std::string name;
  Workcell cell;
  bool is_the_same = false;
};

std::vector<Task> tasksOf(const std::string& file, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const Workcell cell = mockup(file);
  std::vector<Task> tasks{{"as shipped", cell, true}};
  for (const char* unit : {"m", "mm", "in"}) tasks.push_back({fmt::format("in {}", unit), inUnitOf(file, unit), true});
  tasks.push_back({"turned", turnedAboutTheNormal(file, uniform(generator, 0.3, 6)), true});
  tasks.push_back({"other base frame", fromAnotherBaseFrame(cell, generator), true});
  for (int k = 0; k < 3; ++k) {
    const double lean = uniform(generator, 0, 3), heading = uniform(generator, -3, 3);
    tasks.push_back({fmt::format("base leans {:.2f} deg", lean), withBaseLeaning(cell, lean, heading)});
    tasks.push_back({fmt::format("all leans {:.2f} deg", lean), withGravityLeaning(cell, lean, heading)});
  }
  tasks.push_back({"all upside down", withGravityLeaning(cell, 180, 0)});
  return tasks;
}

struct Answer {
  std::set<int> tubes;
  double travel = 0;
};

/// Returns false if the plan visits other tubes than in the first task although the tasks are equivalent, if the plan
/// cannot be proved free of collisions, or if random starts reach a tube that was refused.
bool answer(const Task& task, const std::vector<int>& tubes, int starts, Answer& first) {
  const std::clock_t before = std::clock();
  const VisitPlan plan = planVisits(task.cell, tubes);
  const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  Answer found;
  for (const auto& visit : plan.visits) found.tubes.insert(visit.tube);
  found.travel = plan.travel_time;
  if (first.tubes.empty()) first = found;
  std::vector<int> others;
  std::ranges::set_symmetric_difference(found.tubes, first.tubes, std::back_inserter(others));
  const PlanCheck check = checkPlan(task.cell, statedPlan(task.cell, plan));
  const bool is_proved = check.status == PlanCheckStatus::kProved;
  const ArmClearance clearance(task.cell);
  int refused = 0, reached = 0;
  std::string which;
  for (const int tube : tubes) {
    if (reachTube(clearance, tube).status == ReachStatus::kReachable) continue;
    ++refused;
    if (!isReachedByBruteForce(clearance, tube, starts)) continue;
    ++reached;
    which += fmt::format(" {}", tube);
  }
  fmt::print("  {:<22} {:>4} {:>7} {:>9.2f} {:>7.1f} {:>7} {:>8} {:>8} {:>7.1f}{}\n", task.name, found.tubes.size(),
             others.size(), found.travel, 100 * plan.optimality_gap, is_proved ? "yes" : "NO", refused, reached,
             seconds, which);
  if (!is_proved && !check.findings.empty()) fmt::print("    {}\n", check.findings.front());
  std::fflush(stdout);
  return is_proved && reached == 0 && (!task.is_the_same || others.empty());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli{"The same tasks in other words"};
  int count = 40, starts = 300;
  std::uint64_t seed = 1;
  std::string only, task_only;
  cli.add_option("--tubes", count, "number of tubes, spread over the sheet");
  cli.add_option("--starts", starts, "number of random starts at each tube that is refused");
  cli.add_option("--seed", seed, "seed of the random numbers");
  cli.add_option("--arm", only, "runs only arms whose file name contains this text");
  cli.add_option("--task", task_only, "runs only the tasks whose name contains this text, in addition to the first");
  CLI11_PARSE(cli, argc, argv);

  bool is_good = true;
  for (const std::string file :
       {"mockup.yaml", "tsm-cobra.yaml", "column.yaml", "puma.yaml", "iiwa.yaml", "scenes/upside-down.yaml"}) {
    if (file.find(only) == std::string::npos) continue;
    fmt::print("{}\n  {:<22} {:>4} {:>7} {:>9} {:>7} {:>7} {:>8} {:>8} {:>7}\n", file, "task", "tubes", "others",
               "travel s", "gap %", "proved", "refused", "reached", "CPU s");
    Answer first;
    const std::vector<int> tubes = tubesOf(mockup(file), fmt::format("spread:{}", count));
    for (const Task& task : tasksOf(file, seed))
      if (first.tubes.empty() || task.name.find(task_only) != std::string::npos)
        is_good &= answer(task, tubes, starts, first);
  }
  return is_good ? 0 : 1;
}
