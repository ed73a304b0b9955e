#include "calibration/estimation/identification.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "calibration/estimation/determined_numbers.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/held_out.hpp"
#include "calibration/estimation/identified_numbers.hpp"
#include "calibration/estimation/outliers.hpp"
#include "calibration/measurements/measurement_placement.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/measurements/measurement_problems.hpp"
#include "calibration/random_stream.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kStrongCorrelation = 0.9;
// With at least this many measurements, each fold's fit is approximated by one step from the fit to all measurements.
constexpr std::size_t kManyMeasurements = 1000;

std::vector<int> placesOf(const std::vector<Measurement>& all, bool held_out) {
  std::vector<int> places;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k].is_held_out == held_out) places.push_back(static_cast<int>(k));
  return places;
}

void listCorrelations(Identification& result) {
  const VectorXd sigma = result.covariance.diagonal().cwiseSqrt();
  for (Index i = 0; i < sigma.size(); ++i)
    for (Index j = i + 1; j < sigma.size(); ++j) {
      const double value = result.covariance(i, j) / (sigma[i] * sigma[j]);
      if (std::abs(value) > kStrongCorrelation)
        result.correlations.push_back({result.numbers[static_cast<std::size_t>(i)].unknown.name,
                                       result.numbers[static_cast<std::size_t>(j)].unknown.name, value});
    }
}

std::vector<Unknown> basesOf(const std::vector<Unknown>& unknowns) {
  std::vector<Unknown> bases;
  std::ranges::copy_if(unknowns, std::back_inserter(bases),
                       [](const Unknown& unknown) { return unknown.owner == Unknown::Owner::kBase; });
  return bases;
}

FitOptions fitOptions(const IdentificationOptions& options) { return {options.solver, options.loss}; }

void judgeHeldOut(const FittedModel& model, const std::vector<Measurement>& all, Identification& result) {
  if (!all.empty()) {
    const auto held_out = judgeable(result.fitted, model.fitted, all);
    result.not_judged = static_cast<int>(all.size() - held_out.size());
    result.heldout_before = judge(result.start, held_out);
    result.heldout = judge(result.fitted, held_out);
    return;
  }
  if (model.options.folds < 2) return;
  if (model.unknowns.empty()) {  // nothing is fitted, so the held-out errors equal the fitted errors
    result.heldout = result.heldout_before = result.after_base;
    return;
  }
  const auto folds = foldsOf(model.fitted, model.options.folds, model.options.seed);
  FitOptions options = fitOptions(model.options);
  options.model_error = result.model_error;
  const auto bases = basesOf(model.unknowns);
  const bool is_by_steps = model.fitted.size() >= kManyMeasurements && model.options.loss == RobustLoss::kNone;
  const auto by_steps = is_by_steps ? crossValidateBySteps(model.start, model.unknowns, model.fitted, model.fit, folds,
                                                           model.options.hooks)
                                    : std::nullopt;
  result.heldout = by_steps ? *by_steps
                            : crossValidate(model.start, model.unknowns, model.fitted, model.fit.solution.x, folds,
                                            options, model.options.hooks);
  // No base is fitted, so the held-out errors equal the fitted errors.
  const bool is_fixed = bases.empty() && result.heldout.measurements > 0;
  result.heldout_before =
      is_fixed ? result.after_base : crossValidate(model.start, bases, model.fitted, zerosOf(bases), folds, options);
}

/// Returns the singular values of the measurements' Jacobian with respect to the variables divided by their typical
/// sizes.
VectorXd singularValues(MatrixXd jacobian, const std::vector<Unknown>& unknowns) {
  if (unknowns.empty()) return {};
  jacobian.array().rowwise() *= typicalsOf(unknowns).transpose().array();
  const MatrixXd square = jacobian.transpose() * jacobian;
  return square.selfadjointView<Eigen::Lower>().eigenvalues().cwiseMax(0).cwiseSqrt().reverse();
}

/// Returns the errors at the solution [m]. Positions of unknown touched points are estimated without the weight factors
/// of the robust loss.
VectorXd errorsOf(const FittedModel& model) {
  if (model.fit.factors.size() == 0) return model.fit.residual.error;
  const MeasurementWeights plain = reweighted(model.fit.weights, model.fitted, model.fit.weights.model_error);
  return whitenedResidual(model.start, model.unknowns, model.fitted, plain, model.fit.solution.x, false,
                          model.options.hooks.stop)
      .error;
}

void summarize(const FittedModel& model, Identification& result) {
  const Fit& fit = model.fit;
  result.fitted = applied(model.start, model.unknowns, fit.solution.x);
  result.chi2 = fit.chi2;
  result.degrees_of_freedom = fit.degrees_of_freedom;
  result.p_value = fit.p_value;
  result.model_error = fit.weights.model_error;
  result.covariance = fit.covariance;
  result.singular_values = singularValues(fit.residual.jacobian, model.unknowns);
  const VectorXd errors = errorsOf(model);
  result.after = errorSize(model.fitted, fit.weights, errors);
  result.errors = errorLengths(model.fitted, fit.weights, errors);
  result.noise_floor = noiseFloor(model.fitted, fit.weights);
  describeNumbers(model, result);
  listCorrelations(result);
  result.outliers = findOutliers(model.fitted, fit, model.options.outlier_level);
  for (auto& outlier : result.outliers)
    outlier.measurement = result.used[static_cast<std::size_t>(outlier.measurement)];
}

