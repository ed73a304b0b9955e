#include "calibration/estimation/size_modes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/prior.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

// Largest number of measurements used in the search. More would rarely resolve a remaining ambiguity.
constexpr std::size_t kMostMeasurements = 400;
// Sizes explain the measurements equally well if their chi-squares (with priors) differ by no more than this.
constexpr double kAsGood = 4;
// A start is fitted if its decrease of chi-square is at least this fraction of the largest decrease.
constexpr double kPromising = 0.5;
constexpr double kSeparateModes = 3;  // modes closer than this many standard deviations are merged
// A measurement distinguishes two modes if its predictions differ by more than this many of its standard deviations.
constexpr double kDecides = 4;
constexpr int kIterations = 20;
constexpr double kExact = 1e-6;  // standard deviation of the tip assumed if no encoder noise is stated [m]
// Step and largest value of the factor by which all sizes are multiplied.
constexpr double kStretch = 0.05, kMostStretch = 3;
// Amplitudes tried along a direction, as fractions of the typical size.
constexpr double kAmplitudes[] = {0.0125, 0.025, 0.05, 0.1, 0.2, 0.4, 0.8};

/// Direction of search: one or two sizes to change from their neutral values, and the weight and sign of each change.
struct Direction {
  std::vector<std::size_t> sizes;  ///< indices of the sizes among the unknowns
  VectorXd signs;
};

/// Search over the sizes of one effect, singly and in pairs, with all other unknowns refitted.
class SizeSearch {
 public:
  explicit SizeSearch(const SizeModesQuestion& question) : question_(question) {
    const std::size_t step =
        std::max<std::size_t>(1, (question_.measurements.size() + kMostMeasurements - 1) / kMostMeasurements);
    for (std::size_t k = 0; k < question_.measurements.size(); k += step)
      measurements_.push_back(question_.measurements[k]);
    if (auto weights = weighMeasurements(question_.placed, measurements_, {}, question_.model_error, question_.stop))
      weights_ = *std::move(weights);
    VectorXd neutral = zerosOf(question_.unknowns);
    for (std::size_t k = 0; k < question_.unknowns.size(); ++k)
      if (isSize(k))
        neutral[static_cast<Index>(k)] = question_.unknowns[k].prior_mean;
      else
        others_.push_back(question_.unknowns[k]);
    bare_ = applied(question_.placed, question_.unknowns, neutral);
  }

  /// Returns all modes found, most probable first.
  [[nodiscard]] std::vector<SizeMode> find() const {
    if (weights_.rows == 0) return {};
    std::vector<SizeMode> modes{asFound()};
    if (!std::isfinite(modes.front().cost)) return {};
    const double none = costOf(bare_, others_, zerosOf(others_));
    for (const Direction& direction : directions()) {
      throwIfStopped(question_.stop);
      const auto unknowns = unknownsOf(direction);
      const VectorXd start = bestAlong(direction, unknowns);
      const double best = std::ranges::min(modes, {}, &SizeMode::cost).cost;
      if (costOf(bare_, unknowns, start) <= best + (1 - kPromising) * std::max(0., none - best))
        keep(minimized(unknowns, start, direction), modes);
    }
    std::ranges::stable_sort(modes, {}, &SizeMode::cost);
    std::erase_if(modes, [&](const SizeMode& mode) { return mode.cost > modes.front().cost + kAsGood; });
    for (SizeMode& mode : modes) findRange(mode);
    return modes;
  }

 private:
  [[nodiscard]] bool isSize(std::size_t k) const {
    return std::ranges::find(question_.sizes, k) != question_.sizes.end();
  }

  /// Returns the unknowns that are not sizes of the effect, then the sizes of the direction with variables that are 0
  /// at their neutral values.
  [[nodiscard]] std::vector<Unknown> unknownsOf(const Direction& direction) const {
    std::vector<Unknown> unknowns = others_;
    for (const std::size_t k : direction.sizes)
      unknowns.push_back(
          rebased(question_.unknowns[k], valueAt(question_.unknowns[k], question_.unknowns[k].prior_mean)));
    return unknowns;
  }

  /// Returns the directions of search: each size alone with either sign, and each pair of sizes of the same quantity
  /// with all combinations of signs.
  [[nodiscard]] std::vector<Direction> directions() const {
    std::vector<Direction> directions;
    for (auto i = question_.sizes.begin(); i != question_.sizes.end(); ++i)
      for (const double sign : {1., -1.}) {
        directions.push_back({{*i}, VectorXd::Constant(1, sign)});
        for (auto j = i + 1; j != question_.sizes.end(); ++j)
          for (const double other : {1., -1.})
            if (question_.unknowns[*i].quantity == question_.unknowns[*j].quantity)
              directions.push_back({{*i, *j}, Eigen::Vector2d(sign, other) / std::sqrt(2.)});
      }
    return directions;
  }

