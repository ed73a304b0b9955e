#include "calibration/estimation/widened_sizes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "calibration/estimation/size_modes.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::calibration {

using Eigen::Index;

namespace {

bool isSizeOf(const Unknown& unknown, int effect, const deflection::Arm& arm) {
  if (unknown.owner != Unknown::Owner::kArm || unknown.path.effect != effect) return false;
  const auto& numbers = deflection::numbersOf(arm.effects[static_cast<std::size_t>(effect)]);
  const auto& number = numbers[static_cast<std::size_t>(unknown.path.value)];
  return !number.is_shape && number.quantity != deflection::Quantity::kTime;
}

std::string noteOn(const SizeModes& modes) {
  std::vector<std::string> kinds;
  for (const auto kind : modes.decided_by) kinds.emplace_back(kindOf(kind).name);
  return fmt::format("one of {} values that explain the readings equally{}", modes.states.size(),
                     kinds.empty() ? "" : fmt::format("; one reading of kind {} decides", fmt::join(kinds, " or ")));
}

void widen(const SizeModes& modes, IdentifiedNumber& number) {
  for (PlacedArm state : modes.states) number.modes.push_back(deflection::locate(state.arm, number.unknown.path));
  const auto [least, most] = std::ranges::minmax_element(number.modes);
  number.lower = std::min(number.lower, *least - 2 * number.sigma);
  number.upper = std::max(number.upper, *most + 2 * number.sigma);
  number.note = noteOn(modes);
}

}  // namespace

void widenSizes(const FittedModel& model, Identification& result) {
  if (std::ranges::none_of(model.fitted, [](const Measurement& m) { return kindOf(m).counts_steps; })) return;
  const auto unknowns = fittedUnknowns(result);
  const int effects = static_cast<int>(result.fitted.arm.effects.size());
  for (int effect = 0; effect < effects; ++effect) {
    SizeModesQuestion question{result.fitted, unknowns, {}, {}, model.fitted, result.model_error,
                               model.options.hooks.stop};
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      if (isSizeOf(unknowns[k], effect, result.fitted.arm)) question.sizes.push_back(k);
    const std::vector<Index> places(question.sizes.begin(), question.sizes.end());
    question.sigma = result.covariance.diagonal()(places).cwiseSqrt();
    const SizeModes modes = findSizeModes(question);
    if (modes.states.size() < 2) continue;
    for (const std::size_t k : question.sizes) widen(modes, result.numbers[k]);
  }
}

}  // namespace tubeplan::calibration
