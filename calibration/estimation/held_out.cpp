#include "calibration/estimation/held_out.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "calibration/estimation/prior.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/random_stream.hpp"

namespace tubeplan::calibration {

namespace {

constexpr std::size_t kLeastLeft = 6;  // smallest number of groups of a set-up that must remain, to determine its base
// Measurements are at the same posture if their joint readings differ by less than this [rad, m].
constexpr double kSamePosture = 0.01;

/// Groups measurements by posture: a measurement belongs to a group if its posture is close to that of the group's
/// first measurement.
class PostureGroups {
 public:
  /// Returns the index of the first measurement in the group of `measurement`; `measurement` itself if the group is
  /// new.
  int leaderOf(const std::vector<Measurement>& measurements, int measurement) {
    const Measurement& m = measurements[static_cast<std::size_t>(measurement)];
    const long cell = m.q.size() ? std::lround(m.q[0] / kSamePosture) : 0;
    for (const long near : {cell, cell - 1, cell + 1})
      for (const int leader : leaders_[{m.setup, near}])
        if ((m.q - measurements[static_cast<std::size_t>(leader)].q).lpNorm<Eigen::Infinity>() < kSamePosture)
          return leader;
    leaders_[{m.setup, cell}].push_back(measurement);
    return measurement;
  }

 private:
  // Indices of the groups' first measurements, keyed by set-up and by the first joint's reading, rounded to a cell.
  std::map<std::pair<std::string, long>, std::vector<int>> leaders_;
};

void collect(ErrorSize& total, double& squares, double& lengths, const ErrorSize& part) {
  if (part.measurements == 0) return;
  squares += part.rms * part.rms * part.measurements;
  lengths += part.mean * part.measurements;
  total.max = std::isnan(total.max) ? part.max : std::max(total.max, part.max);
  total.are_angles = part.are_angles && (total.are_angles || total.measurements == 0);
  total.measurements += part.measurements;
}

}  // namespace

std::vector<int> groupByPose(const std::vector<Measurement>& measurements) {
  PostureGroups postures;
  std::map<std::string, int> index;
  std::vector<int> groups;
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    // Only touches are grouped by `point`. In a measured tip position, `point` may name the reflector on the tool,
    // which is the same at every posture.
    const bool is_touch = touchesKnownPoint(measurements[k]) || touchesUnknownPoint(measurements[k]);
    const std::string key = is_touch && !measurements[k].point.empty()
                                ? "point " + measurements[k].point
                                : "posture " + std::to_string(postures.leaderOf(measurements, static_cast<int>(k)));
    groups.push_back(index.emplace(key, static_cast<int>(index.size())).first->second);
  }
  return groups;
}

namespace {

/// Returns the groups of each set-up. A group with measurements in several set-ups is listed only in the first one.
std::map<std::string, std::vector<int>> groupsBySetup(const std::vector<Measurement>& measurements,
                                                      const std::vector<int>& groups) {
  std::map<std::string, std::vector<int>> by_setup;
  std::set<int> known;
  for (std::size_t k = 0; k < measurements.size(); ++k)
    if (known.insert(groups[k]).second) by_setup[measurements[k].setup].push_back(groups[k]);
  return by_setup;
}

/// Returns the fold of each group. Groups are dealt to the folds cyclically, set-up by set-up and in the order of
/// `rank`, so that each set-up is spread over all folds. A set-up that would keep too few groups to determine its base
/// is never held out (-1), provided that another set-up is large enough.
std::vector<int> dealt(std::map<std::string, std::vector<int>> by_setup, const std::vector<int>& rank, int folds) {
  const auto leavesFew = [&](const std::vector<int>& groups) {
    const auto parts = static_cast<std::size_t>(folds);
    return groups.size() - (groups.size() + parts - 1) / parts < kLeastLeft;
  };
  const bool has_large = std::ranges::any_of(by_setup, [&](const auto& s) { return !leavesFew(s.second); });
  std::vector<int> fold(rank.size(), -1);
  int next = 0;
  for (auto& [setup, groups] : by_setup) {
    if (has_large && leavesFew(groups)) continue;
    std::ranges::sort(
        groups, [&](int a, int b) { return rank[static_cast<std::size_t>(a)] < rank[static_cast<std::size_t>(b)]; });
    for (const int group : groups) fold[static_cast<std::size_t>(group)] = next++ % folds;
  }
  return fold;
}

}  // namespace

std::vector<int> foldsOf(const std::vector<Measurement>& measurements, int folds, std::uint64_t seed) {
  const std::vector<int> groups = groupByPose(measurements);
  const int count = groups.empty() ? 0 : *std::ranges::max_element(groups) + 1;
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  RandomStream(seed).shuffle(order);
  const std::vector<int> fold_of_group = dealt(groupsBySetup(measurements, groups), order, std::max(1, folds));
  std::vector<int> result;
  for (const int group : groups) result.push_back(fold_of_group[static_cast<std::size_t>(group)]);
  return result;
}

