// `tubeplan score --runs`: the thesis's experiment repeated with true arms drawn about the given one.
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
  double unmodelled = -1;  ///< standard deviation per coordinate, in the cell's unit of length; negative: the default
  double stiffness = -1;   ///< relative standard deviation of the true arm's stiffnesses; negative: the default
  std::uint64_t seed = 1;
};

/// Runs the experiment with holes drawn from the tubes and shows its figures. Returns the exit code of the command.
[[nodiscard]] int scoreRuns(const ScoredRunsOptions& options, const std::vector<int>& tubes,
                            const planner::Workcell& model, const planner::Workcell& truth, const Cell& cell);

}  // namespace tubeplan::app
