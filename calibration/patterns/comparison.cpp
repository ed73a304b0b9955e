#include "calibration/patterns/comparison.hpp"

#include <algorithm>

#include "calibration/estimation/evidence.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/fitted_basis.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/patterns/variable_words.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::Vector3d, Eigen::VectorXd;

namespace {

/// A model evaluated at the measurements that are not held out.
struct Evaluation {
  PlacedArm placed;
  MeasurementWeights weights;
  WhitenedResidual residual;
  MeasurementScene scene;
  bool ok = false;
};

Evaluation evaluate(const PlacedArm& placed, const std::vector<Measurement>& measurements) {
  Evaluation result{placed, {}, {}, observe(placed, measurements), false};
  auto weights = weighMeasurements(placed, measurements);
  if (!result.scene.ok || !weights) return result;
  result.weights = std::move(*weights);
  result.residual = whitenedResidual(placed, {}, measurements, result.weights, VectorXd::Zero(0), true);
  result.ok = result.residual.ok;
  return result;
}

bool isInadequate(const ModelLackOfFit& lack_of_fit, double level) {
  const Repeats& repeats = lack_of_fit.repeats;
  const bool by_repeats = disagreesWithStatedNoise(repeats, level) && repeats.lack_freedom > 0;
  return areBeyondNoise(repeats) || (by_repeats ? repeats.lack_of_fit_p_value : lack_of_fit.p_value) < level;
}

std::string inconclusiveSince(const ModelLackOfFit& lack_of_fit, const std::vector<Measurement>& measurements,
                              int numbers) {
  auto problem = findLackOfFreedom(measurements, lack_of_fit.degrees_of_freedom, numbers);
  if (!problem) problem = findOverstatedNoise(lack_of_fit.chi2, lack_of_fit.degrees_of_freedom);
  return problem ? problem->what + " (needed: " + problem->needed + ")" : "";
}

ModelLackOfFit lackOfFitOf(const Evaluation& model, int fitted_numbers, double level) {
  ModelLackOfFit lack_of_fit;
  lack_of_fit.errors = errorSize(model.scene.measurements, model.weights, model.residual.error);
  lack_of_fit.noise_floor = noiseFloor(model.scene.measurements, model.weights);
  lack_of_fit.chi2 = model.residual.r.squaredNorm();
  lack_of_fit.degrees_of_freedom = model.weights.degrees_of_freedom - fitted_numbers;
  lack_of_fit.p_value = chiSquareTail(lack_of_fit.chi2, lack_of_fit.degrees_of_freedom);
  lack_of_fit.repeats = judgeRepeats(model.scene.measurements, model.weights, model.residual.error, lack_of_fit.chi2,
                                     lack_of_fit.degrees_of_freedom);
  lack_of_fit.inconclusive = inconclusiveSince(lack_of_fit, model.scene.measurements, fitted_numbers);
  lack_of_fit.adequacy = isInadequate(lack_of_fit, level)   ? Adequacy::kInadequate
                         : lack_of_fit.inconclusive.empty() ? Adequacy::kAdequate
                                                            : Adequacy::kInconclusive;
  return lack_of_fit;
}

/// Returns the error of a measurement, measured minus predicted, in the world frame [m]: along the line for a
/// measurement along a line, zero for a measurement of rotation alone.
Vector3d errorInWorld(const Evaluation& model, std::size_t k) {
  const auto& measurement = model.scene.measurements[k];
  const Index row = model.weights.first_row[k];
  return -placeSlope(model.scene, k).transpose() * model.residual.error.segment(row, rowsOf(measurement));
}

double turnOf(const Evaluation& model, std::size_t k) {
  const auto& measurement = model.scene.measurements[k];
  return turnError(measurement, model.residual.error.segment(model.weights.first_row[k], rowsOf(measurement)));
}

double sigmasOf(const Evaluation& model, std::size_t k) {
  return model.residual.r.segment(model.weights.first_row[k], rowsOf(model.scene.measurements[k])).norm();
}

void describeMeasurements(const Evaluation& before, const Evaluation& after, const std::vector<int>& which,
                          Comparison& result) {
  for (std::size_t k = 0; k < which.size(); ++k) {
    auto& measurement = result.measurements[static_cast<std::size_t>(which[k])];
    if (before.ok) {
      measurement.tip_before = before.scene.tips.col(static_cast<Index>(k));
      measurement.error_before = errorInWorld(before, k);
      measurement.sigmas_before = sigmasOf(before, k);
      measurement.turn_before = turnOf(before, k);
    }
    if (!after.ok) continue;
    measurement.tip_after = after.scene.tips.col(static_cast<Index>(k));
    measurement.error_after = errorInWorld(after, k);
    measurement.sigmas_after = sigmasOf(after, k);
    measurement.turn_after = turnOf(after, k);
  }
}

/// Compares the held-out measurements with the model, separately from the fitted measurements.
void describeHeldOut(const PlacedArm& start, const std::vector<Measurement>& measurements, Comparison& result) {
  std::vector<int> which;
  std::vector<Measurement> held_out;
  for (std::size_t k = 0; k < measurements.size(); ++k)
    if (measurements[k].is_held_out) which.push_back(static_cast<int>(k)), held_out.push_back(measurements[k]);
  if (held_out.empty()) return;
  for (const int k : which) result.measurements[static_cast<std::size_t>(k)].is_held_out = true;
  describeMeasurements(evaluate(start, held_out), evaluate(result.fitted, held_out), which, result);
}

void listWorst(Comparison& result) {
  result.worst = result.used;
  std::stable_sort(result.worst.begin(), result.worst.end(), [&](int a, int b) {
    return result.measurements[static_cast<std::size_t>(a)].sigmas_after >
           result.measurements[static_cast<std::size_t>(b)].sigmas_after;
  });
}

/// Fits the free parameters. Returns false if there is no model to continue with; `result` then states the reason.
bool refit(const PlacedArm& start, const std::vector<Measurement>& measurements, const ComparisonOptions& options,
           Comparison& result) {
  result.fitted = start;
  const bool has_base = options.refit.free.base && std::any_of(start.base_poses.begin(), start.base_poses.end(),
                                                               [](const BasePose& p) { return !p.is_known; });
  if (options.refit.free.names.empty() && !has_base) return true;
  IdentificationOptions refit = options.refit;
  refit.hooks = options.hooks;
  result.refit = options.refitted ? *options.refitted : identify(start, measurements, refit);
  throwIfStopped(options.hooks.stop);
  result.reason = result.refit.reason;
  result.problems = result.refit.problems;
  if (result.refit.status == IdentificationStatus::kRefused) result.status = ComparisonStatus::kRefused;
  if (result.refit.status == IdentificationStatus::kNotConverged) result.status = ComparisonStatus::kNotConverged;
  if (result.refit.fitted.arm.rows.empty()) return false;
  result.fitted = result.refit.fitted;
  return true;
}

/// Returns the fitted model at the measurements, with the Jacobian with respect to the fitted unknowns if there are
/// any.
Evaluation evaluateFitted(const PlacedArm& placed, const Identification& fit, const std::vector<Measurement>& fitted) {
  Evaluation after = evaluate(placed, fitted);
  if (!after.ok || fit.status == IdentificationStatus::kNotRun) return after;
  FittedBasis basis = basisOf(fit, fitted);
  after.ok = basis.residual.ok;
  after.residual = std::move(basis.residual);
  return after;
}

int numbersFitted(const Evaluation& after, const Identification& fit) {
  return fit.status == IdentificationStatus::kNotRun ? 0 : after.weights.degrees_of_freedom - fit.degrees_of_freedom;
}

void giveVerdict(Comparison& result, double level) {
  const auto& lack_of_fit = result.after_refit;
  result.noise_disagrees = disagreesWithStatedNoise(lack_of_fit.repeats, level);
  if (result.status == ComparisonStatus::kNotConverged) result.grounds.emplace_back("the refit did not converge");
  const bool is_beyond = areBeyondNoise(lack_of_fit.repeats);
  if (is_beyond) result.grounds.emplace_back("repeated readings differ by more than any noise");
  if (lack_of_fit.adequacy == Adequacy::kInadequate && !is_beyond)
    result.grounds.emplace_back(result.noise_disagrees ? "the error exceeds the scatter of repeated readings"
                                                       : "the error exceeds the stated noise");
  if (!result.patterns.findings.empty()) {
    const auto& first = result.patterns.findings.front();
    result.grounds.push_back(first.trend.size() == 1 ? "part of the error is constant"
                                                     : "the error follows " + variableWords(first.variable));
  }
  result.verdict = result.grounds.empty() ? lack_of_fit.adequacy : Adequacy::kInadequate;
  if (result.verdict == Adequacy::kInconclusive) result.grounds.push_back(lack_of_fit.inconclusive);
}

Comparison compareUnlessStopped(const PlacedArm& start, const std::vector<Measurement>& measurements,
                                const ComparisonOptions& options) {
  Comparison result;
  result.measurements.resize(measurements.size());
  std::vector<Measurement> fitted;
  for (std::size_t k = 0; k < measurements.size(); ++k)
    if (!measurements[k].is_held_out) result.used.push_back(static_cast<int>(k)), fitted.push_back(measurements[k]);
  if (fitted.empty()) {
    result.status = ComparisonStatus::kRefused;
    result.reason = "every reading is held out";
    return result;
  }
  const Evaluation before = evaluate(start, fitted);
  if (before.ok) {
    result.as_it_stands = lackOfFitOf(before, 0, options.level);
    result.joints_before = equivalentJoints(start, fitted, before.residual.error);
  }
  if (!refit(start, measurements, options, result)) return result;
  const Evaluation after = evaluateFitted(result.fitted, result.refit, fitted);
  if (!after.ok) {
    result.status = ComparisonStatus::kRefused;
    result.reason = "the deflected shape does not converge: the arm is too compliant for its load";
    return result;
  }
  if (result.status == ComparisonStatus::kNotRun) result.status = ComparisonStatus::kDone;
  result.after_refit = lackOfFitOf(after, numbersFitted(after, result.refit), options.level);
  result.joints_after = equivalentJoints(result.fitted, fitted, after.residual.error);
  describeMeasurements(before, after, result.used, result);
  describeHeldOut(start, measurements, result);
  listWorst(result);
  result.patterns = searchPatterns(after.scene, after.weights, after.residual, options.level, options.hooks);
  giveVerdict(result, options.level);
  return result;
}

}  // namespace

