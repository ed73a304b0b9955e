#include "app/studies/model/improvement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/studies/model/cell_fit.hpp"
#include "app/studies/model/explained_model.hpp"
#include "app/studies/model/improvement_decision.hpp"
#include "calibration/diagnosis/causes/cause.hpp"

namespace tubeplan::app {

namespace {

using calibration::Diagnosis, calibration::Explanation, calibration::Verdict;
using calibration::IdentificationStatus, calibration::Measurement;

ImprovementStep stepOf(const Diagnosis& diagnosis, const ImprovementDecision& decision) {
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

constexpr double kHardlySignificant = 3;  // [standard deviations]

bool isUsable(const calibration::Identification& fit) { return fit.status == IdentificationStatus::kDone; }

/// Returns the largest distance of an effect's fitted parameters from their neutral values, in standard deviations;
/// infinite if none or a shape parameter was fitted.
double significanceOf(const calibration::Identification& fit, int effect) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const auto& carried = fit.fitted.arm.effects.at(static_cast<std::size_t>(effect));
  double most = -1;
  for (const auto& number : fit.numbers) {
    if (number.unknown.owner != calibration::Unknown::Owner::kArm || number.unknown.path.effect != effect) continue;
    const auto& parameter = deflection::numbersOf(carried).at(static_cast<std::size_t>(number.unknown.path.value));
    if (parameter.is_shape) return kUnknown;
    most = std::max(most, std::abs(number.value - parameter.neutral) / number.sigma);
  }
  return most < 0 ? kUnknown : most;
}

/// Returns the added effects with all parameters within three standard deviations of their neutral values, the least
/// significant first; at least one added effect is not among them.
std::vector<std::string> hardlySignificant(const std::vector<std::string>& added,
                                           const calibration::Identification& fit, const CellModel& cell) {
  std::vector<std::pair<double, std::string>> none;
  for (int e = 0; e < static_cast<int>(cell.arm.effects.size()); ++e) {
    const std::string name = deflection::textOf(cell.arm, cell.arm.effects[static_cast<std::size_t>(e)]);
    const double significance = significanceOf(fit, e);
    if (std::ranges::count(added, name) > 0 && significance <= kHardlySignificant)
      none.emplace_back(significance, name);
  }
  std::ranges::stable_sort(none, {}, &std::pair<double, std::string>::first);
  if (none.size() == added.size()) none.pop_back();
  std::vector<std::string> names;
  for (auto& [significance, name] : none) names.push_back(std::move(name));
  return names;
}

/// Returns the cell without these effects and their free parameters.
CellModel withoutEffects(CellModel cell, const std::vector<std::string>& names) {
  for (const auto& name : names) {
    std::erase_if(cell.arm.effects,
                  [&](const deflection::Effect& effect) { return deflection::textOf(cell.arm, effect) == name; });
    std::erase_if(cell.identify, [&](const std::string& freed) { return freed.starts_with(name + "."); });
  }
  return cell;
}

/// Returns the name of a model with added causes, such as "+ backlash@tool.z".
std::string modelName(const std::vector<std::string>& added) {
  std::vector<std::string> titles;
  for (const auto& name : added) titles.push_back(calibration::causeTitle(name));
  return fmt::format("+ {}", fmt::join(titles, " + "));
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
    throwIfJobStopped(hooks);
    return model;
  }

  [[nodiscard]] Diagnosis diagnosisOf(const CellModel& cell, const WorkHooks& hooks) const {
    calibration::DiagnosisOptions options;
    options.baseline.free = freeNumbersOf(cell);
    options.seed = request_.seed;
    options.hooks = hooks;
    Diagnosis diagnosis = calibration::diagnose(startOf(cell, measurements_), measurements_, options);
    throwIfJobStopped(hooks);
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
    const ImprovementDecision decision = improvementDecision(diagnosis);
    result_.steps.push_back(stepOf(diagnosis, decision));
    result_.end = decision.end;
    return decision.cause && addCause(last, *decision.cause, hooks);
  }

  bool addCause(const ImprovedModel& last, const Explanation& cause, const WorkHooks& hooks) {
    ImprovementStep& step = result_.steps.back();
    CellModel cell = last.cell;
    const AddedCauses added = addExplanation(cause, cell);
    auto model = fitted(modelName(added.names), cell, last.step + 1, hooks);
    if (!isUsable(model.fit) || !(model.fit.heldout.rms < last.fit.heldout.rms)) {
      result_.end = ImprovementEnd::kDoesNotCarryOver;
      step.reason = ImprovementReason::kNotLowerTogether;
      return false;
    }
    step.added = added.names;
    model = withoutInsignificant(std::move(model), cell, hooks);
    for (const auto& effect : cause.effects)
      for (const auto& [name, at] : effect.indistinguishable) step.indistinguishable.push_back(name + "@" + at);
    keep(std::move(model));
    return true;
  }

  /// Returns the model without the added effects that are hardly significant: without all of them, or otherwise without
  /// each effect that is unnecessary given the others. A model that predicts held-out measurements less well is
  /// rejected. The model is unchanged if fewer than three effects were added.
  ImprovedModel withoutInsignificant(ImprovedModel model, const CellModel& cell, const WorkHooks& hooks) {
    constexpr std::size_t kSeveral = 3;
    constexpr double kAsLow = 1.01;  // largest ratio of the held-out error without these effects to that with them
    ImprovementStep& step = result_.steps.back();
    if (step.added.size() < kSeveral) return model;
    const double most = kAsLow * model.fit.heldout.rms;
    const auto none = hardlySignificant(step.added, model.fit, cell);
    const auto takeOut = [&](const std::vector<std::string>& names) {
      std::vector<std::string> out = step.not_needed;
      out.insert(out.end(), names.begin(), names.end());
      ImprovedModel smaller = fitted(model.name, withoutEffects(cell, out), model.step, hooks);
      if (!isUsable(smaller.fit) || !(smaller.fit.heldout.rms <= most)) return false;
      step.not_needed = std::move(out);
      model = std::move(smaller);
      return true;
    };
    if (!none.empty() && !takeOut(none))
      for (const auto& name : none) takeOut({name});
    std::erase_if(step.added, [&](const std::string& name) { return std::ranges::count(step.not_needed, name) > 0; });
    model.name = modelName(step.added);
    return model;
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
