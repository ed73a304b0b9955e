#include "calibration/identification.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cmath>
#include <tuple>

#include "calibration/fit.hpp"
#include "calibration/held_out.hpp"
#include "calibration/outliers.hpp"
#include "calibration/profile_interval.hpp"
#include "calibration/reading_prediction.hpp"
#include "calibration/reading_problems.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kMisfitLevel = 0.01;  // p below which the stated noise is taken to be too small
constexpr double kStrongCorrelation = 0.9;
constexpr double kPoorNormal = 0.2;  // sigma of a compliance over itself from which the normal interval is poor
constexpr double kLeaning = 0.3;       // correlation with a number near its bound that spoils the normal interval
constexpr double kUnseenRise = 0.05;   // of chi-square, that nobody notices
constexpr double kBoundMargin = 1e-4;  // of a typical size, that counts as at the bound
constexpr double kFirstLook = 0.1;   // noise sigmas that a number must show at the start, which may be far too stiff

std::vector<Measurement> readingsOf(const std::vector<Measurement>& all, bool held_out, std::vector<int>* used) {
  std::vector<Measurement> some;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].is_held_out != held_out) continue;
    some.push_back(all[k]);
    if (used) used->push_back(static_cast<int>(k));
  }
  return some;
}

std::vector<Unknown> pick(const std::vector<Unknown>& unknowns, const std::vector<int>& which) {
  std::vector<Unknown> some;
  for (const int k : which) some.push_back(unknowns[static_cast<std::size_t>(k)]);
  return some;
}

/// One identification under way.
struct Work {
  const std::vector<Measurement>& fitted;
  const IdentificationOptions& options;
  PlacedArm start;
  std::vector<Unknown> unknowns;
  Identifiability told;  ///< indices into `unknowns`
  Fit fit;               ///< of the kept ones

  [[nodiscard]] std::vector<Unknown> kept() const { return pick(unknowns, told.kept); }
};

void countWork(const LeastSquaresResult& solution, Identification& result) {
  result.iterations += solution.iterations;
  result.evaluations += solution.evaluations;
  result.jacobian_evaluations += solution.jacobian_evaluations;
}