  [[nodiscard]] LeastSquaresProblem problemAt(const PlacedArm& from, const std::vector<Unknown>& unknowns,
                                              const VectorXd& x) const {
    return fitProblem(from, unknowns, measurements_, weights_, x, question_.stop);
  }
  [[nodiscard]] double costOf(const PlacedArm& from, const std::vector<Unknown>& unknowns, const VectorXd& x) const {
    VectorXd r;
    return problemAt(from, unknowns, x).evaluate(x, r, nullptr) ? r.squaredNorm()
                                                                : std::numeric_limits<double>::infinity();
  }

  /// Returns the variables at the amplitude along a direction that gives the smallest cost, with all other unknowns as
  /// in the fit.
  [[nodiscard]] VectorXd bestAlong(const Direction& direction, const std::vector<Unknown>& unknowns) const {
    VectorXd best = zerosOf(unknowns);
    double least = std::numeric_limits<double>::infinity();
    const auto count = static_cast<Index>(direction.sizes.size()), first = best.size() - count;
    for (const double amplitude : kAmplitudes) {
      VectorXd x = zerosOf(unknowns);
      for (Index k = 0; k < count; ++k) {
        const Unknown& size = unknowns[static_cast<std::size_t>(first + k)];
        x[first + k] = std::clamp(amplitude * size.typical * direction.signs[k], size.lower, size.upper);
      }
      if (const double cost = costOf(bare_, unknowns, x); cost < least) least = cost, best = x;
    }
    return best;
  }

  /// Returns the standard deviations of all sizes of the effect, 0 for those not in `sizes`. The variables of `sizes`
  /// must be the last of the problem.
  [[nodiscard]] VectorXd sigmaAt(const LeastSquaresProblem& problem, const VectorXd& x,
                                 const std::vector<std::size_t>& sizes) const {
    VectorXd sigma = VectorXd::Zero(static_cast<Index>(question_.sizes.size())), r;
    MatrixXd jacobian;
    if (!problem.evaluate(x, r, &jacobian)) return sigma;
    const MatrixXd covariance = inverseOfInformation(jacobian.transpose() * jacobian);
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      const auto place = std::ranges::find(question_.sizes, sizes[k]) - question_.sizes.begin();
      const Index row = x.size() - static_cast<Index>(sizes.size()) + static_cast<Index>(k);
      sigma[place] = std::sqrt(std::max(0., covariance(row, row)));
    }
    return sigma;
  }

  [[nodiscard]] VectorXd valuesIn(PlacedArm state) const {
    VectorXd values(static_cast<Index>(question_.sizes.size()));
    for (Index k = 0; k < values.size(); ++k)
      values[k] = deflection::locate(state.arm, question_.unknowns[question_.sizes[static_cast<std::size_t>(k)]].path);
    return values;
  }

  [[nodiscard]] SizeMode asFound() const {
    const VectorXd origin = zerosOf(question_.unknowns);
    SizeMode mode;
    mode.state = question_.placed;
    mode.values = valuesIn(question_.placed);
    mode.sigma = question_.sigma;
    mode.cost = costOf(question_.placed, question_.unknowns, origin);
    mode.is_as_found = true;
    return mode;
  }

  [[nodiscard]] SizeMode minimized(const std::vector<Unknown>& unknowns, const VectorXd& start,
                                   const Direction& direction) const {
    const LeastSquaresOptions solver{1e-6, kIterations, LeastSquaresMethod::kLevenbergMarquardt, question_.stop};
    const auto problem = problemAt(bare_, unknowns, start);
    const auto solution = minimizeOrUnwind(problem, solver);
    SizeMode mode;
    if (solution.status == LeastSquaresStatus::kFailed) return mode;
    mode.state = applied(bare_, unknowns, solution.x);
    mode.values = valuesIn(mode.state);
    mode.sigma = sigmaAt(problem, solution.x, direction.sizes);
    mode.cost = solution.chi2;
    return mode;
  }

  /// Returns the state of a mode with all its sizes multiplied by `by`: 1 changes nothing, 0 makes the effect neutral.
  [[nodiscard]] PlacedArm stretched(const SizeMode& mode, double by) const {
    PlacedArm state = mode.state;
    for (std::size_t k = 0; k < question_.sizes.size(); ++k) {
      const Unknown& size = question_.unknowns[question_.sizes[k]];
      const double none = valueAt(size, size.prior_mean);
      deflection::locate(state.arm, size.path) = none + by * (mode.values[static_cast<Index>(k)] - none);
    }
    return state;
  }

  /// Returns the chi-square of the measurements at a state. A step count contributes only the distance by which its
  /// limits of the centring error are violated, relative to encoder noise.
  [[nodiscard]] double disagreementOf(const PlacedArm& state) const {
    double sum = 0;
    for (std::size_t k = 0; k < measurements_.size(); ++k) {
      const Measurement& measurement = measurements_[k];
      if (hasUnknownPlace(measurement)) continue;
      const Prediction predicted = predictMeasurement(state, measurement, {.by_joints = true});
      if (!predicted.ok) return std::numeric_limits<double>::infinity();
      if (!kindOf(measurement).counts_steps) {
        sum += (weights_.whitener[k] * (predicted.value - kindOf(measurement).measured(measurement))).squaredNorm();
        continue;
      }
      const double variance = encoderCovariance(state.arm, predicted.by_joints).trace();
      const double error = predicted.value.norm();
      const double beyond = std::max({0., measurement.kind_values[1] - error, error - measurement.kind_values[2]});
      if (beyond > 0) sum += beyond * beyond / std::max(variance, kExact * kExact);
    }
    return sum;
  }

  /// Sets the limits of each size by scaling all sizes with a common factor, as far as the measurements remain
  /// explained.
  void findRange(SizeMode& mode) const {
    const double limit = disagreementOf(mode.state) + kAsGood;
    double down = 1, up = 1;
    while (down > kStretch && disagreementOf(stretched(mode, down - kStretch)) <= limit) down -= kStretch;
    while (up < kMostStretch && disagreementOf(stretched(mode, up + kStretch)) <= limit) up += kStretch;
    const VectorXd none = valuesIn(bare_), least = none + down * (mode.values - none),
                   most = none + up * (mode.values - none);
    const VectorXd spread =
        (mode.values.cwiseAbs().array() > 2 * mode.sigma.array()).select(2 * mode.sigma.array(), 0.).matrix();
    mode.lower = least.cwiseMin(most).cwiseMin(mode.values - spread);
    mode.upper = least.cwiseMax(most).cwiseMax(mode.values + spread);
  }

  /// Adds a mode to the list unless the list has a similar one. The similar one is replaced if the new mode's
  /// chi-square is smaller by more than kAsGood.
  static void keep(const SizeMode& mode, std::vector<SizeMode>& modes) {
    if (!std::isfinite(mode.cost)) return;
    for (SizeMode& other : modes) {
      const VectorXd sigma = kSeparateModes * mode.sigma.cwiseMax(other.sigma);
      if (((mode.values - other.values).cwiseAbs().array() > sigma.array()).any()) continue;
      if (mode.cost < other.cost - kAsGood) {
        const bool was_found = other.is_as_found;
        other = mode;
        other.is_as_found = was_found;
      }
      return;
    }
    modes.push_back(mode);
  }

  const SizeModesQuestion& question_;
  PlacedArm bare_;  ///< state of the fit, but with the effect's sizes at their neutral values
  std::vector<Unknown> others_;
  std::vector<Measurement> measurements_;
  MeasurementWeights weights_;
};

