#include "calibration/diagnosis/hypothesis.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/diagnosis/smooth_misfit.hpp"
#include "calibration/held_out.hpp"
#include "calibration/prior.hpp"
#include "calibration/span.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr int kRefitIterations = 30, kQuickRefitIterations = 4;

LeastSquaresOptions refitting(const DiagnosisBasis& basis, int iterations) {
  return {1e-5, iterations, LeastSquaresMethod::kLevenbergMarquardt, basis.stop};
}

/// A catalogue's candidate as it goes into a model: which of its values are free, and where they start.
struct Part {
  const Candidate* candidate;
  std::vector<int> sizes;
  double shape;
  VectorXd start;  ///< in internal units
};

double unitOf(const Candidate& candidate, int size) {
  return candidate.unit[static_cast<std::size_t>(candidate.sizes[static_cast<std::size_t>(size)])];
}

/// A step between two readings is the same wherever it is between them, so a scan of the gaps near a level is exact.
double refinedTime(const DiagnosisBasis& basis, const Candidate& candidate, int level, const std::vector<int>& sizes) {
  const double from = level > 0 ? candidate.levels[static_cast<std::size_t>(level - 1)] : -1e300;
  const double to = level + 1 < static_cast<int>(candidate.levels.size())
                        ? candidate.levels[static_cast<std::size_t>(level + 1)]
                        : 1e300;
  std::vector<double> times;
  for (const auto& reading : basis.readings) times.push_back(reading.time);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  const StepColumns columns(basis.fitted, basis.readings, basis.weights, candidate);
  const MatrixXd Q = spanOf(basis.residual.jacobian);
  const VectorXd rest = -without(Q, basis.residual.r);
  double best = candidate.levels[static_cast<std::size_t>(level)], most = -1;
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    goOn(basis.stop);
    const double time = (times[k] + times[k + 1]) / 2;
    if (time < from || time > to) continue;
    const MatrixXd all = columns.at(time);
    if (all.cols() == 0) continue;
    const MatrixXd S = without(Q, all(Eigen::all, sizes));
    const VectorXd phi = S.completeOrthogonalDecomposition().solve(rest);
    const double fall = (S * phi).dot(rest);
    if (fall > most) most = fall, best = time;
  }
  return best;
}

Explanation fitParts(const DiagnosisBasis& basis, const std::vector<Part>& parts) {
  Explanation result;
  ExplanationModel model{basis.fitted, basis.unknowns};
  std::vector<int> effects;
  VectorXd x = VectorXd::Zero(static_cast<Index>(model.unknowns.size()));
  for (const Part& part : parts) {
    const int effect = placeEffect(model.placed.arm, *part.candidate, part.shape);
    effects.push_back(effect);
    auto own = effectUnknowns(model.placed.arm, *part.candidate, effect, part.sizes);
    VectorXd start = part.start;
    if (part.candidate->shape >= 0 && !isStep(*part.candidate)) {
      Candidate shape = *part.candidate;
      shape.sizes = {shape.shape};
      auto unknown = effectUnknowns(model.placed.arm, shape, effect, {0}).front();
      unknown.typical = std::max(1e-3, 0.3 * part.shape);
      unknown.prior_sigma = 10 * unknown.typical;
      own.push_back(unknown);
      start.conservativeResize(start.size() + 1);
      start[start.size() - 1] = 0;
    }
    for (Index k = 0; k < start.size(); ++k)
      start[k] = std::clamp(start[k], own[static_cast<std::size_t>(k)].lower, own[static_cast<std::size_t>(k)].upper);
    const Index before = x.size();
    x.conservativeResize(before + start.size());
    x.tail(start.size()) = start;
    model.unknowns.insert(model.unknowns.end(), own.begin(), own.end());
  }
  const auto solution = minimizeOrUnwind(fitProblem(model.placed, model.unknowns, basis.readings, basis.weights, x),
                                         refitting(basis, kRefitIterations));
  const auto residual = whitenedResidual(model.placed, model.unknowns, basis.readings, basis.weights, solution.x, true);
  if (!residual.ok || solution.status == LeastSquaresStatus::kFailed) return result;
  result.fitted = applied(model.placed, model.unknowns, solution.x);
  result.chi2 = residual.r.squaredNorm();
  result.after = errorSize(basis.readings, basis.weights, residual.error);
  int numbers = static_cast<int>(model.unknowns.size());
  for (const Part& part : parts) numbers += isStep(*part.candidate);
  const int freedom = basis.weights.degrees_of_freedom - numbers;
  result.p_value = chiSquareTail(result.chi2, freedom);
  result.smooth_p_value = findSmoothMisfit(result.fitted, basis.readings, basis.weights, residual).p_value;
  result.criterion = result.chi2 + numbers * std::log(std::max(2, basis.weights.degrees_of_freedom));
  const VectorXd sigma = posteriorCovariance(residual.jacobian, model.unknowns).diagonal().cwiseMax(0).cwiseSqrt();
  for (std::size_t p = 0; p < parts.size(); ++p) {
    FoundEffect found{parts[p].candidate->effect,
                      parts[p].candidate->at,
                      result.fitted.arm.effects[static_cast<std::size_t>(effects[p])],
                      {}};
    const auto& kind = deflection::effectKinds()[static_cast<std::size_t>(found.fitted.kind)];
    for (std::size_t v = 0; v < found.fitted.values.size(); ++v) {
      FoundNumber number{kind.parameters[v].name,
                         deflection::numberOf(result.fitted.arm, found.fitted, static_cast<int>(v)).quantity,
                         found.fitted.values[v]};
      for (std::size_t u = 0; u < model.unknowns.size(); ++u)
        if (model.unknowns[u].path.effect == effects[p] && model.unknowns[u].path.value == static_cast<int>(v))
          number.sigma = sigma[static_cast<Index>(u)];
      found.numbers.push_back(number);
    }
    result.effects.push_back(std::move(found));
  }
  return result;
}

}  // namespace