/// Places unknown bases with nothing else free, so that the rest starts from a sensible place.
void fitBases(Work& work, Identification& result) {
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

/// Keeps what the readings tell, by the Jacobian of the kept unknowns; false where nothing changes.
bool holdUntold(Work& work, const MatrixXd& jacobian, const IdentifiabilityOptions& options) {
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

double wideningOf(double chi2, int degrees_of_freedom) {
  if (degrees_of_freedom <= 0 || chiSquareTail(chi2, degrees_of_freedom) >= kMisfitLevel) return 1;
  return std::max(1., std::sqrt(chi2 / degrees_of_freedom));
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

Fit fitFromStarts(const Work& work, const VectorXd& first, Identification& result) {
  const auto kept = work.kept();
  Fit best;
  std::vector<double> ends;
  for (int s = 0; s < std::max(1, work.options.starts); ++s) {
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

std::vector<int> atBound(const std::vector<Unknown>& unknowns, const VectorXd& x) {
  std::vector<int> found;
  for (Index k = 0; k < x.size(); ++k) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(k)];
    const double margin = kBoundMargin * unknown.typical;
    if (x[k] <= unknown.lower + margin || x[k] >= unknown.upper - margin) found.push_back(static_cast<int>(k));
  }
  return found;
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
void leaveWhereTheyAre(const VectorXd& x, const std::vector<int>& before, Work& work) {
  for (std::size_t k = 0; k < before.size(); ++k) {
    const Unknown& unknown = work.unknowns[static_cast<std::size_t>(before[k])];
    const bool is_kept = std::count(work.told.kept.begin(), work.told.kept.end(), before[k]) > 0;
    if (!is_kept && unknown.owner == Unknown::Owner::kArm)
      deflection::locate(work.start.arm, unknown.path) = valueAt(unknown, x[static_cast<Index>(k)]);
  }
}

bool fitKept(Work& work, const VectorXd& x, Identification& result) {
  work.fit = fitFromStarts(work, x, result);
  return work.fit.solution.status != LeastSquaresStatus::kFailed && work.fit.residual.ok;
}

/// Fits; what the optimum shows to be untold after all is held at its start, unless that would show, and the rest
/// fitted again. The start holds only what hardly shows at all there, since it may be off by a factor: a twin held
/// there may leave the other no room.
bool fitTold(Work& work, Identification& result) {
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

std::string namesOf(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
  return text;
}

void sayHeld(const Work& work, Identification& result) {
  for (const HeldUnknown& held : work.told.held) {
    auto& number = result.numbers[static_cast<std::size_t>(held.unknown)];
    number.is_held = true;
    const bool is_of_arm = number.unknown.owner == Unknown::Owner::kArm;
    number.value = is_of_arm ? deflection::findParameter(work.start.arm, number.unknown.name)->value : 0;
    const std::string where = number.value == number.unknown.start ? "held at its start" : "held where the fit left it";
    number.told = held.is_seen && !held.with.empty() ? Told::kWith : Told::kNo;
    for (const int other : held.with) {
      number.with.push_back(work.unknowns[static_cast<std::size_t>(other)].name);
      auto& partner = result.numbers[static_cast<std::size_t>(other)];
      if (held.with.size() > 3 || partner.unknown.owner == Unknown::Owner::kBase) continue;
      partner.told = Told::kWith;
      partner.with.push_back(number.unknown.name);
    }
    if (number.told == Told::kNo)
      number.note = "the readings do not depend on it enough to tell it: " + where;
    else
      number.note = "told only in a combination with " + namesOf(number.with) + ": " + where;
  }
}

std::string noteOf(const IdentifiedNumber& number, bool hardly_gives) {
  if (number.is_at_bound && hardly_gives)
    return "the readings ask for no give at all, or less than none, which no part has: take it as rigid, or look "
           "for a missing effect";
  if (number.is_at_bound) return "at its bound: the readings ask for more than is physical";
  return hardly_gives ? "its compliance is within two sigmas of none: the readings hardly need it" : "";
}

/// Whether the normal interval of a stiffness is poor: it is wide, or made wide by another that can hardly go on in the
/// direction that would make up for it.
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

/// The profile of a kept number; those held that it is tied to may move as well.
ProfileInterval profileOf(const Work& work, const IdentifiedNumber& number, int kept, double sigma, double noise) {
  auto unknowns = work.kept();
  Fit fit = work.fit;
  std::vector<double> x(fit.solution.x.begin(), fit.solution.x.end());
  for (const HeldUnknown& held : work.told.held) {
    const Unknown& unknown = work.unknowns[static_cast<std::size_t>(held.unknown)];
    if (std::count(number.with.begin(), number.with.end(), unknown.name) == 0) continue;
    const bool is_of_arm = unknown.owner == Unknown::Owner::kArm;
    unknowns.push_back(
        is_of_arm ? rebased(unknown, deflection::findParameter(work.start.arm, unknown.name)->value) : unknown);
    x.push_back(0);
  }
  fit.solution.x = Eigen::Map<VectorXd>(x.data(), static_cast<Index>(x.size()));
  return profileInterval(work.start, unknowns, work.fitted, fit, kept, sigma, noise);
}

void sayFitted(const Work& work, Identification& result) {
  const auto kept = work.kept();
  const auto at_bound = atBound(kept, work.fit.solution.x);
  for (std::size_t i = 0; i < work.told.kept.size(); ++i) {
    auto& number = result.numbers[static_cast<std::size_t>(work.told.kept[i])];
    const Unknown& unknown = number.unknown;
    const auto k = static_cast<Index>(i);
    const double x = work.fit.solution.x[k];
    const double sigma = std::sqrt(result.covariance(k, k)) * result.widening;
    number.told = number.with.empty() ? Told::kYes : Told::kWith;
    number.value = valueAt(unknown, x);
    number.sigma = sigma * std::abs(slopeAt(unknown, x));
    double lower = x - 1.959964 * sigma, upper = x + 1.959964 * sigma;
    const bool is_compliance = unknown.scale == Unknown::Scale::kCompliance;
    const double give = 1 / number.value;  // of a stiffness: its compliance
    const bool is_tied = !number.with.empty();
    if (work.options.intervals_by_profile && is_compliance &&
        (is_tied || isNormalPoor(kept, work.fit.solution.x, result.covariance * result.widening * result.widening, k))) {
      const auto profile = profileOf(work, number, static_cast<int>(k), sigma, result.widening);
      lower = profile.lower, upper = profile.upper;
      number.is_profile = true;
    }
    std::tie(number.lower, number.upper) = valuesBetween(unknown, lower, upper);
    number.is_at_bound = std::count(at_bound.begin(), at_bound.end(), static_cast<int>(i)) > 0;
    number.note = noteOf(number, is_compliance && give < 2 * sigma);
  }
}

void listCorrelations(const Work& work, Identification& result) {
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

void judgeHeldOut(const Work& work, const std::vector<Measurement>& held_out, Identification& result) {
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
                                 work.options.loss);
}

void summarize(Work& work, Identification& result) {
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
  const MatrixXd& J = work.fit.residual.jacobian;
  result.covariance = (J.transpose() * J).ldlt().solve(MatrixXd::Identity(J.cols(), J.cols()));
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

}  // namespace

namespace {

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

}  // namespace

Identification identify(const PlacedArm& start, const std::vector<Measurement>& readings,
                        const IdentificationOptions& options) {
  PlacedArm from = start;
  IdentificationOptions now = options;
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

namespace {

Identification identifyOnce(const PlacedArm& start, const std::vector<Measurement>& readings,
                            const IdentificationOptions& options) {
  Identification result;
  const auto fitted = readingsOf(readings, false, &result.used);
  const auto held_out = readingsOf(readings, true, nullptr);
  Work work{fitted, options, start, {}, {}, {}};
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

Identification identify(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                        const std::vector<Measurement>& readings, const IdentificationOptions& options) {
  return identify(placeForReadings(arm, X_WB, base_known, readings), readings, options);
}

}  // namespace tubeplan::calibration
