#include "calibration/measurement_checks/scales_together.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/measurement_checks/golden_section.hpp"
#include "calibration/measurement_checks/joint_scale.hpp"
#include "calibration/measurement_checks/robust_fit.hpp"

namespace tubeplan::calibration {

namespace {

// Tried ratios of a joint's largest reading to its limit.
constexpr double kSharesOfLimit[] = {0.95, 0.7, 0.5, 0.36};
constexpr double kHalfTurn = 3.2;          // limits that are farther than this from zero are replaced by it [rad]
constexpr double kPastByScale = 0.05;      // largest accepted excess over a limit [rad]
constexpr std::size_t kMostTried = 5000;   // maximum number of combinations that are tried
constexpr std::size_t kMostLookedAt = 20;  // maximum number of measurements in the comparison
// Numbers of combinations that are refined, and that are finally proposed.
constexpr std::size_t kBettered = 16, kProposed = 2;
constexpr int kScaleTurns = 3, kSectionSteps = 8, kFitRepeats = 3;

struct Scales {
  std::vector<double> factors;
  double score = std::numeric_limits<double>::infinity();
};

class ScalesTogether {
 public:
  ScalesTogether(const CheckedMeasurements& checked, const std::vector<int>& joints)
      : checked_(checked), joints_(joints), scaled_(checked, joints, kMostLookedAt) {}

  std::vector<Scales> find() {
    auto found = tried();
    for (const double share : {3., 1.}) {
      for (Scales& scales : found) better(scales, share);
      keepBest(found, share == 1 ? kProposed : kBettered / 4);
    }
    for (Scales& scales : found) fit(scales);
    return found;
  }

 private:
  /// Returns the scales to be tried for a joint, of either sign. With them, the readings stay within the limits and
  /// cover much of the range.
  [[nodiscard]] std::vector<double> worthTrying(int j) const {
    const auto& joint = checked_.start.arm.joint(j);
    const auto [lowest, highest] = mistakes::joint_scale::rangeOf(checked_, j);
    std::vector<double> factors;
    for (const int sign : {1, -1}) {
      const double low = sign > 0 ? lowest : -highest, high = sign > 0 ? highest : -lowest;
      double most = std::numeric_limits<double>::infinity();
      if (high > 0) most = std::min(most, std::min(joint.upper, kHalfTurn) / high);
      if (low < 0) most = std::min(most, std::max(joint.lower, -kHalfTurn) / low);
      for (const double share : kSharesOfLimit)
        if (const double factor = share * most; std::isfinite(factor) && factor * low >= joint.lower - kPastByScale &&
                                                factor * high <= joint.upper + kPastByScale && factor > 0)
          factors.push_back(sign * factor);
    }
    return factors;
  }

  /// Returns the best combinations of the tried factors; empty if there are too many combinations.
  std::vector<Scales> tried() {
    std::vector<Scales> all{{{}, 0}};
    for (const int j : joints_) {
      std::vector<Scales> longer;
      for (const Scales& scales : all)
        for (const double factor : worthTrying(j)) {
          longer.push_back(scales);
          longer.back().factors.push_back(factor);
        }
      if (longer.size() > kMostTried) return {};
      all = std::move(longer);
    }
    for (Scales& scales : all) scales.score = scaled_.score(scales.factors, 3);
    keepBest(all, kBettered);
    return all;
  }

  static void keepBest(std::vector<Scales>& all, std::size_t most) {
    std::ranges::stable_sort(all, {}, &Scales::score);
    if (all.size() > most) all.resize(most);
  }

  /// Improves the scales of one combination joint by joint; the search range is halved after each pass over the joints.
  void better(Scales& scales, double share) {
    scales.score = scaled_.score(scales.factors, share);
    double range = 0.3;  // search range relative to the scale
    for (int turn = 0; turn < kScaleTurns; ++turn, range /= 2)
      for (double& factor : scales.factors) {
        const double before = factor;
        const auto scoreAt = [&](double by) {
          factor = before * by;
          return scaled_.score(scales.factors, share);
        };
        const double by = leastOf(scoreAt, 1 - range, 1 + range, kSectionSteps);
        if (const double score = scoreAt(by); score < scales.score)
          scales.score = score;
        else
          factor = before;
      }
  }

  /// Fits the factors to the arm as drawn, together with the base if it is unknown.
  void fit(Scales& scales) const {
    for (int repeat = 0; repeat < kFitRepeats; ++repeat) {
      auto measurements = checked_.measurements;
      PlacedArm start = checked_.start;
      RobustFitOptions options{{{}, true, checked_.free.priors}};
      for (std::size_t j = 0; j < joints_.size(); ++j) {
        for (auto& measurement : measurements) measurement.q[joints_[j]] *= scales.factors[j];
        const std::string& name = start.arm.joint(joints_[j]).name;
        auto made = deflection::makeEffect(start.arm, "joint-scale", name);
        if (made.status != deflection::EffectStatus::kMade) return;
        start.arm.effects.push_back(std::move(made.effect));
        start.arm.effects.back().values[0] = 0;
        options.free.names.push_back("joint-scale@" + name + ".scale");
        options.free.priors.named[options.free.names.back()] = 0.5;
      }
      const auto found = fitRobustly(start, measurements, options);
      if (!found.ok) return;
      const auto& effects = found.placed.arm.effects;
      for (std::size_t j = 0; j < joints_.size(); ++j)
        scales.factors[j] *= 1 + effects[effects.size() - joints_.size() + j].values[0];
    }
  }

  const CheckedMeasurements& checked_;
  const std::vector<int>& joints_;
  mistakes::joint_scale::ScaledMeasurements scaled_;
};

}  // namespace

std::vector<std::vector<std::string>> likelyScales(const CheckedMeasurements& checked, const std::vector<int>& joints) {
  std::vector<std::vector<std::string>> values;
  for (const Scales& scales : ScalesTogether(checked, joints).find()) {
    if (!std::isfinite(scales.score)) continue;
    values.emplace_back();
    for (std::size_t j = 0; j < joints.size(); ++j)
      values.back().push_back(fmt::format("{}:{:.8g}", checked.start.arm.joint(joints[j]).name, scales.factors[j]));
  }
  return values;
}

}  // namespace tubeplan::calibration