std::vector<int> farthestQuarter(const PlacedArm& placed, const std::vector<Measurement>& measurements) {
  MeasurementPredictor predictor(placed.arm);
  const std::vector<int> groups = groupByPose(measurements);
  // Largest distance between tip and base in each group [m], keyed by set-up, then by group.
  std::map<std::string, std::map<int, double>> reach;
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    Measurement tip = measurements[k];
    tip.kind = MeasurementKind::kPosition;
    tip.row.reset();
    const auto predicted = predictor.predict(Eigen::Isometry3d::Identity(), tip);
    double& farthest = reach[measurements[k].setup].emplace(groups[k], 0).first->second;
    if (predicted.ok) farthest = std::max(farthest, predicted.value.norm());
  }
  std::map<std::string, double> least;  // for each set-up, smallest distance of a group in the farthest quarter [m]
  for (const auto& [setup, poses] : reach) {
    if (reach.size() > 1 && 3 * poses.size() / 4 < kLeastLeft) {
      least[setup] = std::numeric_limits<double>::infinity();
      continue;
    }
    std::vector<double> all;
    for (const auto& [group, farthest] : poses) all.push_back(farthest);
    const auto quarter = all.begin() + static_cast<std::ptrdiff_t>(3 * all.size() / 4);
    std::nth_element(all.begin(), quarter, all.end());
    least[setup] = *quarter;
  }
  std::vector<int> folds;
  for (std::size_t k = 0; k < measurements.size(); ++k)
    folds.push_back(reach[measurements[k].setup][groups[k]] >= least[measurements[k].setup] ? 0 : -1);
  return folds;
}

std::vector<Measurement> judgeable(const PlacedArm& placed, const std::vector<Measurement>& fitted,
                                   const std::vector<Measurement>& held_out) {
  std::set<std::string> setups;
  for (const auto& measurement : fitted) setups.insert(measurement.setup);
  std::map<std::string, int> touches;  // number of held-out touches of each unknown point or surface
  for (const auto& measurement : held_out) touches[placeOf(measurement)] += hasUnknownPlace(measurement) ? 1 : 0;
  std::vector<Measurement> kept = held_out;
  std::erase_if(kept, [&](const Measurement& measurement) {
    const bool is_underdetermined =
        hasUnknownPlace(measurement) && touches[placeOf(measurement)] < leastOfPlace(measurement);
    const auto& base = placed.base_poses[static_cast<std::size_t>(basePoseOf(placed, measurement))];
    return is_underdetermined || !(base.is_known || setups.contains(measurement.setup));
  });
  return kept;
}

ErrorSize judge(const PlacedArm& placed, const std::vector<Measurement>& judged) {
  if (judged.empty()) return {};
  const auto weights = weighMeasurements(placed, judged);
  if (!weights) return {};
  const auto residual = whitenedResidual(placed, {}, judged, *weights, {}, false);
  return residual.ok ? errorSize(judged, *weights, residual.error) : ErrorSize{};
}

ErrorSize judgeFolds(const std::vector<Measurement>& measurements, const std::vector<int>& folds,
                     const FitToMeasurements& fit, const WorkHooks& hooks) {
  ErrorSize total;
  double squares = 0, lengths = 0;
  const int count = folds.empty() ? 0 : *std::ranges::max_element(folds) + 1;
  for (int fold = 0; fold < count; ++fold) {
    reportProgress(hooks, "readings kept out", static_cast<std::size_t>(fold), static_cast<std::size_t>(count));
    std::vector<Measurement> kept, out;
    for (std::size_t k = 0; k < measurements.size(); ++k) (folds[k] == fold ? out : kept).push_back(measurements[k]);
    if (kept.empty() || out.empty()) continue;
    const auto fitted = fit(kept);
    if (!fitted) return {};
    collect(total, squares, lengths, judge(*fitted, judgeable(*fitted, kept, out)));
  }
  if (total.measurements == 0) return {};
  total.rms = std::sqrt(squares / total.measurements);
  total.mean = lengths / total.measurements;
  return total;
}

