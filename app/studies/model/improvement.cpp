#include "app/studies/model/improvement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/studies/model/cell_fit.hpp"
#include "app/studies/model/explained_model.hpp"

namespace tubeplan::app {

namespace {

using calibration::Diagnosis, calibration::Explanation, calibration::Verdict;
using calibration::IdentificationStatus, calibration::Measurement;

constexpr double kWorthIt = 0.95;  // an uncertain cause must reduce the error to less than this fraction
// A certain cause must not raise the error of the farthest poses by more than this factor.
constexpr double kNoWorse = 1.05;

/// Decision after a diagnosis: the cause to add, or the end of the loop (null cause).
struct Decision {
  const Explanation* cause = nullptr;
  ImprovementEnd end = ImprovementEnd::kNotRun;
  ImprovementReason reason = ImprovementReason::kNoVerdict;
  double first = std::numeric_limits<double>::quiet_NaN(), second = first;
};

/// Returns the explanation with the smallest error at the farthest poses among those that `isWorthIt` accepts; null if
/// there is none. The explanations are in order of probability: a less probable explanation replaces the best so far
/// only if its error is at least 5 % lower.
template <class IsWorthIt>
const Explanation* bestCarried(const std::vector<Explanation>& explanations, const IsWorthIt& isWorthIt) {
  const Explanation* best = nullptr;
  for (const auto& one : explanations)
    if (std::isfinite(one.farthest.rms) && isWorthIt(one) &&
        (!best || one.farthest.rms < kWorthIt * best->farthest.rms))
      best = &one;
  return best;
}

/// Decides between equally good explanations. Adds the best one if the difference of their predictions does not exceed
/// its reduction of the held-out error. Otherwise adds the causes common to all, if these reduce that error.
Decision amongEquals(const Diagnosis& diagnosis) {
  double widest = 0;
  for (const auto& alternative : diagnosis.alternatives)
    if (std::isfinite(alternative.apart)) widest = std::max(widest, alternative.apart);
  const Explanation* best = bestCarried(diagnosis.alternatives, [](const Explanation&) { return true; });
  const double gain = best ? diagnosis.heldout_before.rms - best->heldout.rms : 0;
  if (best && widest <= gain)
    return {best, ImprovementEnd::kNotRun, ImprovementReason::kAlternativesClose, widest, gain};
  if (diagnosis.agreed && diagnosis.agreed->heldout.rms < diagnosis.heldout_before.rms &&
      diagnosis.agreed->farthest.rms <= kNoWorse * diagnosis.farthest_before.rms)
    return {&*diagnosis.agreed, ImprovementEnd::kNotRun, ImprovementReason::kSureInAll};
  return {nullptr, ImprovementEnd::kAmbiguous, ImprovementReason::kAlternativesApart, widest, std::max(0., gain)};
}

/// Decides if no cause is certain. A cause is added only if it lowers the error of measurements excluded from its fit,
/// both for the held-out folds and for the farthest poses.
Decision amongUnsure(const Diagnosis& diagnosis) {
  const Explanation* best = bestCarried(diagnosis.closest, [&](const Explanation& one) {
    return one.heldout.rms < kWorthIt * diagnosis.heldout_before.rms &&
           one.farthest.rms < kWorthIt * diagnosis.farthest_before.rms;
  });
  if (!best) return {nullptr, ImprovementEnd::kNothingSure, ImprovementReason::kNoneLower};
  return {best, ImprovementEnd::kNotRun, ImprovementReason::kUnsureButLower};
}

Decision onSure(const Diagnosis& diagnosis) {
  const Explanation& first = diagnosis.alternatives.front();
  if (first.farthest.rms > kNoWorse * diagnosis.farthest_before.rms)
    return {nullptr, ImprovementEnd::kDoesNotCarryOver, ImprovementReason::kFarthestWorse, first.farthest.rms,
            diagnosis.farthest_before.rms};
  return {&first, ImprovementEnd::kNotRun, ImprovementReason::kSure};
}

Decision decisionOn(const Diagnosis& diagnosis) {
  switch (diagnosis.verdict) {
    case Verdict::kAdequate:
      return {nullptr, ImprovementEnd::kAdequate, ImprovementReason::kNothingMissing};
    case Verdict::kExplained:
    case Verdict::kPartlyExplained:
      return onSure(diagnosis);
    case Verdict::kAmbiguous:
      return amongEquals(diagnosis);
    case Verdict::kUnexplained:
      if (diagnosis.isScatterAlone())
        return {nullptr, ImprovementEnd::kNothingSure, ImprovementReason::kScatter, diagnosis.remainder.size};
      return amongUnsure(diagnosis);
    default:
      return {nullptr, ImprovementEnd::kInconclusive, ImprovementReason::kNoVerdict};
  }
}

ImprovementStep stepOf(const Diagnosis& diagnosis, const Decision& decision) {
  ImprovementStep step;
  step.diagnosis = diagnosis;
  step.reason = decision.reason;
  step.first = decision.first;
  step.second = decision.second;
  step.heldout_before = diagnosis.heldout_before;
  step.farthest_before = diagnosis.farthest_before;
  if (!decision.cause) return step;
  step.heldout_after = decision.cause->heldout;
  step.farthest_after = decision.cause->farthest;
  return step;
}

bool isUsable(const calibration::Identification& fit) { return fit.status == IdentificationStatus::kDone; }

/// Returns true if a fit has freed parameters of the effect and found all within two standard deviations of their
/// neutral values. Returns false if a shape parameter was freed.
bool isFoundToBeNone(const calibration::Identification& fit, int effect) {
  constexpr double kNearNone = 2;
  const auto& carried = fit.fitted.arm.effects.at(static_cast<std::size_t>(effect));
  bool is_fitted = false;
  for (const auto& number : fit.numbers) {
    if (number.unknown.owner != calibration::Unknown::Owner::kArm || number.unknown.path.effect != effect) continue;
    const auto& parameter = deflection::numbersOf(carried).at(static_cast<std::size_t>(number.unknown.path.value));
    if (parameter.is_shape || std::abs(number.value - parameter.neutral) > kNearNone * number.sigma) return false;
    is_fitted = true;
  }
  return is_fitted;
}

/// Removes from the cell the added effects that the fit found to be zero, with their free parameters, and returns their
/// names. Nothing is removed if all added effects are zero.
std::vector<std::string> takeOutNone(const std::vector<std::string>& added, const calibration::Identification& fit,
                                     CellModel& cell) {
  std::vector<std::string> none;
  for (int e = 0; e < static_cast<int>(cell.arm.effects.size()); ++e) {
    const std::string name = deflection::textOf(cell.arm, cell.arm.effects[static_cast<std::size_t>(e)]);
    if (std::ranges::count(added, name) > 0 && isFoundToBeNone(fit, e)) none.push_back(name);
  }
  if (none.size() == added.size()) none.clear();
  for (const auto& name : none) {
    std::erase_if(cell.arm.effects,
                  [&](const deflection::Effect& effect) { return deflection::textOf(cell.arm, effect) == name; });
    std::erase_if(cell.identify, [&](const std::string& freed) { return freed.starts_with(name + "."); });
  }
  return none;
}

/// One run of the improvement loop.
class Improver {
 public:
  Improver(const std::vector<Measurement>& measurements, const ImprovementRequest& request, const WorkHooks& hooks)
      : measurements_(measurements), request_(request), hooks_(hooks) {}

