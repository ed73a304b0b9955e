// The step tables of a ladder: for each of its models, how many steps of the tool would enter in how many holes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/studies/job_steps.hpp"
#include "app/studies/model/model_comparison.hpp"

namespace tubeplan::app {

struct LadderSteps {
  std::string reason;  ///< reason if there are none; else empty
  RealArm real;
  int holes = 0, out_of_reach = 0;
};

/// Returns the model with the least held-out error, or null if none could be fitted.
[[nodiscard]] const ModelComparisonRow* bestRow(const std::vector<ModelComparisonRow>& comparison);

/// Uses the best model instead of the real arm, with an error equal to the noise floor.
void standIn(const ModelComparisonRow& best, RealArm& real);

/// Adds a step table, at `holes` random holes, to every row of the comparison. Throws JobStopped.
[[nodiscard]] LadderSteps addStepTables(RealArm real, int holes, std::uint64_t seed,
                                        std::vector<ModelComparisonRow>& comparison, const WorkHooks& hooks = {});

}  // namespace tubeplan::app
