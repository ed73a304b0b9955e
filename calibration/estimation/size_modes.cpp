#include "calibration/estimation/size_modes.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/estimation/fit.hpp"
#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr std::size_t kMostReadings = 400;  // that are asked; what so many leave open more do as well
constexpr double kAsGood = 4;       // of chi-square with priors, within which sizes explain the readings as well
constexpr double kPromising = 0.5;  // of the best fall of chi-square, from which a fit is begun
constexpr double kApart = 3;        // standard deviations, by which other sizes differ
constexpr double kDecides = 4;      // standard deviations of a reading, by which it tells two modes apart
constexpr int kIterations = 20;
constexpr double kAmplitudes[] = {0.0125, 0.025, 0.05, 0.1, 0.2, 0.4, 0.8};  // of the typical size

struct Mode {
  VectorXd x;
  double cost = 0;
};

/// The sizes of one effect, beside everything else that was fitted.
class SizeSearch {
 public:
  explicit SizeSearch(const SizeModesQuestion& question) : asked_(question) {
    const std::size_t step = (asked_.readings.size() + kMostReadings - 1) / kMostReadings;
    for (std::size_t k = 0; k < asked_.readings.size(); k += std::max<std::size_t>(1, step))
      readings_.push_back(asked_.readings[k]);
    if (auto weights = weighReadings(asked_.placed, readings_, {}, asked_.model_error, asked_.stop))
      weights_ = *std::move(weights);
  }

  /// Returns the modes, the most probable first; the one found is among them.
  [[nodiscard]] std::vector<Mode> find() const {
    std::vector<Mode> modes;
    if (weights_.rows == 0) return modes;
    const VectorXd origin = zerosOf(asked_.unknowns);
    keep(minimized(origin), modes);
    if (modes.empty()) return modes;
    const double none = costAt(withSizes(neutral()));
    for (const VectorXd& direction : directions()) {
      goOn(asked_.stop);
      const VectorXd start = bestAlong(direction);
      const double best = modes.front().cost;
      if (costAt(start) <= best + (1 - kPromising) * (none - best)) keep(minimized(start), modes);
    }
    std::stable_sort(modes.begin(), modes.end(), [](const Mode& a, const Mode& b) { return a.cost < b.cost; });
    std::erase_if(modes, [&](const Mode& mode) { return mode.cost > modes.front().cost + kAsGood; });
    return modes;
  }

 private:
  [[nodiscard]] Index sizes() const { return static_cast<Index>(asked_.sizes.size()); }
  [[nodiscard]] const Unknown& size(Index k) const {
    return asked_.unknowns[asked_.sizes[static_cast<std::size_t>(k)]];
  }

  /// Variables of the sizes where the effect does nothing.
  [[nodiscard]] VectorXd neutral() const {
    VectorXd values(sizes());
    for (Index k = 0; k < values.size(); ++k) values[k] = size(k).prior_mean;
    return values;
  }
  [[nodiscard]] VectorXd withSizes(const VectorXd& values) const {
    VectorXd x = zerosOf(asked_.unknowns);
    for (Index k = 0; k < sizes(); ++k) x[static_cast<Index>(asked_.sizes[static_cast<std::size_t>(k)])] = values[k];
    return x;
  }
  [[nodiscard]] VectorXd sizesOf(const VectorXd& x) const {
    VectorXd values(sizes());
    for (Index k = 0; k < sizes(); ++k) values[k] = x[static_cast<Index>(asked_.sizes[static_cast<std::size_t>(k)])];
    return values;
  }

  /// Each size alone, either way, and each two of one quantity in between.
  [[nodiscard]] std::vector<VectorXd> directions() const {
    std::vector<VectorXd> directions;
    for (Index i = 0; i < sizes(); ++i)
      for (const double sign : {1., -1.}) {
        directions.push_back(sign * VectorXd::Unit(sizes(), i));
        for (Index j = i + 1; j < sizes(); ++j)
          for (const double other : {1., -1.})
            if (size(i).quantity == size(j).quantity)
              directions.push_back(
                  (sign * VectorXd::Unit(sizes(), i) + other * VectorXd::Unit(sizes(), j)).normalized());
      }
    return directions;
  }