  Improvement run(const CellModel& cell) {
    beginStep(hooks_, "fit");
    ImprovedModel first = fitted("as given", cell, 0, hooks_);
    if (!isUsable(first.fit)) {
      result_.end = ImprovementEnd::kNotFitted;
      result_.models.push_back(std::move(first));
      return std::move(result_);
    }
    keep(std::move(first));
    for (int round = 1; round <= request_.steps; ++round)
      if (!improveOnce(within(hooks_, fmt::format("diagnosis {}", round)))) return std::move(result_);
    result_.end = ImprovementEnd::kMostSteps;
    return std::move(result_);
  }

 private:
  [[nodiscard]] ImprovedModel fitted(const std::string& name, const CellModel& cell, int step,
                                     const WorkHooks& hooks) const {
    calibration::IdentificationOptions options;
    options.free = freeNumbersOf(cell);
    options.seed = request_.seed;
    options.intervals_by_profile = false;
    options.may_hold_all = true;
    options.uncertainty = cell.uncertainty;
    options.hooks = hooks;
    const auto used = calibration::withoutMeasurements(measurements_, set_aside_);
    ImprovedModel model{name, cell, calibration::identify(startOf(cell, used), used, options), step, set_aside_};
    requireGoingOn(hooks);
    return model;
  }

