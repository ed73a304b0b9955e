// `tubeplan score --runs`: repeats the experiment of Calkins 1994 with true arms whose base pose and stiffnesses
// deviate randomly from the given arm.
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
  /// Standard deviation of the unmodelled tip error per coordinate, in the cell's length unit; negative selects the
  /// default.
  double unmodelled = -1;
  double stiffness = -1;  ///< relative standard deviation of the true arm's stiffnesses; negative selects the default
  std::uint64_t seed = 1;
};

/// Runs the experiment with holes drawn from `tubes`, and prints the results. Returns the command's exit code.
[[nodiscard]] int scoreRuns(const ScoredRunsOptions& options, const std::vector<int>& tubes,
                            const planner::Workcell& model, const planner::Workcell& truth, const Cell& cell);

}  // namespace tubeplan::app
