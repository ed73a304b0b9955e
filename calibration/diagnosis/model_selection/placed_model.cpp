#include "calibration/diagnosis/model_selection/placed_model.hpp"

#include <cmath>
#include <limits>

#include "calibration/diagnosis/model_selection/step_time.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr double kBeyondUsual = 2;  // sigmas past the largest usual size
constexpr double kShapePrior = 3;   // of a knee's typical step

FoundNumber foundNumber(const Unknown& unknown, const std::string& name, double value, double sigma) {
  FoundNumber number{name, unknown.quantity, value, sigma};
  number.is_beyond_usual =
      unknown.path.effect >= 0 && std::abs(value - unknown.start) > unknown.typical + kBeyondUsual * sigma;
  return number;
}

}  // namespace

PlacedModel placeModel(const DiagnosisWork& work, const CompetingModel& model) {
  PlacedModel placed{work.basis.fitted, {}, {}, {}, {}, {}};
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    const ModelTerm& term = model.terms[t];
    const Cause& cause = work.cause(term.cause);
    const double level =
        isStep(cause) ? refinedTime(work, model, t) : cause.levels[static_cast<std::size_t>(term.level)];
    const int effect = static_cast<int>(placed.arm.arm.effects.size());
    const auto own = placeCause(placed.arm, cause, level);
    for (const int number : term.numbers) placed.sizes.push_back(own[static_cast<std::size_t>(number)]);
    placed.counts.push_back(term.numbers.size());
    placed.of_level.push_back(level);
    placed.first_effect.push_back(effect);
    if (cause.shape < 0 || isStep(cause)) continue;
    placed.shapes.push_back(shapeUnknown(placed.arm.arm, cause, effect, level));
    placed.shapes.back().prior_sigma = kShapePrior * placed.shapes.back().typical;
  }
  return placed;
}

void describeTerm(const DiagnosisWork& work, const ModelTerm& term, const PlacedModel& placed, std::size_t index,
                  const VectorXd& sigma, std::size_t first_size, Explanation& fit) {
  const Cause& cause = work.cause(term.cause);
  const auto sigmaOf = [&](std::size_t k) {
    return sigma.size() > static_cast<Index>(k) ? sigma[static_cast<Index>(k)] * placed.sizes[k].typical
                                                : std::numeric_limits<double>::quiet_NaN();
  };
  if (!cause.frees.empty()) {
    FoundEffect found{cause.effect, cause.at, {}, cause.frees, {}, {}};
    for (std::size_t k = first_size; k < first_size + placed.counts[index]; ++k) {
      const Unknown& unknown = placed.sizes[k];
      const double value = deflection::locate(fit.fitted.arm, unknown.path);
      found.numbers.push_back(foundNumber(unknown, unknown.name, value,
                                          sigmaOf(k) * std::abs(slopeAt(unknown, variableAt(unknown, value)))));
    }
    fit.effects.push_back(std::move(found));
    return;
  }
  for (std::size_t e = 0; e < cause.effects.size(); ++e) {
    const int effect = placed.first_effect[index] + static_cast<int>(e);
    const auto& fitted = fit.fitted.arm.effects[static_cast<std::size_t>(effect)];
    const auto& kind = kindOf(fitted);
    FoundEffect found{cause.effect, deflection::placeText(fit.fitted.arm, fitted), fitted, {}, {}, {}};
    for (std::size_t v = 0; v < fitted.values.size(); ++v) {
      FoundNumber number{kind.parameters[v].name,
                         deflection::numberOf(fit.fitted.arm, fitted, static_cast<int>(v)).quantity, fitted.values[v]};
      for (std::size_t k = first_size; k < first_size + placed.counts[index]; ++k)
        if (placed.sizes[k].path.effect == effect && placed.sizes[k].path.value == static_cast<int>(v))
          number = foundNumber(placed.sizes[k], number.name, number.value, sigmaOf(k));
      found.numbers.push_back(number);
    }
    fit.effects.push_back(std::move(found));
  }
}

}  // namespace tubeplan::calibration