  [[nodiscard]] LeastSquaresProblem problemAt(const VectorXd& x) const {
    return fitProblem(asked_.placed, asked_.unknowns, readings_, weights_, x, asked_.stop);
  }
  [[nodiscard]] double costAt(const VectorXd& x) const {
    VectorXd r;
    return problemAt(x).evaluate(x, r, nullptr) ? r.squaredNorm() : std::numeric_limits<double>::infinity();
  }

  /// The best of some amplitudes in a direction, all else as it was found.
  [[nodiscard]] VectorXd bestAlong(const VectorXd& direction) const {
    VectorXd best = withSizes(neutral());
    double least = std::numeric_limits<double>::infinity();
    for (const double amplitude : kAmplitudes) {
      VectorXd values = neutral();
      for (Index k = 0; k < values.size(); ++k)
        values[k] = std::clamp(values[k] + amplitude * size(k).typical * direction[k], size(k).lower, size(k).upper);
      const VectorXd x = withSizes(values);
      if (const double cost = costAt(x); cost < least) least = cost, best = x;
    }
    return best;
  }

  [[nodiscard]] Mode minimized(const VectorXd& start) const {
    const LeastSquaresOptions solver{1e-6, kIterations, LeastSquaresMethod::kLevenbergMarquardt, asked_.stop};
    const auto solution = minimizeOrUnwind(problemAt(start), solver);
    if (solution.status == LeastSquaresStatus::kFailed) return {start, std::numeric_limits<double>::infinity()};
    return {solution.x, solution.chi2};
  }

  /// Adds a mode unless one like it is there, whose place it takes where it is better.
  void keep(const Mode& mode, std::vector<Mode>& modes) const {
    if (!std::isfinite(mode.cost)) return;
    for (Mode& other : modes) {
      if (sizesOf(mode.x - other.x).cwiseQuotient(asked_.sigma).cwiseAbs().maxCoeff() > kApart) continue;
      if (mode.cost < other.cost) other = mode;
      return;
    }
    modes.push_back(mode);
  }

  const SizeModesQuestion& asked_;
  std::vector<Measurement> readings_;
  ReadingWeights weights_;
};

/// Kinds of which a single reading would tell the two states apart, made where the readings were.
std::vector<MeasurementKind> decidingKinds(const PlacedArm& one, const PlacedArm& other,
                                           const std::vector<Measurement>& readings) {
  std::vector<MeasurementKind> kinds;
  for (const auto& kind : measurementKinds()) {
    const bool needs_more = kind.has_direction || kind.is_to_gravity || kind.is_displacement || kind.has_anchor;
    if (needs_more || kind.counts_steps) continue;
    for (std::size_t k = 0; k < readings.size(); k += std::max<std::size_t>(1, readings.size() / 20)) {
      Measurement asked = readings[k];
      asked.kind = kind.kind;
      if (kind.names_hole && !asked.p_W) continue;
      const auto& X_one = one.base_poses[static_cast<std::size_t>(basePoseOf(one, asked))].X_WB;
      const auto& X_other = other.base_poses[static_cast<std::size_t>(basePoseOf(other, asked))].X_WB;
      const auto here = toolAt(one.arm, X_one, asked), there = toolAt(other.arm, X_other, asked);
      if (!here || !there) continue;
      // A touch states its hole, and the joints follow: the tips differ by as much as the place measured would.
      kind.record(*here, 1, MeasuredValue::Zero(6), asked);
      const double apart = kind.is_touch ? (here->p_W - there->p_W).norm()
                                         : (predictedValue(asked, *there) - predictedValue(asked, *here)).norm();
      if (!(apart > kDecides * readings[k].sigma)) continue;
      kinds.push_back(kind.kind);
      break;
    }
  }
  return kinds;
}

}  // namespace

SizeModes findSizeModes(const SizeModesQuestion& question) {
  SizeModes result;
  if (question.sizes.empty() || !(question.sigma.minCoeff() > 0) || !question.sigma.allFinite()) return result;
  for (const Mode& mode : SizeSearch(question).find())
    result.states.push_back(applied(question.placed, question.unknowns, mode.x));
  if (result.states.size() > 1)
    result.decided_by = decidingKinds(result.states.front(), result.states.back(), question.readings);
  return result;
}

}  // namespace tubeplan::calibration
