#include "calibration/estimation/widened_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calibration/estimation/size_modes.hpp"

namespace tubeplan::calibration {

using Eigen::Index;

namespace {

bool isSizeOf(const Unknown& unknown, int effect, const deflection::Arm& arm) {
  if (unknown.owner != Unknown::Owner::kArm || unknown.path.effect != effect) return false;
  const auto& numbers = deflection::numbersOf(arm.effects[static_cast<std::size_t>(effect)]);
  return !numbers[static_cast<std::size_t>(unknown.path.value)].is_shape;
}

/// Widens the interval of the size of index `k` over all modes.
void widen(const SizeModes& found, Index k, IdentifiedNumber& number) {
  for (const SizeMode& mode : found.modes) {
    number.lower = std::min(number.lower, mode.lower[k]);
    number.upper = std::max(number.upper, mode.upper[k]);
  }
  if (found.modes.size() == 1 && found.modes.front().is_as_found) return;
  for (const SizeMode& mode : found.modes) number.modes.push_back(mode.values[k]);
  number.note = fmt::format("one of {} values that explain the readings equally{}", found.modes.size(),
                            found.decided_by.empty() ? "" : "; " + decidedByText(found.decided_by));
}

}  // namespace

void widenSizes(const FittedModel& model, Identification& result) {
  const auto unknowns = fittedUnknowns(result);
  const int effects = static_cast<int>(result.fitted.arm.effects.size());
  for (int effect = 0; effect < effects; ++effect) {
    SizeModesQuestion question{result.fitted,           unknowns, {}, {}, model.fitted, result.model_error,
                               model.options.hooks.stop};
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      if (isSizeOf(unknowns[k], effect, result.fitted.arm)) question.sizes.push_back(k);
    const std::vector<Index> places(question.sizes.begin(), question.sizes.end());
    question.sigma = result.covariance.diagonal()(places).cwiseSqrt();
    const SizeModes found = findSizeModes(question);
    if (found.modes.empty()) continue;
    for (std::size_t k = 0; k < question.sizes.size(); ++k)
      widen(found, static_cast<Index>(k), result.numbers[question.sizes[k]]);
  }
}

}  // namespace tubeplan::calibration
