#include "app/jobs/identification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/documents/effect_warnings_json.hpp"
#include "app/documents/identification_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/documents/overlap_report.hpp"
#include "app/documents/predicted_centring_json.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/jobs/cell_estimate.hpp"
#include "app/jobs/outliers.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/model/cell_fit.hpp"

namespace tubeplan::app {

namespace {

using calibration::Identification, calibration::IdentificationOptions, calibration::IdentificationStatus;

calibration::RobustLoss lossOf(const std::string& name) {
  using calibration::RobustLoss;
  static const std::map<std::string, RobustLoss> kLosses{
      {"none", RobustLoss::kNone}, {"huber", RobustLoss::kHuber}, {"cauchy", RobustLoss::kCauchy}};
  const auto loss = kLosses.find(name);
  if (loss == kLosses.end()) throw InputError("robust", inQuotes(name), "none, huber or cauchy");
  return loss->second;
}

IdentificationOptions identificationOptions(const IdentificationRequest& request, const Cell& cell,
                                            const WorkHooks& hooks) {
  IdentificationOptions result;
  result.free = freeNumbersOf(cell);
  if (!request.free.empty()) result.free.names = request.free;
  result.loss = lossOf(request.robust);
  result.starts = request.starts;
  if (request.folds < 0 || request.folds > kMostFolds)
    throw InputError("folds", std::to_string(request.folds), fmt::format("0 to {}", kMostFolds));
  result.folds = request.folds;
  result.seed = request.seed;
  result.drop_level = request.drop;
  result.hooks = hooks;
  for (const auto& method : calibration::leastSquaresMethods())
    if (method.name == request.method) result.solver.method = method.method;
  if (result.free.names.empty() && request.stages.empty() && cell.base_known)
    throw InputError::problem(cell.path, "no parameter is free",
                              "free one with a list `identify`, or --free NAME; `tubeplan identify --help` lists the "
                              "numbers that can be freed");
  return result;
}

/// Throws InputError for a refused fit: a name is not a parameter, or the measurements determine no parameter.
void requireAccepted(const Identification& result, const IdentificationRequest& request,
                     const CellMeasurements& input) {
  if (result.status != IdentificationStatus::kRefused) return;
  const Cell& cell = input.cell;
  if (result.measurement_problem) throw refusalOf(result.measurement_problem, result.reason, input);
  if (result.problems.empty())
    throw InputError::problem(cell.path, result.reason,
                              "`tubeplan identify --help` lists the numbers that can be freed");
  refuseName(request.free.empty() ? cell.path + " (identify)" : "--free", result.problems.front(), cell.arm);
}

/// Parses one stage: "a,b" or "a,b:SETUP".
calibration::IdentificationStage stageOf(const std::string& text) {
  calibration::IdentificationStage stage;
  const std::size_t colon = text.find(':');
  if (colon != std::string::npos) stage.setup = text.substr(colon + 1);
  const std::string names = text.substr(0, colon);
  for (std::size_t from = 0; from <= names.size();) {
    const std::size_t to = std::min(names.find(',', from), names.size());
    stage.names.push_back(names.substr(from, to - from));
    from = to + 1;
  }
  return stage;
}

Identification identifyByRequest(const IdentificationRequest& request, const Cell& cell,
                                 const std::vector<calibration::Measurement>& measurements, const WorkHooks& hooks) {
  const auto start = startOf(cell, measurements);
  IdentificationOptions options = identificationOptions(request, cell, hooks);
  options.observe = request.observe;
  options.uncertainty = cell.uncertainty;
  if (request.stages.empty()) return calibration::identify(start, measurements, options);
  if (!request.free.empty())
    throw InputError::problem("--free", "this option cannot be combined with --stage",
                              "name the numbers freed in each stage: --stage NAME,NAME");
  std::vector<calibration::IdentificationStage> stages;
  for (const auto& text : request.stages) stages.push_back(stageOf(text));
  auto results = calibration::identifyInStages(start, measurements, stages, options);
  if (request.stage_done && results.back().status != IdentificationStatus::kStopped)
    for (std::size_t k = 0; k + 1 < results.size(); ++k) request.stage_done(static_cast<int>(k), results[k]);
  return std::move(results.back());
}

/// Returns warnings about the cell's fitted effects. There are none for a fit in stages, because the last stage holds
/// some effects fixed.
std::vector<calibration::EffectWarning> effectWarnings(const IdentificationRequest& request, const Cell& cell,
                                                       const std::vector<calibration::Measurement>& measurements,
                                                       const Identification& result, const WorkHooks& hooks) {
  if (!request.stages.empty() || cell.arm.effects.empty()) return {};
  return calibration::warnOfEffects(startOf(cell, measurements), measurements,
                                    identificationOptions(request, cell, hooks), result);
}

/// Returns an outcome without a fit, because fitted parameters would compensate for the mistake in the measurements.
IdentificationOutcome unidentified(const CellMeasurements& input, const std::string& mistake) {
  const Units& units = input.cell.units;
  IdentificationOutcome outcome;
  outcome.measurements = input.measurements;
  outcome.fit.reason = outcome.centring.reason = mistake;
  outcome.fit.fitted = startOf(input.cell, input.measurements);
  outcome.warnings = fitWarnings(outcome.fit, input.measurements);
  outcome.figures = identificationJson(outcome.fit, outcome.measurements, 0, units);
  outcome.adequacy = calibration::Adequacy::kInconclusive;
  outcome.figures["adequacy"] = nameOf(outcome.adequacy);
  outcome.figures["warnings"] = warningsWithChecks(input.checks, outcome.warnings, units);
  outcome.figures["set_aside"] = outcome.set_aside;
  outcome.figures["predicted_centring_error"] = predictedCentringJson(outcome.centring, units);
  addChecks(input.checks, units, outcome.figures);
  return outcome;
}

/// Fits the measurements without their outliers; a fit in stages or with a robust loss uses all measurements.
void fitMeasurements(const CellMeasurements& input, const IdentificationRequest& request, const WorkHooks& hooks,
                     IdentificationOutcome& outcome) {
  const auto& cell = input.cell;
  const auto fitted = [&](const std::vector<calibration::Measurement>& measurements) {
    auto fit = identifyByRequest(request, cell, measurements, hooks);
    throwIfJobStopped(hooks);
    requireAccepted(fit, request, input);
    return fit;
  };
  const IdentificationOptions options = identificationOptions(request, cell, withoutProgress(hooks));
  const bool takes_all = !request.stages.empty() || options.loss != calibration::RobustLoss::kNone;
  const auto outliers = [&](const Identification& fit) {
    if (takes_all) return std::vector<int>();
    auto aside = outliersOf(input, fit, options);
    throwIfJobStopped(hooks);
    return aside;
  };
  RefitOfMeasurements refit = fitWithoutOutliers(input.measurements, fitted, outliers);
  outcome.fit = std::move(refit.fit);
  outcome.measurements = std::move(refit.measurements);
  outcome.set_aside = std::move(refit.set_aside);
}

/// Returns a clause on residuals that exceed the noise; empty if there are none. The clause also reports residuals that
/// exceed the stated noise but not the scatter of repeated measurements. Such residuals do not make the fit inadequate.
std::string refutation(const calibration::ModelLackOfFit& lack) {
  const bool is_off = lack.p_value < calibration::kPatternLevel;
  if (lack.adequacy == calibration::Adequacy::kInadequate)
    return is_off ? "the residuals are larger than noise explains"
                  : fmt::format(
                        "repeated readings scatter {:.2g} times as much as stated, and the residuals are larger than "
                        "that explains",
                        lack.repeats.noise_ratio);
  return is_off ? fmt::format(
                      "the residuals are larger than the stated noise explains, but not larger than the scatter of "
                      "repeated readings, {:.2g} times as much",
                      lack.repeats.noise_ratio)
                : "";
}

/// Records whether the residuals exceed the noise, by the criterion of `compare`, for every kind of fit and even if it
/// did not converge. The base of a robust fit is not refused, because its residuals include outliers, which may cause
/// the excess.
void judgeByNoise(const IdentificationRequest& request, IdentificationOutcome& outcome) {
  const auto& fit = outcome.fit;
  const auto lack = calibration::lackOfFitOf(fit, outcome.measurements);
  outcome.adequacy = lack.adequacy;
  const std::string refuted = refutation(lack);
  if (refuted.empty()) return;
  const bool is_robust = lossOf(request.robust) != calibration::RobustLoss::kNone;
  const bool is_base_alone = std::ranges::none_of(
      fit.numbers, [](const auto& number) { return number.unknown.owner == calibration::Unknown::Owner::kArm; });
  outcome.is_base_refused = lack.adequacy == calibration::Adequacy::kInadequate && is_base_alone && !is_robust;
  outcome.warnings.push_back(
      fmt::format("{}: chi-square {:.3g} for each of {} degrees of freedom by the stated noise{}; {}", refuted,
                  lack.chi2 / std::max(1, lack.degrees_of_freedom), lack.degrees_of_freedom,
                  is_robust ? ", of the outliers too" : "",
                  is_base_alone ? "only the base was fitted: free the numbers that the drawing leaves uncertain (a "
                                  "list `identify`, or --free), and see `tubeplan compare`"
                                : "`tubeplan compare` shows what the error depends on"));
}

}  // namespace

IdentificationOutcome identifyModel(const CellMeasurements& input, const IdentificationRequest& request,
                                    const WorkHooks& hooks) {
  const auto& cell = input.cell;
  (void)identificationOptions(request, cell, hooks);  // validates the options before any work
  if (const auto mistake = mistakeText(input.checks, cell.units); !mistake.empty()) return unidentified(input, mistake);
  beginStep(hooks, "fit");
  IdentificationOutcome outcome;
  fitMeasurements(input, request, hooks, outcome);
  const auto& measurements = outcome.measurements;
  beginStep(hooks, "uncertainties");
  outcome.warnings = fitWarnings(outcome.fit, measurements);
  judgeByNoise(request, outcome);
  outcome.figures = identificationJson(outcome.fit, measurements, outcome.set_aside.size(), cell.units);
  outcome.figures["adequacy"] = nameOf(outcome.adequacy);
  outcome.figures["warnings"] = warningsWithChecks(input.checks, outcome.warnings, cell.units);
  outcome.figures["set_aside"] = outcome.set_aside;
  addChecks(input.checks, cell.units, outcome.figures);
  outcome.overlaps = calibration::findFormulaOverlaps(outcome.fit, measurements);
  if (!outcome.overlaps.empty()) outcome.figures["overlap"] = overlapJson(outcome.overlaps);
  outcome.centring = predictCentring(cell, outcome.fit, request.stages.size() > 1, hooks.stop);
  throwIfJobStopped(hooks);
  outcome.figures["predicted_centring_error"] = predictedCentringJson(outcome.centring, cell.units);
  outcome.of_effects = effectWarnings(request, cell, measurements, outcome.fit, hooks);
  throwIfJobStopped(hooks);
  for (const auto& warning : effectWarningsJson(outcome.of_effects, cell.units))
    outcome.figures["warnings"].push_back(warning);
  return outcome;
}

}  // namespace tubeplan::app
