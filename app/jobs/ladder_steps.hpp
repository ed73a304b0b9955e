// The step table of a whole ladder: which arm stands for the real one, under which sheet.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/files/cell_reader.hpp"
#include "app/studies/model/model_comparison.hpp"

namespace tubeplan::app {

struct LadderStepOptions {
  std::string truth;  ///< a cell's file; empty: the best model of the ladder, with an unmodelled error
  std::string sheet;  ///< a cell's file, for its sheet and tool; empty: the truth's, else the first cell's that has one
  int holes = 1000;
  std::uint64_t seed = 1;
};

struct LadderSteps {
  std::string reason;  ///< why there are none; empty where there are
  RealArm real;
  int holes = 0, out_of_reach = 0;
};

/// Adds its step table to every row of the comparison; `cells` are those of the rows of the comparison. Throws
/// InputError for sheets that differ, JobStopped.
[[nodiscard]] LadderSteps addSteps(const LadderStepOptions& options, const std::vector<Cell>& cells,
                                   std::vector<ModelComparisonRow>& comparison, const WorkHooks& hooks = {});

/// {real_arm, unmodelled_sigma, holes, out_of_reach, seed}, or {reason}.
[[nodiscard]] nlohmann::json ladderStepsJson(const LadderSteps& steps, const LadderStepOptions& options,
                                             const Units& units);

/// One sentence on what stands for the real arm, or why there is no table.
[[nodiscard]] std::string ladderStepsText(const LadderSteps& steps, const Units& units);

}  // namespace tubeplan::app