DiagnosisBasis basisOf(const Identification& baseline, const std::vector<Measurement>& readings) {
  DiagnosisBasis basis{readings, baseline.fitted, fittedUnknowns(baseline), {}, {}};
  if (auto weights = weighReadings(basis.fitted, readings)) basis.weights = std::move(*weights);
  if (basis.weights.rows > 0)
    basis.residual = whitenedResidual(basis.fitted, basis.unknowns, readings, basis.weights,
                                      VectorXd::Zero(static_cast<Index>(basis.unknowns.size())), true);
  return basis;
}

Explanation fitExplanation(const DiagnosisBasis& basis, const Catalogue& catalogue, const ScoreSpace& space,
                           const std::vector<int>& variants) {
  const Score score = space.score(variants);
  std::vector<Part> parts;
  Index at = 0;
  for (const int v : variants) {
    const Variant& variant = space.variants()[static_cast<std::size_t>(v)];
    const Candidate& candidate = catalogue.candidates[static_cast<std::size_t>(variant.candidate)];
    Part part{&candidate, variant.sizes, candidate.levels[static_cast<std::size_t>(variant.level)], {}};
    part.start.resize(static_cast<Index>(variant.sizes.size()));
    for (std::size_t k = 0; k < variant.sizes.size(); ++k, ++at)
      part.start[static_cast<Index>(k)] =
          (at < score.sizes.size() ? score.sizes[at] : 0) * unitOf(candidate, variant.sizes[k]);
    if (isStep(candidate)) part.shape = refinedTime(basis, candidate, variant.level, variant.sizes);
    parts.push_back(std::move(part));
  }
  return fitParts(basis, parts);
}

ExplanationModel modelOf(const DiagnosisBasis& basis, const Explanation& explanation) {
  ExplanationModel model{explanation.fitted, basis.unknowns};
  for (auto& unknown : model.unknowns)
    if (unknown.owner == Unknown::Owner::kArm)
      unknown = rebased(unknown, deflection::locate(model.placed.arm, unknown.path));
  for (std::size_t e = 0; e < explanation.effects.size(); ++e) {
    const auto& found = explanation.effects[e];
    const int index = static_cast<int>(model.placed.arm.effects.size() - explanation.effects.size() + e);
    const auto& kind = deflection::effectKinds()[static_cast<std::size_t>(found.fitted.kind)];
    for (std::size_t v = 0; v < found.numbers.size(); ++v) {
      if (std::isnan(found.numbers[v].sigma)) continue;
      const auto number = deflection::numberOf(model.placed.arm, found.fitted, static_cast<int>(v));
      Unknown unknown;
      unknown.name = found.effect + "@" + found.at + "." + kind.parameters[v].name;
      unknown.path.effect = index;
      unknown.path.value = static_cast<int>(v);
      unknown.quantity = number.quantity;
      unknown.start = found.fitted.values[v];
      unknown.typical = kind.parameters[v].plausible;
      unknown.prior_sigma = 10 * unknown.typical;
      unknown.lower = number.lower - unknown.start;
      unknown.upper = number.upper - unknown.start;
      model.unknowns.push_back(unknown);
    }
  }
  return model;
}

ErrorSize judgeOnFolds(const DiagnosisBasis& basis, const ExplanationModel& model, const std::vector<int>& folds) {
  const VectorXd start = VectorXd::Zero(static_cast<Index>(model.unknowns.size()));
  return judgeFolds(basis.readings, folds, [&](const std::vector<Measurement>& kept) -> std::optional<PlacedArm> {
    const auto weights = weighReadings(model.placed, kept);  // whitening is by reading: the basis' own
    if (!weights) return {};
    const auto solution = minimizeOrUnwind(fitProblem(model.placed, model.unknowns, kept, *weights, start),
                                           refitting(basis, kQuickRefitIterations));
    if (solution.status == LeastSquaresStatus::kFailed) return {};
    return applied(model.placed, model.unknowns, solution.x);
  });
}

}  // namespace tubeplan::calibration
