// The step table of a whole ladder: in how many holes how many steps of the tool would go in by each of its models.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/studies/job_steps.hpp"
#include "app/studies/model/model_comparison.hpp"

namespace tubeplan::app {

struct LadderSteps {
  std::string reason;  ///< why there are none; empty where there are
  RealArm real;
  int holes = 0, out_of_reach = 0;
};

/// The model whose held-out error is least; null where none could be fitted.
[[nodiscard]] const ModelComparisonRow* bestRow(const std::vector<ModelComparisonRow>& comparison);

/// The best model for want of the real arm: what it leaves open is taken as large as the noise floor.
void standIn(const ModelComparisonRow& best, RealArm& real);

/// Adds its step table to every row of the comparison, at `holes` random holes. Throws JobStopped.
[[nodiscard]] LadderSteps addStepTables(RealArm real, int holes, std::uint64_t seed,
                                        std::vector<ModelComparisonRow>& comparison, const WorkHooks& hooks = {});

}  // namespace tubeplan::app