/// Fits only the unknown base poses, so that the fit of all unknowns then starts near its solution.
void fitBases(FittedModel& model, Identification& result) {
  const auto bases = basesOf(model.unknowns);
  if (bases.empty()) return;
  alignBases(model.start, model.fitted);
  const Fit fit = fitUnknowns(model.start, bases, model.fitted, zerosOf(bases), fitOptions(model.options));
  countWork(fit.solution, result);
  if (fit.solution.status == LeastSquaresStatus::kConverged) model.start = applied(model.start, bases, fit.solution.x);
}

VectorXd drawStart(const std::vector<Unknown>& unknowns, std::uint64_t seed, int start) {
  RandomStream random(seed * 7919 + static_cast<std::uint64_t>(start));
  VectorXd x(static_cast<Index>(unknowns.size()));
  for (Index k = 0; k < x.size(); ++k) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(k)];
    const double size = unknown.owner == Unknown::Owner::kBase ? 0.05 * unknown.typical : 1.1 * unknown.typical;
    x[k] = std::clamp(size * random.uniform(-1, 1), unknown.lower, unknown.upper);
  }
  return x;
}

bool isUsable(const Fit& fit) { return fit.solution.status != LeastSquaresStatus::kFailed && fit.residual.ok; }

/// Fits from one or several starts and keeps the fit with the smallest chi-square; returns false if none succeeds.
bool fitFromStarts(FittedModel& model, Identification& result) {
  std::vector<double> ends;
  const int starts = std::max(1, model.options.starts);
  FitOptions options = fitOptions(model.options);
  options.solver.observe = model.options.observe;
  for (int s = 0; s < starts; ++s) {
    reportProgress(model.options.hooks, "fit", static_cast<std::size_t>(s),
                   starts > 1 ? static_cast<std::size_t>(starts) : 0);
    options.weights = s == 0 && model.start_weights ? &*model.start_weights : nullptr;
    const VectorXd x = s == 0 ? zerosOf(model.unknowns) : drawStart(model.unknowns, model.options.seed, s);
    Fit fit = fitUnknowns(model.start, model.unknowns, model.fitted, x, options);
    countWork(fit.solution, result);
    ends.push_back(isUsable(fit) ? fit.chi2 : std::numeric_limits<double>::infinity());
    if (s == 0 || ends.back() < *std::min_element(ends.begin(), ends.end() - 1)) model.fit = std::move(fit);
  }
  const double least = *std::ranges::min_element(ends);
  result.starts_agreeing =
      static_cast<int>(std::ranges::count_if(ends, [&](double e) { return e <= least + 0.01 + 1e-6 * least; }));
  return isUsable(model.fit);
}

/// Stores the errors of the model before the fit in `size`, and returns the measurements' weights; empty if the model
/// cannot be evaluated.
std::optional<MeasurementWeights> measureStart(const PlacedArm& placed, const std::vector<Measurement>& fitted,
                                               ErrorSize& size) {
  auto weights = weighMeasurements(placed, fitted);
  if (!weights) return weights;
  const auto residual = whitenedResidual(placed, {}, fitted, *weights, {}, false);
  if (!residual.ok) return std::nullopt;
  size = errorSize(fitted, *weights, residual.error);
  return weights;
}

void noteMeasurementProblem(const std::vector<Measurement>& fitted, const std::vector<Unknown>& unknowns,
                            Identification& result) {
  result.measurement_problem = findMeasurementProblem(fitted, unknowns);
  if (!result.measurement_problem) return;
  MeasurementProblem& problem = *result.measurement_problem;
  result.reason = problem.what;
  if (problem.measurement >= 0) problem.measurement = result.used[static_cast<std::size_t>(problem.measurement)];
}

/// Removes a parameter from the model: a stiffness becomes rigid, any other parameter returns to its start value.
void giveUp(const IdentifiedNumber& number, PlacedArm& start) {
  const bool is_stiffness = number.unknown.scale != Unknown::Scale::kLinear;
  deflection::locate(start.arm, number.unknown.path) = is_stiffness ? deflection::kRigid : number.unknown.start;
}

/// Returns the difference between a parameter and its value when dropped, in sigmas.
double needOf(const IdentifiedNumber& number) {
  // A dropped stiffness has zero compliance; value / sigma is the same for the compliance as for the stiffness.
  if (number.unknown.scale != Unknown::Scale::kLinear) return number.value / number.sigma;
  return std::abs(number.value - number.unknown.start) / number.sigma;
}

