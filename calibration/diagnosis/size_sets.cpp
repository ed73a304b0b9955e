#include "calibration/diagnosis/size_sets.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/diagnosis/explanation_model.hpp"
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

/// One effect of an explanation with all of its numbers free, beside everything else that the explanation frees.
class SizeSearch {
 public:
  SizeSearch(const FittedBasis& basis, const Explanation& explanation, int effect)
      : model_(modelOf(basis, explanation)), effect_(effect), stop_(basis.stop) {
    std::erase_if(model_.unknowns, [&](const Unknown& unknown) { return unknown.path.effect == effect; });
    others_ = static_cast<Index>(model_.unknowns.size());
    const auto& numbers = deflection::numbersOf(placedEffect());
    for (std::size_t v = 0; v < numbers.size(); ++v)
      if (!numbers[v].is_shape && numbers[v].quantity != deflection::Quantity::kTime)
        model_.unknowns.push_back(numberUnknown(model_.placed.arm, effect, static_cast<int>(v)));
    const std::size_t step = (basis.readings.size() + kMostReadings - 1) / kMostReadings;
    for (std::size_t k = 0; k < basis.readings.size(); k += step) readings_.push_back(basis.readings[k]);
    if (auto weights = weighReadings(model_.placed, readings_, {}, explanation.model_error, stop_))
      weights_ = *std::move(weights);
  }

  [[nodiscard]] bool isAsked() const { return sizes() > 0 && weights_.rows > 0; }

  /// The modes, most probable first; the one found is among them.
  [[nodiscard]] std::vector<Mode> find(const VectorXd& sigma) const {
    const VectorXd origin = VectorXd::Zero(static_cast<Index>(model_.unknowns.size()));
    std::vector<Mode> modes;
    keep(minimized(origin), sigma, modes);
    if (modes.empty()) return modes;
    const double none = costAt(withSizes(origin, neutral()));
    for (const VectorXd& direction : directions()) {
      goOn(stop_);
      const VectorXd start = bestAlong(direction);
      const double best = modes.front().cost;
      if (costAt(start) <= best + (1 - kPromising) * (none - best)) keep(minimized(start), sigma, modes);
    }
    std::stable_sort(modes.begin(), modes.end(), [](const Mode& a, const Mode& b) { return a.cost < b.cost; });
    std::erase_if(modes, [&](const Mode& mode) { return mode.cost > modes.front().cost + kAsGood; });
    return modes;
  }

  /// Values of the effect's numbers there, those that are no sizes as they are.
  [[nodiscard]] std::vector<double> valuesAt(const Mode& mode) const {
    return applied(model_.placed, model_.unknowns, mode.x).arm.effects[static_cast<std::size_t>(effect_)].values;
  }
  [[nodiscard]] PlacedArm placedAt(const Mode& mode) const { return applied(model_.placed, model_.unknowns, mode.x); }

  /// Index of each size among the effect's numbers.
  [[nodiscard]] std::vector<std::size_t> numbersOfSizes() const {
    std::vector<std::size_t> numbers;
    for (Index k = others_; k < others_ + sizes(); ++k)
      numbers.push_back(static_cast<std::size_t>(model_.unknowns[static_cast<std::size_t>(k)].path.value));
    return numbers;
  }
  [[nodiscard]] Index sizes() const { return static_cast<Index>(model_.unknowns.size()) - others_; }

 private:
  [[nodiscard]] const deflection::Effect& placedEffect() const {
    return model_.placed.arm.effects[static_cast<std::size_t>(effect_)];
  }
  [[nodiscard]] const Unknown& size(Index k) const { return model_.unknowns[static_cast<std::size_t>(others_ + k)]; }

  /// Variables of the sizes where the effect does nothing.
  [[nodiscard]] VectorXd neutral() const {
    VectorXd values(sizes());
    for (Index k = 0; k < values.size(); ++k) values[k] = size(k).prior_mean;
    return values;
  }
  [[nodiscard]] VectorXd withSizes(VectorXd x, const VectorXd& values) const {
    x.tail(values.size()) = values;
    return x;
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
    return fitProblem(model_.placed, model_.unknowns, readings_, weights_, x, stop_);
  }
  [[nodiscard]] double costAt(const VectorXd& x) const {
    VectorXd r;
    return problemAt(x).evaluate(x, r, nullptr) ? r.squaredNorm() : std::numeric_limits<double>::infinity();
  }

