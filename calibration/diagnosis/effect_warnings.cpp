#include "calibration/diagnosis/effect_warnings.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "calibration/diagnosis/explanations/explanation_model.hpp"
#include "calibration/estimation/held_out.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kGap = 8;       // smallest relevant difference of -2 log of the posterior
constexpr double kLack = 0.003;  // p-value of the fit below which the model lacks a further effect
// Largest deviation of a parameter that is consistent with its neutral value [standard deviations].
constexpr double kNearNeutral = 2;
constexpr double kByChance = 0.05;  // p-value above which a decrease of chi-square is attributed to noise
constexpr int kRivals = 6;          // number of models that are fitted as replacements of an effect
// Upper limit on (fitted parameters x measurements x effects) for fitting replacements.
constexpr double kMostWork = 2e4;

/// Input for judging effects, the same for an identification and for a diagnosis.
struct Case {
  const PlacedArm& start;
  const std::vector<Measurement>& measurements;  ///< measurements except those that were set aside
  IdentificationOptions options;                 ///< options of the fit with all effects, without progress reports
  const Identification& with;
  ErrorSize heldout;

  [[nodiscard]] const deflection::Effect& carried(int effect) const {
    return start.arm.effects[static_cast<std::size_t>(effect)];
  }
};

/// Returns the description of a fitted parameter of an effect.
const deflection::EffectParameter& parameterOf(const deflection::Effect& effect, const IdentifiedNumber& number) {
  return deflection::numbersOf(effect)[static_cast<std::size_t>(number.unknown.path.value)];
}

/// Returns the fitted parameters of an effect.
std::vector<const IdentifiedNumber*> fittedNumbers(const Identification& with, int effect) {
  std::vector<const IdentifiedNumber*> numbers;
  for (const auto& number : with.numbers)
    if (number.unknown.owner == Unknown::Owner::kArm && number.unknown.path.effect == effect)
      numbers.push_back(&number);
  return numbers;
}

PlacedArm withoutEffect(PlacedArm placed, int effect) {
  placed.arm.effects.erase(placed.arm.effects.begin() + effect);
  return placed;
}

/// Returns the names of the free parameters that do not belong to the effect.
std::vector<std::string> namesOfOthers(const deflection::Arm& arm, const std::vector<std::string>& names, int effect) {
  std::vector<std::string> others;
  for (const auto& name : names) {
    const auto parameter = deflection::findParameter(arm, name);
    if (!parameter || parameter->path.effect != effect) others.push_back(name);
  }
  return others;
}

/// Fit of the model without one effect.
struct Without {
  double chi2 = kNotKnown;
  ErrorSize heldout;
};

Without asItStands(const PlacedArm& placed, const std::vector<Measurement>& measurements) {
  std::vector<Measurement> fitted, held_out;
  for (const auto& measurement : measurements) (measurement.is_held_out ? held_out : fitted).push_back(measurement);
  const auto weights = weighMeasurements(placed, fitted);
  if (!weights) return {};
  const auto residual = whitenedResidual(placed, {}, fitted, *weights, {}, false);
  return {residual.ok ? residual.r.squaredNorm() : kNotKnown,
          held_out.empty() ? judge(placed, fitted) : judge(placed, judgeable(placed, fitted, held_out))};
}

Without fitWithout(const Case& c, int effect) {
  const PlacedArm bare = withoutEffect(c.start, effect);
  IdentificationOptions options = c.options;
  options.free.names = namesOfOthers(c.start.arm, c.options.free.names, effect);
  options.intervals_by_profile = false;
  options.drop_level = 0;
  const bool places =
      options.free.base && std::ranges::any_of(bare.base_poses, [](const BasePose& p) { return !p.is_known; });
  if (options.free.names.empty() && !places) return asItStands(bare, c.measurements);
  const Identification fit = identify(bare, c.measurements, options);
  throwIfStopped(options.hooks.stop);
  return {fit.chi2, fit.heldout};
}

bool isAtNeutral(const deflection::Effect& effect, const std::vector<const IdentifiedNumber*>& numbers) {
  return std::ranges::all_of(numbers, [&](const IdentifiedNumber* number) {
    const auto& parameter = parameterOf(effect, *number);
    return parameter.is_shape || !(std::abs(number->value - parameter.neutral) > kNearNeutral * number->sigma);
  });
}

/// Returns the probability that noise alone lowers chi-square by `fall`. The probability is halved if the effect's only
/// fitted parameter has a bound at its neutral value.
double chanceOfFall(const Case& c, double fall, int effect, const std::vector<const IdentifiedNumber*>& numbers) {
  if (numbers.empty() || !(fall > 0)) return 1;
  const double p = chiSquareTail(fall, static_cast<double>(numbers.size()));
  if (numbers.size() > 1) return p;
  const auto& carried = c.carried(effect);
  const auto bounds = deflection::numberOf(c.start.arm, carried, numbers.front()->unknown.path.value);
  const double neutral = parameterOf(carried, *numbers.front()).neutral;
  return bounds.lower == neutral || bounds.upper == neutral ? p / 2 : p;
}

