// `tubeplan score --runs`: repeats the experiment of the thesis with true arms whose base pose and stiffnesses are
// drawn at random about those of the given arm.
#pragma once

#include <cstdint>
#include <vector>

#include "app/commands/figures_target.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

struct ScoredRunsOptions {
  FiguresTarget figures;
  int runs = 0;
  double unmodelled = -1;  ///< standard deviation per coordinate, in the cell's length unit; negative: default
  double stiffness = -1;   ///< relative standard deviation of the true arm's stiffnesses; negative: default
  std::uint64_t seed = 1;
};

/// Runs the experiment with holes drawn from `tubes`, and prints the results. Returns the command's exit code.
[[nodiscard]] int scoreRuns(const ScoredRunsOptions& options, const std::vector<int>& tubes,
                            const planner::Workcell& model, const planner::Workcell& truth, const Cell& cell);

}  // namespace tubeplan::app
