#include "calibration/diagnosis/explanations/size_sets.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/diagnosis/causes/cause.hpp"
#include "calibration/diagnosis/explanations/explanation_model.hpp"
#include "calibration/estimation/size_modes.hpp"

namespace tubeplan::calibration {

using Eigen::Index;

namespace {

constexpr double kWider = 1.2;  // a range is reported if it is wider than 4 sigmas times this factor

/// Returns the model of an explanation with all parameters of one of its effects free, except scanned ones. These free
/// parameters are the last of the unknowns.
ExplanationModel withEverySize(const FittedBasis& basis, const Explanation& explanation, int effect) {
  ExplanationModel model = modelOf(basis, explanation);
  std::erase_if(model.unknowns, [&](const Unknown& unknown) { return unknown.path.effect == effect; });
  const auto& numbers = deflection::numbersOf(model.placed.arm.effects[static_cast<std::size_t>(effect)]);
  for (std::size_t v = 0; v < numbers.size(); ++v)
    if (!numbers[v].is_shape) model.unknowns.push_back(numberUnknown(model.placed.arm, effect, static_cast<int>(v)));
  return model;
}

/// Sets one parameter of an effect to its value in the first mode. The range over all modes is set if there are
/// several, or if it is wider than the standard deviation suggests.
void takeSize(const std::vector<SizeMode>& modes, Index k, FoundNumber& number) {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (const SizeMode& mode : modes) {
    // A mode in which the parameter is zero within its uncertainty does not extend the range.
    if (mode.sigma[k] > 0 && std::abs(mode.values[k]) <= 2 * mode.sigma[k]) continue;
    lower = std::min(lower, mode.lower[k]);
    upper = std::max(upper, mode.upper[k]);
  }
  number.value = modes.front().values[k];
  const double sigma = std::max(modes.front().sigma[k], std::max(0., upper - lower) / 4);
  number.sigma = sigma > 0 ? sigma : kNotKnown;
  number.is_beyond_usual = number.is_beyond_usual && modes.size() == 1;
  if (!(upper > lower) || (modes.size() == 1 && upper - lower <= kWider * 4 * modes.front().sigma[k])) return;
  number.lower = lower;
  number.upper = upper;
}

void findSizeSet(const FittedBasis& basis, int effect, Explanation& explanation, FoundEffect& found) {
  const ExplanationModel model = withEverySize(basis, explanation, effect);
  SizeModesQuestion question{model.placed,       model.unknowns,          {},        {},
                             basis.measurements, explanation.model_error, basis.stop};
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < model.unknowns.size(); ++k)
    if (model.unknowns[k].path.effect == effect) {
      question.sizes.push_back(k);
      numbers.push_back(static_cast<std::size_t>(model.unknowns[k].path.value));
    }
  question.sigma = Eigen::VectorXd::Zero(static_cast<Index>(numbers.size()));
  for (std::size_t k = 0; k < numbers.size(); ++k)
    if (const double sigma = found.numbers[numbers[k]].sigma; std::isfinite(sigma))
      question.sigma[static_cast<Index>(k)] = sigma;
  const auto [modes, decided_by] = findSizeModes(question);
  if (modes.empty()) return;
  if (modes.size() > 1)
    for (const SizeMode& mode : modes)
      found.modes.push_back(mode.state.arm.effects[static_cast<std::size_t>(effect)].values);
  explanation.fitted = modes.front().state;
  found.fitted.values = explanation.fitted.arm.effects[static_cast<std::size_t>(effect)].values;
  found.decided_by = decided_by;
  for (std::size_t k = 0; k < numbers.size(); ++k) takeSize(modes, static_cast<Index>(k), found.numbers[numbers[k]]);
}

}  // namespace

void findSizeSets(const FittedBasis& basis, Explanation& explanation) {
  int effect = firstAdded(explanation);
  for (FoundEffect& found : explanation.effects) {
    if (!found.frees.empty()) continue;
    if (!found.fitted.formula) findSizeSet(basis, effect, explanation, found);
    ++effect;
  }
}

}  // namespace tubeplan::calibration