const char* nameOf(Adequacy adequacy) {
  switch (adequacy) {
    case Adequacy::kNotRun:
      return "not-run";
    case Adequacy::kAdequate:
      return "adequate";
    case Adequacy::kInadequate:
      return "falls-short";
    case Adequacy::kInconclusive:
      return "inconclusive";
  }
  return "";
}

const char* wordsOf(Adequacy adequacy) {
  switch (adequacy) {
    case Adequacy::kNotRun:
      return "Not compared";
    case Adequacy::kAdequate:
      return "Adequate: nothing is missing";
    case Adequacy::kInadequate:
      return "The model falls short";
    case Adequacy::kInconclusive:
      return "Inconclusive: more readings are needed";
  }
  return "";
}

ModelLackOfFit lackOfFitOf(const Identification& fit, const std::vector<Measurement>& measurements, double level) {
  std::vector<Measurement> fitted;
  for (const int k : fit.used) fitted.push_back(measurements[static_cast<std::size_t>(k)]);
  if (fitted.empty() || fit.fitted.arm.rows.empty()) return {};
  const Evaluation after = evaluateFitted(fit.fitted, fit, fitted);
  return after.ok ? lackOfFitOf(after, numbersFitted(after, fit), level) : ModelLackOfFit{};
}

Comparison compare(const PlacedArm& start, const std::vector<Measurement>& measurements,
                   const ComparisonOptions& options) {
  return unlessStopped(&Comparison::status, ComparisonStatus::kStopped,
                       [&] { return compareUnlessStopped(start, measurements, options); });
}

}  // namespace tubeplan::calibration
