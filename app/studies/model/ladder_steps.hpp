// Step tables for a comparison of models (ladder): for each model, the numbers of holes in which 0, 1, ... steps of the
// tool would enter.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/studies/job_steps.hpp"
#include "app/studies/model/model_comparison.hpp"

namespace tubeplan::app {

struct LadderSteps {
  std::string reason;  ///< reason why there are no tables; empty on success
  RealArm real;
  int holes = 0, out_of_reach = 0;
};

/// Returns the row with the smallest error of held-out measurements; null if no model could be fitted.
[[nodiscard]] const ModelComparisonRow* bestRow(const std::vector<ModelComparisonRow>& comparison);

/// Uses the best model in place of the real arm, with an unmodelled error equal to the noise floor.
void takeAsRealArm(const ModelComparisonRow& best, RealArm& real);

/// Adds a step table, for the same `holes` random holes, to every row of the comparison. Throws JobStopped if a stop is
/// requested.
[[nodiscard]] LadderSteps addStepTables(RealArm real, int holes, std::uint64_t seed,
                                        std::vector<ModelComparisonRow>& comparison, const WorkHooks& hooks = {});

}  // namespace tubeplan::app
