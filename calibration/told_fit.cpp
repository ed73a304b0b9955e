#include "calibration/told_fit.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cmath>

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kMisfitLevel = 0.01;  // p below which the stated noise is taken to be too small
constexpr double kUnseenRise = 0.05;   // of chi-square, that nobody notices
constexpr double kBoundMargin = 1e-4;  // of a typical size, that counts as at the bound
constexpr double kFirstLook = 0.1;     // noise sigmas that a number must show at the start, which may be far too stiff

std::vector<Unknown> pick(const std::vector<Unknown>& unknowns, const std::vector<int>& which) {
  std::vector<Unknown> some;
  for (const int k : which) some.push_back(unknowns[static_cast<std::size_t>(k)]);
  return some;
}

void countWork(const LeastSquaresResult& solution, Identification& result) {
  result.iterations += solution.iterations;
  result.evaluations += solution.evaluations;
  result.jacobian_evaluations += solution.jacobian_evaluations;
}

/// Keeps what the readings tell, by the Jacobian of the kept unknowns; false where nothing changes.
bool holdUntold(ToldFit& work, const MatrixXd& jacobian, const IdentifiabilityOptions& options) {
  const std::vector<int> before = work.told.kept;
  const Identifiability now = findIdentifiable(jacobian, work.kept(), options);
  work.told.singular_values = now.singular_values;
  if (now.held.empty()) return false;
  work.told.kept.clear();
  for (const int k : now.kept) work.told.kept.push_back(before[static_cast<std::size_t>(k)]);
  for (HeldUnknown held : now.held) {
    held.unknown = before[static_cast<std::size_t>(held.unknown)];
    for (int& other : held.with) other = before[static_cast<std::size_t>(other)];
    work.told.held.push_back(held);
  }
  return true;
}

VectorXd drawStart(const std::vector<Unknown>& unknowns, std::uint64_t seed, int start) {
  boost::random::mt19937_64 random(seed * 7919 + static_cast<std::uint64_t>(start));
  boost::random::uniform_real_distribution<double> uniform(-1, 1);
  VectorXd x(static_cast<Index>(unknowns.size()));
  for (Index k = 0; k < x.size(); ++k) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(k)];
    const double size = unknown.owner == Unknown::Owner::kBase ? 0.05 * unknown.typical : 1.1 * unknown.typical;
    x[k] = std::clamp(size * uniform(random), unknown.lower, unknown.upper);
  }
  return x;
}

Fit fitFromStarts(const ToldFit& work, const VectorXd& first, Identification& result) {
  const auto kept = work.kept();
  Fit best;
  std::vector<double> ends;
  const int starts = std::max(1, work.options.starts);
  for (int s = 0; s < starts; ++s) {
    tell(work.options.hooks, "fit", static_cast<std::size_t>(s), starts > 1 ? static_cast<std::size_t>(starts) : 0);
    Fit fit = fitUnknowns(work.start, kept, work.fitted, s == 0 ? first : drawStart(kept, work.options.seed, s),
                          work.options.solver, work.options.loss);
    countWork(fit.solution, result);
    ends.push_back(fit.solution.status == LeastSquaresStatus::kFailed ? std::numeric_limits<double>::infinity()
                                                                      : fit.solution.chi2);
    if (s == 0 || ends.back() < *std::min_element(ends.begin(), ends.end() - 1)) best = std::move(fit);
  }
  const double least = *std::min_element(ends.begin(), ends.end());
  result.starts_agreeing = static_cast<int>(
      std::count_if(ends.begin(), ends.end(), [&](double e) { return e <= least + 0.01 + 1e-6 * least; }));
  return best;
}

/// The variables of the unknowns that are still kept.
VectorXd stillKept(const VectorXd& x, const std::vector<int>& before, const std::vector<int>& kept) {
  VectorXd some(static_cast<Index>(kept.size()));
  for (std::size_t k = 0; k < kept.size(); ++k)
    some[static_cast<Index>(k)] = x[std::find(before.begin(), before.end(), kept[k]) - before.begin()];
  return some;
}

