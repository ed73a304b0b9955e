#include "calibration/estimation/identified_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "calibration/estimation/profile_interval.hpp"
#include "calibration/estimation/size_modes.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kNormal95 = 1.959963984540054;
// A value is at its bound if it is closer to it than this fraction of its typical size.
constexpr double kBoundMargin = 1e-4;
// The normal interval is inaccurate if the relative sigma of a compliance exceeds this.
constexpr double kPoorNormal = 0.2;
// The normal interval is also inaccurate if the correlation with a parameter near its bound exceeds this.
constexpr double kLeaning = 0.3;

bool isAtBound(const Unknown& unknown, double x) {
  const double margin = kBoundMargin * unknown.typical;
  return x <= unknown.lower + margin || x >= unknown.upper - margin;
}

std::string namesOf(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
  return text;
}

constexpr double kFarFromDrawing = 3;  // distance of a value from its prior mean above which a note is added [sigmas]

bool isCompliance(const Unknown& unknown) { return unknown.scale == Unknown::Scale::kCompliance; }

std::string noteOf(const IdentifiedNumber& number, bool is_nearly_rigid) {
  if (number.identifiable == Identifiability::kInCombination)
    return "determined only in combination with " + namesOf(number.with) + "; otherwise determined by its prior";
  if (number.is_at_bound && is_nearly_rigid)
    return "the best fit has zero or negative compliance, which is not physical: treat it as rigid, or look for a "
           "missing effect";
  if (number.is_at_bound) return "at its bound: the unconstrained estimate is not physical";
  if (is_nearly_rigid) return "its compliance is within two standard deviations of zero: hardly significant";
  if (number.identifiable == Identifiability::kNo)
    return "the readings do not determine it: it stays near its initial value";
  if (number.prior_deviation > kFarFromDrawing)
    return fmt::format(
        "{:.1f} standard deviations of its prior from the arm's file: check the file, or look for a missing effect",
        number.prior_deviation);
  return "";
}

/// Returns true if the normal approximation of a stiffness's interval is inaccurate: the interval is wide, or the
/// stiffness is correlated with a parameter within two sigmas of a bound.
bool isNormalPoor(const std::vector<Unknown>& unknowns, const VectorXd& x, const MatrixXd& covariance, Index k) {
  const auto sigma = [&](Index i) { return std::sqrt(covariance(i, i)); };
  if (sigma(k) > kPoorNormal / valueAt(unknowns[static_cast<std::size_t>(k)], x[k])) return true;
  for (Index i = 0; i < x.size(); ++i) {
    const Unknown& other = unknowns[static_cast<std::size_t>(i)];
    const double room = std::min(x[i] - other.lower, other.upper - x[i]);
    if (i != k && room < 2 * sigma(i) && std::abs(covariance(i, k)) > kLeaning * sigma(i) * sigma(k)) return true;
  }
  return false;
}

bool isSizeOf(const Unknown& unknown, int effect, const deflection::Arm& arm) {
  if (unknown.owner != Unknown::Owner::kArm || unknown.path.effect != effect) return false;
  const auto& numbers = deflection::numbersOf(arm.effects[static_cast<std::size_t>(effect)]);
  return !numbers[static_cast<std::size_t>(unknown.path.value)].is_shape;
}

/// Widens the interval of `number`, the `k`-th size of the effect, to include all modes found.
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

void describeNumbers(const FittedModel& model, Identification& result) {
  const auto& unknowns = model.unknowns;
  const VectorXd& x = model.fit.solution.x;
  const MatrixXd& covariance = model.fit.covariance;
  const auto identifiable = judgeIdentifiability(model.fit.residual.jacobian, covariance, unknowns, x);
  for (std::size_t n = 0; n < unknowns.size(); ++n) {
    reportProgress(model.options.hooks, "intervals", n, unknowns.size());
    const auto k = static_cast<Index>(n);
    IdentifiedNumber number;
    const Unknown& unknown = number.unknown = unknowns[n];
    const double sigma = std::sqrt(covariance(k, k));
    number.identifiable = identifiable[n].verdict;
    for (const int other : identifiable[n].with) number.with.push_back(unknowns[static_cast<std::size_t>(other)].name);
    number.value = valueAt(unknown, x[k]);
    number.sigma = sigma * std::abs(slopeAt(unknown, x[k]));
    number.prior_deviation = std::abs(x[k] - unknown.prior_mean) / unknown.prior_sigma;
    double lower = std::max(unknown.lower, x[k] - kNormal95 * sigma);
    double upper = std::min(unknown.upper, x[k] + kNormal95 * sigma);
    if (model.options.intervals_by_profile && isCompliance(unknown) && isNormalPoor(unknowns, x, covariance, k)) {
      const auto profile = profileInterval(model.start, unknowns, model.fitted, model.fit, static_cast<int>(n), sigma,
                                           model.options.hooks.stop);
      lower = profile.lower, upper = profile.upper;
      number.is_profile = true;
    }
    std::tie(number.lower, number.upper) = valuesBetween(unknown, lower, upper);
    number.is_at_bound = isAtBound(unknown, x[k]);
    number.note = noteOf(number, isCompliance(unknown) && 1 / number.value < 2 * sigma);
    result.numbers.push_back(std::move(number));
  }
}

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