EffectWarning named(const Case& c, int effect, EffectWarningKind kind) {
  EffectWarning warning;
  warning.kind = kind;
  warning.effect = kindOf(c.carried(effect)).name;
  const std::string text = deflection::textOf(c.start.arm, c.carried(effect));
  warning.at = text.substr(text.find('@') + 1);
  return warning;
}

/// Returns the warning that an effect is not needed. `gain` is the decrease of Explanation::criterion due to the
/// effect.
EffectWarning unneeded(const Case& c, int effect, double gain) {
  const Without without = fitWithout(c, effect);
  const auto numbers = fittedNumbers(c.with, effect);
  EffectWarning warning = named(c, effect, EffectWarningKind::kNotNeeded);
  warning.fall = without.chi2 - c.with.chi2;
  warning.p_value = chanceOfFall(c, warning.fall, effect, numbers);
  warning.is_within_noise = gain <= 0;
  warning.is_at_neutral = isAtNeutral(c.carried(effect), numbers);
  warning.heldout_with = c.heldout;
  warning.heldout_without = without.heldout;
  return warning;
}

void findBeyondPlausible(const Case& c, int effect, std::vector<EffectWarning>& warnings) {
  for (const auto* number : fittedNumbers(c.with, effect)) {
    const auto& parameter = parameterOf(c.carried(effect), *number);
    if (parameter.is_shape || std::isnan(number->sigma)) continue;
    if (!(std::abs(number->value - parameter.neutral) > parameter.plausible + kNearNeutral * number->sigma)) continue;
    EffectWarning warning = named(c, effect, EffectWarningKind::kBeyondPlausible);
    warning.number = {parameter.name, number->unknown.quantity, number->value, number->sigma};
    warning.plausible = parameter.plausible;
    warnings.push_back(warning);
  }
}

bool hasShape(const deflection::Effect& effect) {
  const auto& parameters = deflection::numbersOf(effect);
  return std::ranges::any_of(parameters, [](const auto& parameter) { return parameter.is_shape; });
}

const FoundEffect* find(const Explanation& explanation, const EffectWarning& warning) {
  for (const FoundEffect& found : explanation.effects)
    if (found.effect == warning.effect && found.at == warning.at) return &found;
  return nullptr;
}

/// Judges an effect outside the catalogue, such as a user's formula, by the increase of chi-square if the effect is
/// removed.
void judgeByFit(const Case& c, int effect, std::vector<EffectWarning>& warnings) {
  EffectWarning not_needed = unneeded(c, effect, 0);
  not_needed.is_within_noise = not_needed.p_value > kByChance;
  if (!(not_needed.fall >= kGap)) warnings.push_back(not_needed);
}

/// Removes the effect and compares all possible replacements, including the effect itself. Warns if none is needed, or
/// if another one is better.
void judgeEffect(const Case& c, int effect, const DiagnosisOptions& options, std::vector<EffectWarning>& warnings) {
  DiagnosisOptions bare = options;
  bare.most_causes = 1;  // replace the effect by at most one other effect
  bare.most_leaders = kRivals;
  bare.baseline.free.names = namesOfOthers(c.start.arm, options.baseline.free.names, effect);
  EffectWarning warning = named(c, effect, EffectWarningKind::kBetterExplainedBy);
  const PlacedArm without = withoutEffect(c.start, effect);
  std::vector<std::vector<deflection::Effect>> requested;
  if (const auto itself = deflection::makeEffect(without.arm, warning.effect, warning.at);
      itself.status == deflection::EffectStatus::kMade)
    requested.push_back({itself.effect});
  const auto models = competingExplanations(without, c.measurements, bare, requested);
  throwIfStopped(bare.hooks.stop);
  const Explanation *own = nullptr, *other = nullptr, *nothing = nullptr;
  for (const Explanation& model : models.found) {  // models are sorted, most probable first
    const Explanation*& of = model.effects.empty() ? nothing : find(model, warning) ? own : other;
    if (!of) of = &model;
  }
  if (!own && !models.requested.empty() && !models.requested.front().effects.empty()) own = &models.requested.front();
  if (!nothing) return;
  if (!own) {
    judgeByFit(c, effect, warnings);
    return;
  }
  const double gain = nothing->criterion - own->criterion;
  const bool is_beaten = other && other->criterion + kGap < own->criterion;
  if (gain < kGap) {
    const EffectWarning not_needed = unneeded(c, effect, gain);
    // If an effect lowers chi-square significantly but lacks evidence, it probably substitutes for another effect,
    // which is reported instead.
    if (!is_beaten || not_needed.p_value > kLack) {
      warnings.push_back(not_needed);
      return;
    }
  }
  const bool may_reshape = hasShape(c.carried(effect));
  const bool is_reshaped = may_reshape && own->effects.size() == 1 && own->chi2 + kGap < c.with.chi2;
  if (!is_reshaped && !is_beaten) return;
  warning.better = is_reshaped ? *find(*own, warning) : other->effects.front();
  warning.by = is_reshaped ? c.with.chi2 - own->chi2 : own->criterion - other->criterion;
  warnings.push_back(warning);
}

