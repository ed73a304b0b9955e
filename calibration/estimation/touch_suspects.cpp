#include "calibration/estimation/touch_suspects.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibration/estimation/fit.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kFarBetter = 0.25;  // another hole is proposed only if chi-square falls below this fraction
// Smallest number of touches in which an outlier touch is searched for, so that three others remain.
constexpr std::size_t kLeastOthers = 4;
constexpr double kFirstStep = 2e-3;        // first step of the search for the correction of a joint reading [rad or m]
constexpr double kMostMisread = 0.2;       // largest correction of a joint reading that is considered [rad or m]
constexpr std::size_t kMostSuspected = 3;  // largest number of suspect joint readings reported

TouchFit fitOf(const TouchesToExplain& to_explain, const std::vector<Measurement>& touches, double model_error) {
  return fitTouches(to_explain.arm, to_explain.numbers, touches, to_explain.X_WB,
                    {model_error, false, to_explain.options.method});
}

double rmsOf(const Eigen::Matrix3Xd& error_W) {
  return error_W.norm() / std::sqrt(static_cast<double>(error_W.cols()));
}

/// Fits the touches with a correction applied to one joint reading of one touch.
class CorrectedMeasurement {
 public:
  CorrectedMeasurement(const TouchesToExplain& to_explain, std::size_t touch, Eigen::Index joint)
      : to_explain_(to_explain), touches_(to_explain.touches), touch_(touch), joint_(joint) {}

  /// Returns the chi-square of a fit with `added` added to the joint reading; infinite if the fit does not converge.
  double chi2At(double added) {
    touches_[touch_].q[joint_] = to_explain_.touches[touch_].q[joint_] + added;
    const TouchFit fit = fitOf(to_explain_, touches_, to_explain_.options.model_error);
    return fit.status == LeastSquaresStatus::kConverged ? fit.chi2 : std::numeric_limits<double>::infinity();
  }

  /// Returns the correction with the smallest chi-square, found by repeated parabolic interpolation with decreasing
  /// steps.
  double best() {
    constexpr int kRounds = 4;
    double at = 0, step = kFirstStep;
    for (int round = 0; round < kRounds; ++round, step /= 4) {
      const double below = chi2At(at - step), middle = chi2At(at), above = chi2At(at + step);
      const double curvature = below + above - 2 * middle;
      if (!(curvature > 0)) break;
      at = std::clamp(at + step * (below - above) / (2 * curvature), -kMostMisread, kMostMisread);
    }
    return at;
  }

 private:
  const TouchesToExplain& to_explain_;
  std::vector<Measurement> touches_;
  std::size_t touch_;
  Eigen::Index joint_;
};

}  // namespace

std::vector<std::string> findMistakenHoles(const TouchesToExplain& to_explain, double chi2) {
  std::vector<std::pair<double, std::string>> found;
  const auto& touches = to_explain.touches;
  for (std::size_t k = 0; to_explain.options.neighbours && k < touches.size(); ++k)
    for (const auto& neighbour : to_explain.options.neighbours(touches[k])) {
      std::vector<Measurement> supposed = touches;
      supposed[k].p_W = neighbour.p_WH;
      const TouchFit fit = fitOf(to_explain, supposed, to_explain.options.model_sigma);
      if (fit.p_value > kLackOfFit && fit.chi2 < chi2 * kFarBetter)
        found.emplace_back(fit.chi2,
                           "touch " + touches[k].id + " named " + touches[k].point + " fits hole " + neighbour.name);
    }
  std::ranges::sort(found);
  std::vector<std::string> names;
  for (auto& [fit, name] : found) names.push_back(name);
  return names;
}

OutlierTouch findOutlierTouch(const TouchesToExplain& to_explain) {
  if (to_explain.touches.size() < kLeastOthers) return {};
  std::vector<OutlierTouch> found;
  for (int k = 0; k < static_cast<int>(to_explain.touches.size()); ++k) {
    const auto others = withoutMeasurements(to_explain.touches, {k});
    if (!findTouchProblem(others, to_explain.options).empty()) continue;
    const TouchFit fit = fitOf(to_explain, others, to_explain.options.model_error);
    if (fit.p_value >= kLackOfFit) found.push_back({k, rmsOf(fit.error_W)});
  }
  return found.size() == 1 ? found.front() : OutlierTouch{};
}

std::vector<SuspectMeasurement> findSuspectMeasurements(const TouchesToExplain& to_explain) {
  std::vector<SuspectMeasurement> found;
  const int freedom = 3 * static_cast<int>(to_explain.touches.size()) - 7;
  for (std::size_t k = 0; k < to_explain.touches.size(); ++k)
    for (Eigen::Index j = 0; j < to_explain.arm.jointCount(); ++j) {
      CorrectedMeasurement measurement(to_explain, k, j);
      const double added = measurement.best();
      const double p_value = chiSquareTail(measurement.chi2At(added), freedom);
      if (p_value >= kLackOfFit) found.push_back({to_explain.touches[k].id, j, -added, p_value});
    }
  std::ranges::stable_sort(found, std::greater{}, &SuspectMeasurement::p_value);
  if (found.size() > kMostSuspected) found.resize(kMostSuspected);
  return found;
}

}  // namespace tubeplan::calibration
