#include "calibration/identification.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/fit.hpp"
#include "calibration/held_out.hpp"
#include "calibration/identified_numbers.hpp"
#include "calibration/outliers.hpp"
#include "calibration/reading_prediction.hpp"
#include "calibration/reading_problems.hpp"
#include "calibration/told_fit.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kStrongCorrelation = 0.9;

std::vector<Measurement> readingsOf(const std::vector<Measurement>& all, bool held_out, std::vector<int>* used) {
  std::vector<Measurement> some;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].is_held_out != held_out) continue;
    some.push_back(all[k]);
    if (used) used->push_back(static_cast<int>(k));
  }
  return some;
}

void listCorrelations(const ToldFit& work, Identification& result) {
  const VectorXd sigma = result.covariance.diagonal().cwiseSqrt();
  for (Index i = 0; i < sigma.size(); ++i)
    for (Index j = i + 1; j < sigma.size(); ++j) {
      const double value = result.covariance(i, j) / (sigma[i] * sigma[j]);
      if (std::abs(value) > kStrongCorrelation)
        result.correlations.push_back(
            {work.unknowns[static_cast<std::size_t>(work.told.kept[static_cast<std::size_t>(i)])].name,
             work.unknowns[static_cast<std::size_t>(work.told.kept[static_cast<std::size_t>(j)])].name, value});
    }
}

void judgeHeldOut(const ToldFit& work, const std::vector<Measurement>& held_out, Identification& result) {
  if (!held_out.empty()) {
    result.heldout_before = judge(result.start, held_out);
    result.heldout = judge(result.fitted, held_out);
    return;
  }
  if (work.options.folds < 2) return;
  const auto folds = foldsOf(work.fitted, work.options.folds, work.options.seed);
  std::vector<Unknown> bases;
  for (const auto& unknown : work.kept())
    if (unknown.owner == Unknown::Owner::kBase) bases.push_back(unknown);
  result.heldout_before =
      crossValidate(work.start, bases, work.fitted, VectorXd::Zero(static_cast<Index>(bases.size())), folds,
                    work.options.solver, work.options.loss);
  result.heldout = crossValidate(work.start, work.kept(), work.fitted, work.fit.solution.x, folds, work.options.solver,
                                 work.options.loss, work.options.hooks);
}

void summarize(ToldFit& work, Identification& result) {
  result.fitted_numbers = work.told.kept;
  result.singular_values = work.told.singular_values;
  result.fitted = applied(work.start, work.kept(), work.fit.solution.x);
  result.chi2 = work.fit.solution.chi2;
  result.degrees_of_freedom = work.fit.weights.degrees_of_freedom - static_cast<int>(work.told.kept.size());
  result.p_value = chiSquareTail(result.chi2, result.degrees_of_freedom);
  result.widening = wideningOf(result.chi2, result.degrees_of_freedom);
  result.after = errorSize(work.fitted, work.fit.weights, work.fit.residual.error);
  result.errors = errorLengths(work.fitted, work.fit.weights, work.fit.residual.error);
  result.noise_floor = noiseFloor(work.fitted, work.fit.weights);
  result.covariance = covarianceOf(work.fit.residual.jacobian);
  for (const auto& unknown : work.unknowns) {
    result.numbers.emplace_back();
    result.numbers.back().unknown = unknown;
  }
  sayHeld(work, result);
  sayFitted(work, result);
  listCorrelations(work, result);
  result.outliers = findOutliers(work.fitted, work.fit, result.covariance, work.options.outlier_level);
  for (auto& outlier : result.outliers) outlier.reading = result.used[static_cast<std::size_t>(outlier.reading)];
}

void measureStart(const PlacedArm& placed, const std::vector<Measurement>& fitted, ErrorSize& size, double* chi2) {
  const auto weights = weighReadings(placed, fitted);
  if (!weights) return;
  const auto residual = whitenedResidual(placed, {}, fitted, *weights, {}, false);
  if (!residual.ok) return;
  size = errorSize(fitted, *weights, residual.error);
  if (chi2) *chi2 = residual.r.squaredNorm();
}

void noteReadingProblem(const std::vector<Measurement>& fitted, const std::vector<Unknown>& unknowns,
                        Identification& result) {
  result.reading_problem = findReadingProblem(fitted, unknowns);
  if (!result.reading_problem) return;
  ReadingProblem& problem = *result.reading_problem;
  result.reason = "found " + problem.found + ", expected " + problem.expected;
  if (problem.reading >= 0) problem.reading = result.used[static_cast<std::size_t>(problem.reading)];
}

/// A stiffness that the readings do not need is rigid; any other number stays at its start.
void giveUp(const IdentifiedNumber& number, PlacedArm& start) {
  const bool is_stiffness = number.unknown.scale != Unknown::Scale::kLinear;
  deflection::locate(start.arm, number.unknown.path) = is_stiffness ? deflection::kRigid : number.unknown.start;
}

