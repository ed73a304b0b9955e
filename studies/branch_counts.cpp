// Study of the inverse kinematics of each arm: how many of the postures found from random starts it misses, how many
// false postures it returns, and how many tubes it solves per second. No posture should be missed or false.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "tests/planner/reach/branch_count.hpp"

int main(int argc, char** argv) {
  using namespace tubeplan::planner::testing;
  CLI::App cli{"Branches against random starts"};
  int holes = 500, starts = 100000;
  std::string only;
  cli.add_option("--holes", holes, "of each arm");
  cli.add_option("--starts", starts, "of each hole");
  cli.add_option("--arm", only, "whose name has this in it");
  CLI11_PARSE(cli, argc, argv);

  fmt::print("{:<20} {:>6} {:>9} {:>8} {:>9} {:>8} {:>7} {:>8} {:>9}\n", "arm", "holes", "starts", "brute", "missed",
             "without", "own", "false", "tubes/s");
  long missed = 0, wrong = 0;
  for (const auto& arm : countedArms(holes)) {
    if (arm.name.find(only) == std::string::npos || arm.places_W.empty()) continue;
    const BranchCount count = countBranches(arm.cell, arm.places_W, starts, 1);
    fmt::print("{:<20} {:>6} {:>9} {:>8} {:>9} {:>8} {:>7} {:>8} {:>9.0f}\n", arm.name, count.goals, starts,
               count.brute, count.missed, count.without, count.branches, count.wrong, count.goals / count.seconds);
    std::fflush(stdout);
    missed += count.missed;
    wrong += count.wrong;
  }
  return missed > 0 || wrong > 0;
}