ErrorSize crossValidate(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                        const std::vector<Measurement>& measurements, const Eigen::VectorXd& x,
                        const std::vector<int>& folds, const FitOptions& options, const WorkHooks& hooks) {
  const auto fitted = [&](const std::vector<Measurement>& kept) -> std::optional<PlacedArm> {
    if (unknowns.empty()) return start;
    const Fit fit = fitUnknowns(start, unknowns, kept, x, options);
    if (fit.solution.status == LeastSquaresStatus::kFailed) return {};
    return applied(start, unknowns, fit.solution.x);
  };
  return judgeFolds(measurements, folds, fitted, hooks);
}

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Returns the row indices of all measurements that are not in the fold.
std::vector<Index> rowsOutside(int fold, const std::vector<int>& folds, const std::vector<Measurement>& measurements,
                               const MeasurementWeights& weights) {
  std::vector<Index> rows;
  for (std::size_t k = 0; k < measurements.size(); ++k)
    for (int row = 0; folds[k] != fold && row < rowsOf(measurements[k]); ++row)
      rows.push_back(weights.first_row[k] + row);
  return rows;
}

/// Returns the Gauss-Newton step from the solution of `full_fit` to the solution of a fit to the given rows
/// alone; empty if the step is too long or leaves the bounds.
std::optional<VectorXd> stepTo(const std::vector<Index>& rows, const Fit& full_fit,
                               const std::vector<Unknown>& unknowns) {
  const VectorXd& x = full_fit.solution.x;
  const MatrixXd jacobian = full_fit.residual.jacobian(rows, Eigen::all);
  const VectorXd gradient = jacobian.transpose() * full_fit.residual.r(rows) +
                            priorSlopes(unknowns).cwiseProduct(priorResiduals(unknowns, x));
  const VectorXd step = -(posteriorCovariance(jacobian, unknowns) * gradient);
  const VectorXd sigma = full_fit.covariance.diagonal().cwiseSqrt();
  if (!step.allFinite() || (step.cwiseAbs().array() > kFarthestFold * sigma.array()).any()) return {};
  for (Index k = 0; k < x.size(); ++k) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(k)];
    if (x[k] + step[k] <= unknown.lower || x[k] + step[k] >= unknown.upper) return {};
  }
  return step;
}

/// Updates the errors of the measurements in a fold, to first order, for the step to the fit without this fold.
void moveErrors(int fold, const std::vector<int>& folds, const Fit& full_fit, const VectorXd& step, VectorXd& error) {
  const MeasurementWeights& weights = full_fit.weights;
  for (std::size_t k = 0; k < folds.size(); ++k) {
    if (folds[k] != fold) continue;
    const MatrixXd& whitener = weights.whitener[k];
    const Index row = weights.first_row[k], rows = whitener.rows();
    const VectorXd moved = full_fit.residual.jacobian.middleRows(row, rows) * step;
    error.segment(row, rows) += whitener.triangularView<Eigen::Lower>().solve(moved);
  }
}

/// Cross-validates without evaluating the model again. Not valid for touches of unknown points, because each fold would
/// estimate the points' positions from its own measurements.
std::optional<ErrorSize> crossValidateToFirstOrder(const std::vector<Unknown>& unknowns,
                                                   const std::vector<Measurement>& measurements, const Fit& full_fit,
                                                   const std::vector<int>& folds, const WorkHooks& hooks) {
  const int count = folds.empty() ? 0 : *std::ranges::max_element(folds) + 1;
  VectorXd error = full_fit.residual.error;
  for (int fold = 0; fold < count; ++fold) {
    reportProgress(hooks, "readings kept out", static_cast<std::size_t>(fold), static_cast<std::size_t>(count));
    const auto rows = rowsOutside(fold, folds, measurements, full_fit.weights);
    if (rows.empty()) return std::nullopt;
    const auto step = stepTo(rows, full_fit, unknowns);
    if (!step) return std::nullopt;
    moveErrors(fold, folds, full_fit, *step, error);
  }
  return errorSize(measurements, full_fit.weights, error);
}

}  // namespace

std::optional<ErrorSize> crossValidateBySteps(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                              const std::vector<Measurement>& measurements, const Fit& full_fit,
                                              const std::vector<int>& folds, const WorkHooks& hooks) {
  const bool is_judged_whole = std::ranges::all_of(folds, [](int fold) { return fold >= 0; });
  if (!full_fit.weights.shared.empty()) return std::nullopt;  // whitening shared noise mixes rows of different folds
  if (full_fit.weights.points.empty() && full_fit.residual.error.size() == full_fit.weights.rows && is_judged_whole)
    return crossValidateToFirstOrder(unknowns, measurements, full_fit, folds, hooks);
  int fold = 0;
  const auto stepped = [&](const std::vector<Measurement>&) -> std::optional<PlacedArm> {
    const auto step = stepTo(rowsOutside(fold++, folds, measurements, full_fit.weights), full_fit, unknowns);
    return step ? std::optional(applied(start, unknowns, full_fit.solution.x + *step)) : std::nullopt;
  };
  const ErrorSize size = judgeFolds(measurements, folds, stepped, hooks);
  return size.measurements > 0 ? std::optional(size) : std::nullopt;
}

}  // namespace tubeplan::calibration