/// How many sigmas a number is from what it would be if it were given up.
double needOf(const IdentifiedNumber& number) {
  if (number.unknown.scale != Unknown::Scale::kLinear) return number.value / number.sigma;  // of the compliance
  return std::abs(number.value - number.unknown.start) / number.sigma;
}

/// The number that the readings need least, where its chance of being nothing is above the level; -1 otherwise.
int leastNeeded(const Identification& result, double level) {
  int least = -1;
  double need = std::numeric_limits<double>::infinity();
  for (int k = 0; k < static_cast<int>(result.numbers.size()); ++k) {
    const auto& number = result.numbers[static_cast<std::size_t>(k)];
    if (number.unknown.owner == Unknown::Owner::kBase || number.unknown.is_geometry || number.is_held) continue;
    if (needOf(number) < need) need = needOf(number), least = k;
  }
  return least >= 0 && chiSquareTail(need * need, 1) > level ? least : -1;
}

Identification identifyOnce(const PlacedArm& start, const std::vector<Measurement>& readings,
                            const IdentificationOptions& options);

/// Again and again without what the readings need least, where that is asked for.
Identification identifyNeeded(const PlacedArm& start, const std::vector<Measurement>& readings,
                              const IdentificationOptions& options) {
  PlacedArm from = start;
  IdentificationOptions now = options;
  now.solver.stop = options.hooks.stop;
  std::vector<std::string> dropped;
  while (true) {
    Identification result = identifyOnce(from, readings, now);
    const int least = options.drop_level > 0 && result.status == IdentificationStatus::kDone
                          ? leastNeeded(result, options.drop_level)
                          : -1;
    if (least < 0 || result.fitted_numbers.size() < 2) {
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
    dropped.push_back(number.unknown.name + ": the readings do not need it (p = " + std::to_string(p).substr(0, 5) +
                      "); " +
                      (number.unknown.scale == Unknown::Scale::kLinear ? "kept at its start" : "taken as rigid"));
    giveUp(number, from);
  }
}

Identification identifyOnce(const PlacedArm& start, const std::vector<Measurement>& readings,
                            const IdentificationOptions& options) {
  Identification result;
  const auto fitted = readingsOf(readings, false, &result.used);
  const auto held_out = readingsOf(readings, true, nullptr);
  ToldFit work{fitted, options, start, {}, {}, {}};
  auto unknowns = chooseUnknowns(work.start, options.free);
  result.problems = unknowns.problems;
  work.unknowns = std::move(unknowns.list);
  if (result.problems.empty() && work.unknowns.empty()) result.reason = "nothing is free: name a parameter to find";
  if (!result.problems.empty()) result.reason = result.problems.front().found;
  if (result.reason.empty()) noteReadingProblem(fitted, work.unknowns, result);
  if (!result.reason.empty()) {
    result.status = IdentificationStatus::kRefused;
    return result;
  }
  measureStart(start, fitted, result.before, &result.chi2_before);
  fitBases(work, result);
  result.start = work.start;
  measureStart(work.start, fitted, result.after_base, nullptr);
  if (!fitTold(work, result)) {
    result.status = IdentificationStatus::kNotConverged;
    result.reason =
        work.fit.solution.reason.empty() ? "the model cannot be evaluated at the readings" : work.fit.solution.reason;
    return result;
  }
  summarize(work, result);
  judgeHeldOut(work, held_out, result);
  const bool converged = work.fit.solution.status == LeastSquaresStatus::kConverged;
  result.status = converged ? IdentificationStatus::kDone : IdentificationStatus::kNotConverged;
  if (!converged) result.reason = work.fit.solution.reason;
  return result;
}

}  // namespace

Identification identify(const PlacedArm& start, const std::vector<Measurement>& readings,
                        const IdentificationOptions& options) {
  try {
    return identifyNeeded(start, readings, options);
  } catch (const WorkStopped&) {
    Identification stopped;
    stopped.status = IdentificationStatus::kStopped;
    stopped.reason = kStoppedReason;
    return stopped;
  }
}

std::vector<Unknown> fittedUnknowns(const Identification& result) {
  std::vector<Unknown> unknowns;
  for (const int k : result.fitted_numbers) {
    const IdentifiedNumber& number = result.numbers[static_cast<std::size_t>(k)];
    unknowns.push_back(rebased(number.unknown, number.value));
  }
  return unknowns;
}

Identification identify(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                        const std::vector<Measurement>& readings, const IdentificationOptions& options) {
  return identify(placeForReadings(arm, X_WB, base_known, readings), readings, options);
}

}  // namespace tubeplan::calibration