/// Returns the index of the least significant parameter if its p-value exceeds `level`; otherwise -1.
int leastNeeded(const Identification& result, double level) {
  int least = -1;
  double need = std::numeric_limits<double>::infinity();
  for (int k = 0; k < static_cast<int>(result.numbers.size()); ++k) {
    const auto& number = result.numbers[static_cast<std::size_t>(k)];
    if (number.unknown.owner == Unknown::Owner::kBase || number.unknown.is_geometry) continue;
    if (needOf(number) < need) need = needOf(number), least = k;
  }
  return least >= 0 && chiSquareTail(need * need, 1) > level ? least : -1;
}

Identification identifyOnce(const PlacedArm& start, const std::vector<Measurement>& measurements,
                            const IdentificationOptions& options);

/// Identifies once or, if `drop_level` is above 0, repeatedly, each time without the least significant parameter.
Identification identifyNeeded(const PlacedArm& start, const std::vector<Measurement>& measurements,
                              const IdentificationOptions& options) {
  PlacedArm from = start;
  IdentificationOptions now = options;
  now.solver.stop = options.hooks.stop;
  std::vector<std::string> dropped;
  while (true) {
    Identification result = identifyOnce(from, measurements, now);
    const int least = options.drop_level > 0 && result.status == IdentificationStatus::kDone
                          ? leastNeeded(result, options.drop_level)
                          : -1;
    if (least < 0 || result.numbers.size() < 2) {
      result.dropped = std::move(dropped);
      return result;
    }
    const auto& number = result.numbers[static_cast<std::size_t>(least)];
    std::vector<std::string> names;
    for (const auto& group : now.free.names)
      for (const auto& name : group == "geometry" ? std::vector<std::string>{group} : namesBehind(from.arm, group))
        if (name != number.unknown.name) names.push_back(name);
    now.free.names = names;
    const double p = chiSquareTail(needOf(number) * needOf(number), 1);
    dropped.push_back(
        number.unknown.name + ": not significant (p = " + std::to_string(p).substr(0, 5) + "); " +
        (number.unknown.scale == Unknown::Scale::kLinear ? "kept at its initial value" : "taken as rigid"));
    giveUp(number, from);
  }
}

Identification identifyOnce(const PlacedArm& start, const std::vector<Measurement>& measurements,
                            const IdentificationOptions& options) {
  Identification result;
  result.used = placesOf(measurements, false);
  const auto fitted = picked(measurements, result.used), held_out = picked(measurements, placesOf(measurements, true));
  FittedModel model{fitted, options, start, {}, {}, {}};
  auto unknowns = chooseUnknowns(model.start, options.free);
  result.problems = unknowns.problems;
  model.unknowns = std::move(unknowns.list);
  if (result.problems.empty() && model.unknowns.empty() && !options.may_hold_all)
    result.reason = "no free parameter: name one to identify";
  if (!result.problems.empty()) result.reason = result.problems.front().what;
  if (result.reason.empty()) noteMeasurementProblem(fitted, model.unknowns, result);
  if (!result.reason.empty()) {
    result.status = IdentificationStatus::kRefused;
    return result;
  }
  model.start_weights = measureStart(start, fitted, result.before);
  fitBases(model, result);
  result.start = model.start;
  if (basesOf(model.unknowns).empty())
    result.after_base = result.before;
  else
    model.start_weights = measureStart(model.start, fitted, result.after_base);
  if (!fitFromStarts(model, result)) {
    result.status = IdentificationStatus::kNotConverged;
    result.reason =
        model.fit.solution.reason.empty() ? "the model cannot be evaluated at the readings" : model.fit.solution.reason;
    return result;
  }
  summarize(model, result);
  if (options.intervals_by_profile) widenSizes(model, result);
  if (options.uncertainty) result.uncertainty = determinedNumbers(result, fitted, *options.uncertainty);
  judgeHeldOut(model, held_out, result);
  const bool converged = model.fit.solution.status == LeastSquaresStatus::kConverged;
  result.status = converged ? IdentificationStatus::kDone : IdentificationStatus::kNotConverged;
  if (!converged) result.reason = model.fit.solution.reason;
  return result;
}

}  // namespace

Identification identify(const PlacedArm& start, const std::vector<Measurement>& measurements,
                        const IdentificationOptions& options) {
  return unlessStopped(&Identification::status, IdentificationStatus::kStopped,
                       [&] { return identifyNeeded(start, measurements, options); });
}

std::vector<Unknown> fittedUnknowns(const Identification& result) {
  std::vector<Unknown> unknowns;
  for (const IdentifiedNumber& number : result.numbers) unknowns.push_back(rebased(number.unknown, number.value));
  return unknowns;
}

Identification identify(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                        const std::vector<Measurement>& measurements, const IdentificationOptions& options) {
  return identify(placeForMeasurements(arm, X_WB, base_known, measurements), measurements, options);
}

}  // namespace tubeplan::calibration
