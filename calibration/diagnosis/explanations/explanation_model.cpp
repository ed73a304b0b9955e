#include "calibration/diagnosis/explanations/explanation_model.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/diagnosis/causes/cause.hpp"
#include "calibration/estimation/held_out.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr int kRefitIterations = 6;

/// Adds unknowns for the parameters of an effect that the explanation adds. The unknowns are zero at the parameters'
/// present values.
void addEffectNumbers(const FoundEffect& found, int effect, ExplanationModel& model) {
  for (std::size_t v = 0; v < found.numbers.size(); ++v) {
    if (std::isnan(found.numbers[v].sigma)) continue;
    model.unknowns.push_back(numberUnknown(model.placed.arm, effect, static_cast<int>(v)));
  }
}

}  // namespace

int firstAdded(const Explanation& explanation) {
  const auto added = std::ranges::count_if(explanation.effects, [](const auto& found) { return found.frees.empty(); });
  return static_cast<int>(explanation.fitted.arm.effects.size()) - static_cast<int>(added);
}

ExplanationModel modelOf(const FittedBasis& basis, const Explanation& explanation) {
  ExplanationModel model{explanation.fitted, basis.unknowns};
  for (auto& unknown : model.unknowns)
    if (unknown.owner == Unknown::Owner::kArm)
      unknown = rebased(unknown, deflection::locate(model.placed.arm, unknown.path));
  int effect = firstAdded(explanation);
  for (const FoundEffect& found : explanation.effects) {
    if (found.frees.empty()) {
      addEffectNumbers(found, effect++, model);
      continue;
    }
    for (Unknown& freed : chooseUnknowns(model.placed, {found.frees, false, model.placed.priors}).list) {
      freed.prior_mean = variableAt(freed, deflection::locate(model.placed.arm, freed.path));
      if (const auto drawn = deflection::findParameter(basis.fitted.arm, freed.name))
        freed.prior_mean = variableAt(freed, drawn->value);
      model.unknowns.push_back(freed);
    }
  }
  return model;
}

ErrorSize judgeOnFolds(const FittedBasis& basis, const ExplanationModel& model, const std::vector<int>& folds,
                       double model_error) {
  const VectorXd start = zerosOf(model.unknowns);
  const LeastSquaresOptions solver{1e-5, kRefitIterations, LeastSquaresMethod::kLevenbergMarquardt, basis.stop};
  return judgeFolds(basis.measurements, folds, [&](const std::vector<Measurement>& kept) -> std::optional<PlacedArm> {
    const auto weights = weighMeasurements(model.placed, kept, {}, model_error, basis.stop);
    if (!weights) return {};
    const auto solution =
        minimizeOrUnwind(fitProblem(model.placed, model.unknowns, kept, *weights, start, basis.stop), solver);
    if (solution.status == LeastSquaresStatus::kFailed) return {};
    return applied(model.placed, model.unknowns, solution.x);
  });
}

}  // namespace tubeplan::calibration