/// Returns the kinds of measurement for which a single measurement, at a posture of `measurements`, would distinguish
/// the two states.
std::vector<MeasurementKind> decidingKinds(const PlacedArm& first, const PlacedArm& second,
                                           const std::vector<Measurement>& measurements) {
  std::vector<MeasurementKind> kinds;
  for (const auto& kind : measurementKinds()) {
    const bool needs_more =
        kind.has_direction || kind.is_to_gravity || kind.departure || kind.has_anchor || kind.settle;
    if (needs_more || kind.counts_steps) continue;
    for (std::size_t k = 0; k < measurements.size(); k += std::max<std::size_t>(1, measurements.size() / 20)) {
      Measurement measurement = measurements[k];
      measurement.kind = kind.kind;
      if (kind.names_hole && !measurement.p_W) continue;
      const auto first_tool = toolAt(first, measurement), second_tool = toolAt(second, measurement);
      if (!first_tool || !second_tool) continue;
      // The predicted value of a touch is the same in both states. Instead, as for a measured position, compare the two
      // predicted tips.
      kind.record(*first_tool, 1, MeasuredValue::Zero(6), measurement);
      const double difference =
          kind.is_touch ? (first_tool->p_W - second_tool->p_W).norm()
                        : (predictedValue(measurement, *second_tool) - predictedValue(measurement, *first_tool)).norm();
      if (!(difference > kDecides * measurements[k].sigma)) continue;
      kinds.push_back(kind.kind);
      break;
    }
  }
  return kinds;
}

}  // namespace

std::string decidedByText(const std::vector<MeasurementKind>& kinds) {
  std::vector<std::string> names;
  for (const auto kind : kinds) names.emplace_back(kindOf(kind).name);
  return names.empty() ? "no available kind of reading decides"
                       : fmt::format("one reading of kind {} decides", fmt::join(names, " or "));
}

SizeModes findSizeModes(const SizeModesQuestion& question) {
  SizeModes result;
  if (question.sizes.empty() ||
      std::ranges::none_of(question.measurements, [](const Measurement& m) { return kindOf(m).counts_steps; }))
    return result;
  result.modes = SizeSearch(question).find();
  if (result.modes.size() > 1)
    result.decided_by = decidingKinds(result.modes.front().state, result.modes.back().state, question.measurements);
  return result;
}

}  // namespace tubeplan::calibration