  /// The best of some amplitudes in a direction, all else as it was found.
  [[nodiscard]] VectorXd bestAlong(const VectorXd& direction) const {
    const VectorXd origin = VectorXd::Zero(static_cast<Index>(model_.unknowns.size()));
    VectorXd best = withSizes(origin, neutral());
    double least = std::numeric_limits<double>::infinity();
    for (const double amplitude : kAmplitudes) {
      VectorXd values = neutral();
      for (Index k = 0; k < values.size(); ++k)
        values[k] = std::clamp(values[k] + amplitude * size(k).typical * direction[k], size(k).lower, size(k).upper);
      const VectorXd x = withSizes(origin, values);
      if (const double cost = costAt(x); cost < least) least = cost, best = x;
    }
    return best;
  }

  [[nodiscard]] Mode minimized(const VectorXd& start) const {
    const LeastSquaresOptions solver{1e-6, kIterations, LeastSquaresMethod::kLevenbergMarquardt, stop_};
    const auto solution = minimizeOrUnwind(problemAt(start), solver);
    if (solution.status == LeastSquaresStatus::kFailed) return {start, std::numeric_limits<double>::infinity()};
    return {solution.x, solution.chi2};
  }

  /// Adds a mode unless one like it is there, whose place it takes where it is better.
  void keep(const Mode& mode, const VectorXd& sigma, std::vector<Mode>& modes) const {
    if (!std::isfinite(mode.cost)) return;
    for (Mode& other : modes) {
      if (((mode.x - other.x).tail(sizes()).cwiseQuotient(sigma)).cwiseAbs().maxCoeff() > kApart) continue;
      if (mode.cost < other.cost) other = mode;
      return;
    }
    modes.push_back(mode);
  }

  ExplanationModel model_;
  int effect_;
  StopQuestion stop_;
  Index others_ = 0;  ///< unknowns before the effect's sizes
  std::vector<Measurement> readings_;
  ReadingWeights weights_;
};

/// What a difference of each size must exceed: by the found numbers of its quantity, the best known one.
VectorXd sigmasOf(const FoundEffect& found, const std::vector<std::size_t>& numbers) {
  VectorXd sigmas(static_cast<Index>(numbers.size()));
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& number : found.numbers)
      if (number.quantity == found.numbers[numbers[k]].quantity && std::isfinite(number.sigma))
        least = std::min(least, number.sigma);
    sigmas[static_cast<Index>(k)] = least;
  }
  return sigmas;
}

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

void takeModes(const SizeSearch& search, const std::vector<Mode>& modes, const VectorXd& sigma,
               const FittedBasis& basis, Explanation& explanation, FoundEffect& found) {
  explanation.fitted = search.placedAt(modes.front());
  found.fitted.values = search.valuesAt(modes.front());
  for (const Mode& mode : modes) found.modes.push_back(search.valuesAt(mode));
  const auto numbers = search.numbersOfSizes();
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    FoundNumber& number = found.numbers[numbers[k]];
    const auto [least, most] = std::ranges::minmax_element(
        found.modes, {}, [&](const std::vector<double>& values) { return values[numbers[k]]; });
    number.value = found.fitted.values[numbers[k]];
    number.lower = (*least)[numbers[k]] - 2 * sigma[static_cast<Index>(k)];
    number.upper = (*most)[numbers[k]] + 2 * sigma[static_cast<Index>(k)];
    number.sigma = (number.upper - number.lower) / 4;
    number.is_beyond_usual = false;
  }
  found.decided_by = decidingKinds(search.placedAt(modes.front()), search.placedAt(modes.back()), basis.readings);
}

}  // namespace

void findSizeSets(const FittedBasis& basis, Explanation& explanation) {
  int added = 0;
  for (const FoundEffect& found : explanation.effects) added += found.frees.empty();
  int effect = static_cast<int>(explanation.fitted.arm.effects.size()) - added;
  for (FoundEffect& found : explanation.effects) {
    if (!found.frees.empty() || found.fitted.formula) {
      effect += found.frees.empty();
      continue;
    }
    const SizeSearch search(basis, explanation, effect++);
    if (!search.isAsked()) continue;
    const VectorXd sigma = sigmasOf(found, search.numbersOfSizes());
    if (!(sigma.minCoeff() > 0) || std::isinf(sigma.minCoeff())) continue;
    const auto modes = search.find(sigma);
    if (modes.size() > 1) takeModes(search, modes, sigma, basis, explanation, found);
  }
}

}  // namespace tubeplan::calibration
