#include "calibration/diagnosis/size_sets.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/diagnosis/explanation_model.hpp"
#include "calibration/estimation/size_modes.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

namespace {

/// The model of an explanation with all numbers of one of its effects free, those last.
ExplanationModel withEverySize(const FittedBasis& basis, const Explanation& explanation, int effect) {
  ExplanationModel model = modelOf(basis, explanation);
  std::erase_if(model.unknowns, [&](const Unknown& unknown) { return unknown.path.effect == effect; });
  const auto& numbers = deflection::numbersOf(model.placed.arm.effects[static_cast<std::size_t>(effect)]);
  for (std::size_t v = 0; v < numbers.size(); ++v)
    if (!numbers[v].is_shape && numbers[v].quantity != deflection::Quantity::kTime)
      model.unknowns.push_back(numberUnknown(model.placed.arm, effect, static_cast<int>(v)));
  return model;
}

/// What a difference of each size must exceed: by the found numbers of its quantity, the best known one.
double sigmaOf(const FoundEffect& found, std::size_t number) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& other : found.numbers)
    if (other.quantity == found.numbers[number].quantity && std::isfinite(other.sigma))
      least = std::min(least, other.sigma);
  return least;
}

/// Takes a size's range over all modes, with two standard deviations.
void takeRange(const FoundEffect& found, std::size_t v, double sigma, FoundNumber& number) {
  const auto [least, most] =
      std::ranges::minmax_element(found.modes, {}, [&](const std::vector<double>& values) { return values[v]; });
  number.value = found.fitted.values[v];
  number.lower = (*least)[v] - 2 * sigma;
  number.upper = (*most)[v] + 2 * sigma;
  number.sigma = (number.upper - number.lower) / 4;
  number.is_beyond_usual = false;
}

void findSizeSet(const FittedBasis& basis, int effect, Explanation& explanation, FoundEffect& found) {
  const ExplanationModel model = withEverySize(basis, explanation, effect);
  SizeModesQuestion question{model.placed, model.unknowns, {}, {}, basis.readings, explanation.model_error, basis.stop};
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < model.unknowns.size(); ++k)
    if (model.unknowns[k].path.effect == effect) {
      question.sizes.push_back(k);
      numbers.push_back(static_cast<std::size_t>(model.unknowns[k].path.value));
    }
  question.sigma.resize(static_cast<Index>(numbers.size()));
  for (std::size_t k = 0; k < numbers.size(); ++k) question.sigma[static_cast<Index>(k)] = sigmaOf(found, numbers[k]);
  auto modes = findSizeModes(question);
  if (modes.states.size() < 2) return;
  for (const PlacedArm& state : modes.states)
    found.modes.push_back(state.arm.effects[static_cast<std::size_t>(effect)].values);
  found.fitted.values = found.modes.front();
  found.decided_by = modes.decided_by;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    takeRange(found, numbers[k], question.sigma[static_cast<Index>(k)], found.numbers[numbers[k]]);
  explanation.fitted = std::move(modes.states.front());
}

}  // namespace

void findSizeSets(const FittedBasis& basis, Explanation& explanation) {
  int added = 0;
  for (const FoundEffect& found : explanation.effects) added += found.frees.empty();
  int effect = static_cast<int>(explanation.fitted.arm.effects.size()) - added;
  for (FoundEffect& found : explanation.effects) {
    if (!found.frees.empty()) continue;
    if (!found.fitted.formula) findSizeSet(basis, effect, explanation, found);
    ++effect;
  }
}

}  // namespace tubeplan::calibration