/// Leaves those that are no longer kept where the fit had brought them: back at their start, they would show, since
/// what should make up for them is at its bound.
void leaveWhereTheyAre(const VectorXd& x, const std::vector<int>& before, ToldFit& work) {
  for (std::size_t k = 0; k < before.size(); ++k) {
    const Unknown& unknown = work.unknowns[static_cast<std::size_t>(before[k])];
    const bool is_kept = std::count(work.told.kept.begin(), work.told.kept.end(), before[k]) > 0;
    if (!is_kept && unknown.owner == Unknown::Owner::kArm)
      deflection::locate(work.start.arm, unknown.path) = valueAt(unknown, x[static_cast<Index>(k)]);
  }
}

bool fitKept(ToldFit& work, const VectorXd& x, Identification& result) {
  work.fit = fitFromStarts(work, x, result);
  return work.fit.solution.status != LeastSquaresStatus::kFailed && work.fit.residual.ok;
}

}  // namespace

std::vector<Unknown> ToldFit::kept() const { return pick(unknowns, told.kept); }

void fitBases(ToldFit& work, Identification& result) {
  std::vector<Unknown> bases;
  for (const auto& unknown : work.unknowns)
    if (unknown.owner == Unknown::Owner::kBase) bases.push_back(unknown);
  if (bases.empty()) return;
  alignPlacings(work.start, work.fitted);
  const auto weights = weighReadings(work.start, work.fitted);
  if (!weights) return;
  const VectorXd zero = VectorXd::Zero(static_cast<Index>(bases.size()));
  const auto residual = whitenedResidual(work.start, bases, work.fitted, *weights, zero, true);
  if (!residual.ok) return;
  const auto told = findIdentifiable(residual.jacobian, bases);
  const auto some = pick(bases, told.kept);
  const Fit fit = fitUnknowns(work.start, some, work.fitted, VectorXd::Zero(static_cast<Index>(some.size())),
                              work.options.solver, work.options.loss);
  countWork(fit.solution, result);
  if (fit.solution.status == LeastSquaresStatus::kConverged) work.start = applied(work.start, some, fit.solution.x);
}

double wideningOf(double chi2, int degrees_of_freedom) {
  if (degrees_of_freedom <= 0 || chiSquareTail(chi2, degrees_of_freedom) >= kMisfitLevel) return 1;
  return std::max(1., std::sqrt(chi2 / degrees_of_freedom));
}

std::vector<int> atBound(const std::vector<Unknown>& unknowns, const VectorXd& x) {
  std::vector<int> found;
  for (Index k = 0; k < x.size(); ++k) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(k)];
    const double margin = kBoundMargin * unknown.typical;
    if (x[k] <= unknown.lower + margin || x[k] >= unknown.upper - margin) found.push_back(static_cast<int>(k));
  }
  return found;
}

bool fitTold(ToldFit& work, Identification& result) {
  const auto n = static_cast<Index>(work.unknowns.size());
  const auto weights = weighReadings(work.start, work.fitted);
  if (!weights) return false;
  work.told.kept.resize(work.unknowns.size());
  for (std::size_t k = 0; k < work.unknowns.size(); ++k) work.told.kept[k] = static_cast<int>(k);
  const auto residual = whitenedResidual(work.start, work.unknowns, work.fitted, *weights, VectorXd::Zero(n), true);
  if (!residual.ok) return false;
  IdentifiabilityOptions options;
  options.noise = kFirstLook;
  options.twins_stay = true;
  holdUntold(work, residual.jacobian, options);
  options.twins_stay = false;
  if (!fitKept(work, VectorXd::Zero(static_cast<Index>(work.told.kept.size())), result)) return false;
  while (true) {
    const auto before = work.told.kept;
    const LeastSquaresResult solution = work.fit.solution;
    options.noise = wideningOf(solution.chi2, work.fit.weights.degrees_of_freedom - static_cast<int>(before.size()));
    options.offset = solution.x;
    options.at_bound = atBound(work.kept(), solution.x);
    if (!holdUntold(work, work.fit.residual.jacobian, options)) return true;
    const VectorXd x = stillKept(solution.x, before, work.told.kept);
    if (!fitKept(work, x, result)) return false;
    if (work.fit.solution.chi2 <= solution.chi2 + kUnseenRise * options.noise * options.noise) continue;
    leaveWhereTheyAre(solution.x, before, work);
    if (!fitKept(work, x, result)) return false;
  }
}

}  // namespace tubeplan::calibration