  [[nodiscard]] Diagnosis diagnosisOf(const CellModel& cell, const WorkHooks& hooks) const {
    calibration::DiagnosisOptions options;
    options.baseline.free = freeNumbersOf(cell);
    options.seed = request_.seed;
    options.hooks = hooks;
    Diagnosis diagnosis = calibration::diagnose(startOf(cell, measurements_), measurements_, options);
    requireGoingOn(hooks);
    return diagnosis;
  }

  void keep(ImprovedModel model) {
    if (request_.on_model) request_.on_model(model);
    result_.models.push_back(std::move(model));
  }

  /// Refits every model to the measurements that the diagnosis used, so that the verdict applies to the models and
  /// their errors are comparable.
  void setAside(const Diagnosis& diagnosis, const WorkHooks& hooks) {
    if (diagnosis.verdict == Verdict::kNotRun || diagnosis.set_aside == set_aside_) return;
    const auto before = std::exchange(set_aside_, diagnosis.set_aside);
    std::vector<ImprovedModel> again;
    for (const ImprovedModel& model : result_.models)
      again.push_back(fitted(model.name, model.cell, model.step, hooks));
    if (!std::all_of(again.begin(), again.end(), [](const ImprovedModel& model) { return isUsable(model.fit); })) {
      set_aside_ = before;
      return;
    }
    result_.models = std::move(again);
    if (request_.on_model) request_.on_model(result_.models.back());
  }

  /// Runs one round; returns false if the loop ends.
  bool improveOnce(const WorkHooks& hooks) {
    const Diagnosis diagnosis = diagnosisOf(result_.models.back().cell, hooks);
    setAside(diagnosis, hooks);
    const ImprovedModel& last = result_.models.back();
    const Decision decision = decisionOn(diagnosis);
    result_.steps.push_back(stepOf(diagnosis, decision));
    result_.end = decision.end;
    return decision.cause && addCause(last, *decision.cause, hooks);
  }

  bool addCause(const ImprovedModel& last, const Explanation& cause, const WorkHooks& hooks) {
    ImprovementStep& step = result_.steps.back();
    CellModel cell = last.cell;
    const AddedCauses added = addExplanation(cause, cell);
    auto model = fitted(fmt::format("+ {}", fmt::join(added.names, " + ")), cell, last.step + 1, hooks);
    if (!isUsable(model.fit) || !(model.fit.heldout.rms < last.fit.heldout.rms)) {
      result_.end = ImprovementEnd::kDoesNotCarryOver;
      step.reason = ImprovementReason::kNotLowerTogether;
      return false;
    }
    step.added = added.names;
    model = withoutNone(std::move(model), cell, hooks);
    for (const auto& effect : cause.effects)
      for (const auto& [name, at] : effect.also) step.also.push_back(name + "@" + at);
    keep(std::move(model));
    return true;
  }

  /// Returns the model without the added effects that the fit found to be zero; the model unchanged if fewer than three
  /// effects were added or the reduced model is worse.
  ImprovedModel withoutNone(ImprovedModel model, CellModel cell, const WorkHooks& hooks) {
    constexpr std::size_t kSeveral = 3;
    constexpr double kAsLow = 1.01;  // largest ratio of the held-out error without these effects to that with them
    ImprovementStep& step = result_.steps.back();
    if (step.added.size() < kSeveral) return model;
    auto none = takeOutNone(step.added, model.fit, cell);
    if (none.empty()) return model;
    ImprovedModel smaller = fitted(model.name, cell, model.step, hooks);
    if (!isUsable(smaller.fit) || !(smaller.fit.heldout.rms <= kAsLow * model.fit.heldout.rms)) return model;
    std::erase_if(step.added, [&](const std::string& name) { return std::ranges::count(none, name) > 0; });
    step.not_needed = std::move(none);
    smaller.name = fmt::format("+ {}", fmt::join(step.added, " + "));
    return smaller;
  }

  const std::vector<Measurement>& measurements_;
  const ImprovementRequest& request_;
  WorkHooks hooks_;
  std::vector<int> set_aside_;
  Improvement result_;
};

}  // namespace

Improvement improveModel(const CellModel& cell, const std::vector<Measurement>& measurements,
                         const ImprovementRequest& request, const WorkHooks& hooks) {
  return Improver(measurements, request, hooks).run(cell);
}

std::vector<ModelComparisonRow> comparisonRowsOf(const Improvement& result) {
  std::vector<ModelComparisonRow> comparison;
  for (const auto& model : result.models) comparison.push_back(comparisonRowOf(model.name, model.fit));
  return comparison;
}

}  // namespace tubeplan::app
