#include "calibration/diagnosis/model_selection/placed_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

namespace {

// A size is unusual if it exceeds the largest usual one by more than this many sigmas.
constexpr double kBeyondUsual = 2;
constexpr double kShapePrior = 3;       // prior standard deviation of a knee, in units of Unknown::typical
constexpr std::size_t kMostTimes = 12;  // maximum number of times of a step that are tried at once

FoundNumber foundNumber(const Unknown& unknown, const std::string& name, double value, double sigma) {
  FoundNumber number{name, unknown.quantity, value, sigma};
  number.is_beyond_usual =
      unknown.path.effect >= 0 && std::abs(value - unknown.start) > unknown.typical + kBeyondUsual * sigma;
  return number;
}

/// Returns the index of the step time that lowers chi-square most.
std::size_t bestTime(const DiagnosisWork& work, Cause cause, const ModelTerm& term, const std::vector<double>& times) {
  cause.levels = times;
  const Signatures signatures(work.basis.fitted, {cause});
  EvidenceGram gram;
  const Eigen::MatrixXd S = signatures.columnsAt(work.basis.measurements, work.basis.weights, work.basis.stop);
  if (S.rows() != work.basis.residual.r.size()) return times.size() / 2;
  gram.add(work.basis.residual.jacobian, S, Eigen::MatrixXd(S.rows(), 0), -work.basis.residual.r);
  const LinearEvidence evidence(gram, work.basis.unknowns, {});
  std::size_t best = 0;
  double most = -1;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const auto columns = picked(signatures.columnsOf(0, static_cast<int>(k)), term.numbers);
    if (const double fall = evidence.fall(columns); fall > most) most = fall, best = k;
  }
  return best;
}

/// Returns the time of a step to the resolution of the measurements' times: all times between two consecutive
/// measurements are equivalent. Tries the gaps near the time of the term's level. If there are many gaps, a subset is
/// tried first, then all gaps around the best.
double refinedTime(const DiagnosisWork& work, const CompetingModel& model, std::size_t index) {
  const ModelTerm& term = model.terms[index];
  const Cause& cause = work.cause(term.cause);
  const auto& levels = cause.levels;
  const auto level = static_cast<std::size_t>(term.level);
  const double from = level > 0 ? levels[level - 1] : -std::numeric_limits<double>::infinity();
  const double to = level + 1 < levels.size() ? levels[level + 1] : std::numeric_limits<double>::infinity();
  std::vector<double> gaps = timesBetween(work.basis.measurements);
  std::erase_if(gaps, [&](double time) { return time < from || time > to; });
  while (gaps.size() > kMostTimes) {
    const std::size_t step = gaps.size() / kMostTimes + 1;
    std::vector<double> some;
    for (std::size_t k = 0; k < gaps.size(); k += step) some.push_back(gaps[k]);
    const std::size_t best = bestTime(work, cause, term, some) * step;
    const std::size_t first = best > step ? best - step : 0, last = std::min(gaps.size() - 1, best + step);
    gaps = std::vector<double>(gaps.begin() + static_cast<std::ptrdiff_t>(first),
                               gaps.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  }
  return gaps.size() < 2 ? levels[level] : gaps[bestTime(work, cause, term, gaps)];
}

}  // namespace

PlacedModel placeModel(const DiagnosisWork& work, const CompetingModel& model) {
  PlacedModel placed{work.basis.fitted, {}, {}, {}, {}};
  for (std::size_t t = 0; t < model.terms.size(); ++t) {
    const ModelTerm& term = model.terms[t];
    const Cause& cause = work.cause(term.cause);
    const double level =
        isStep(cause) ? refinedTime(work, model, t) : cause.levels[static_cast<std::size_t>(term.level)];
    const int effect = static_cast<int>(placed.arm.arm.effects.size());
    const auto own = placeCause(placed.arm, cause, level);
    for (const int number : term.numbers) placed.sizes.push_back(own[static_cast<std::size_t>(number)]);
    placed.counts.push_back(term.numbers.size());
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
    return sigma.size() > static_cast<Index>(k) ? sigma[static_cast<Index>(k)] * placed.sizes[k].typical : kNotKnown;
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