/// Estimates from the fit's covariance by how much chi-square would rise without the effect: Wald's statistic of the
/// effect's parameters.
double riseWithout(const Case& c, int effect) {
  std::vector<Eigen::Index> which;
  std::vector<double> sizes;
  for (const auto* number : fittedNumbers(c.with, effect)) {
    const auto& parameter = parameterOf(c.carried(effect), *number);
    if (parameter.is_shape) continue;
    which.push_back(number - c.with.numbers.data());
    sizes.push_back(variableAt(number->unknown, number->value) - variableAt(number->unknown, parameter.neutral));
  }
  const auto x = Eigen::Map<const Eigen::VectorXd>(sizes.data(), static_cast<Eigen::Index>(sizes.size()));
  return x.dot(c.with.covariance(which, which).ldlt().solve(x));
}

/// Judges an effect by the covariance alone. This is used for large models, for which fitting replacements of every
/// effect would take minutes.
void judgeByCovariance(const Case& c, int effect, std::vector<EffectWarning>& warnings) {
  const double gain = riseWithout(c, effect);
  if (!(gain >= kGap)) warnings.push_back(unneeded(c, effect, gain - kGap));
}

bool isLarge(const Case& c, std::size_t effects) {
  const auto work = static_cast<double>(c.with.numbers.size()) * static_cast<double>(c.measurements.size());
  return work * static_cast<double>(effects) > kMostWork && c.with.covariance.size() > 0;
}

std::vector<EffectWarning> warningsOf(const Case& c, const std::vector<int>& effects, const DiagnosisOptions& options,
                                      const WorkHooks& hooks) {
  std::vector<EffectWarning> warnings;
  std::size_t done = 0;
  for (const int e : effects) {
    reportProgress(hooks, "effects of the cell", done++, effects.size());
    if (isLarge(c, effects.size()) && !fittedNumbers(c.with, e).empty())
      judgeByCovariance(c, e, warnings);
    else
      judgeEffect(c, e, options, warnings);
    findBeyondPlausible(c, e, warnings);
    if (!(c.with.p_value < kLack)) continue;
    warnings.push_back(named(c, e, EffectWarningKind::kLackOfFitRemains));
    warnings.back().p_value = c.with.p_value;
  }
  return warnings;
}

/// Returns the result of `work`, or an empty list if the work was stopped.
template <class Work>
std::vector<EffectWarning> unlessStopped(Work work) {
  try {
    return work();
  } catch (const WorkStopped&) {
    return {};
  }
}

}  // namespace

std::vector<EffectWarning> warnOfEffects(const PlacedArm& start, const std::vector<Measurement>& measurements,
                                         const IdentificationOptions& options, const Identification& fitted) {
  const bool is_usable =
      fitted.status == IdentificationStatus::kDone || fitted.status == IdentificationStatus::kNotConverged;
  std::vector<int> freed;
  for (int e = 0; e < static_cast<int>(start.arm.effects.size()); ++e)
    if (is_usable && !fittedNumbers(fitted, e).empty()) freed.push_back(e);
  if (freed.empty()) return {};
  IdentificationOptions quiet = options;
  quiet.hooks = withoutProgress(options.hooks);
  DiagnosisOptions look;
  look.baseline = quiet;
  look.hooks = quiet.hooks;
  const Case c{start, measurements, quiet, fitted, fitted.heldout};
  return unlessStopped([&] {
    reportProgress(options.hooks, "effects of the cell");
    return warningsOf(c, freed, look, options.hooks);
  });
}

std::vector<EffectWarning> warnOfEffects(const PlacedArm& start, const std::vector<Measurement>& measurements,
                                         const DiagnosisOptions& options, const Diagnosis& diagnosis) {
  if (diagnosis.verdict == Verdict::kNotRun || diagnosis.verdict == Verdict::kStopped) return {};
  if (start.arm.effects.empty()) return {};
  const auto used = withoutMeasurements(measurements, diagnosis.set_aside);
  IdentificationOptions fit = options.baseline;
  fit.folds = options.folds;
  fit.seed = options.seed;
  fit.hooks = withoutProgress(options.hooks);
  DiagnosisOptions look = options;
  look.hooks = fit.hooks;
  std::vector<int> all(start.arm.effects.size());
  std::iota(all.begin(), all.end(), 0);
  const Case c{start, used, fit, diagnosis.baseline, diagnosis.heldout_before};
  return unlessStopped([&] { return warningsOf(c, all, look, options.hooks); });
}

}  // namespace tubeplan::calibration
