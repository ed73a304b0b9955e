// Decision of the improvement loop after a diagnosis: the cause to add, or the reason to end.
#pragma once

#include <limits>

#include "app/studies/model/improvement.hpp"

namespace tubeplan::app {

struct ImprovementDecision {
  const calibration::Explanation* cause = nullptr;  ///< cause to add; null if the loop ends
  ImprovementEnd end = ImprovementEnd::kNotRun;
  ImprovementReason reason = ImprovementReason::kNoVerdict;
  /// Values that belong to `reason`, as explained at ImprovementReason [m]; NaN if the reason has none.
  double first = std::numeric_limits<double>::quiet_NaN(), second = first;
};

/// Returns the decision on the model that was diagnosed. Its cause is one of the diagnosis's explanations.
[[nodiscard]] ImprovementDecision improvementDecision(const calibration::Diagnosis& diagnosis);

}  // namespace tubeplan::app
