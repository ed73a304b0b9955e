#include "calibration/estimation/set_aside.hpp"

#include <algorithm>
#include <map>

#include "calibration/estimation/fit.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

namespace {

constexpr std::size_t kFewOutliers = 10;  // at most one measurement in this many may be an outlier

/// Returns, for each unknown point or surface, the number of its touches that are neither held out nor set aside.
std::map<std::string, int> remainingTouches(const std::vector<int>& set_aside,
                                            const std::vector<Measurement>& measurements) {
  std::map<std::string, int> remaining;
  for (std::size_t k = 0; k < measurements.size(); ++k)
    if (!measurements[k].is_held_out && hasUnknownPlace(measurements[k]))
      remaining[placeOf(measurements[k])] +=
          !std::binary_search(set_aside.begin(), set_aside.end(), static_cast<int>(k));
  return remaining;
}

std::vector<int> othersThan(const std::vector<int>& set_aside, std::size_t measurements) {
  std::vector<int> others;
  for (int k = 0; k < static_cast<int>(measurements); ++k)
    if (!std::binary_search(set_aside.begin(), set_aside.end(), k)) others.push_back(k);
  return others;
}

std::vector<int> outliersOf(const Identification& fit) {
  std::vector<int> places;
  for (const auto& outlier : fit.outliers) places.push_back(outlier.measurement);
  return places;
}

/// Returns the measurements set aside that the fit to the others indeed mispredicts; a robust fit may also have flagged
/// measurements that are not outliers. Only measured tip positions are checked; all other measurements are returned.
std::vector<int> missedBy(const Identification& fit, const std::vector<int>& set_aside,
                          const std::vector<Measurement>& measurements, double level) {
  std::vector<int> missed;
  for (const int k : set_aside) {
    const Measurement& measurement = measurements[static_cast<std::size_t>(k)];
    const auto rows = rowsOf(measurement);
    if (!statesPlace(measurement) || rows != 3) {
      missed.push_back(k);
      continue;
    }
    const auto predicted = predictMeasurement(fit.fitted, measurement, {.by_joints = true});
    if (!predicted.ok) {
      missed.push_back(k);
      continue;
    }
    Eigen::MatrixXd covariance = measurementCovariance(fit.fitted.arm, measurement, predicted.by_joints);
    covariance.diagonal().array() += fit.model_error * fit.model_error;
    const Eigen::VectorXd error = predicted.value - *measurement.p_W;
    const double limit = chiSquareQuantile(level / static_cast<double>(measurements.size()), rows);
    if (error.dot(covariance.llt().solve(error)) > limit) missed.push_back(k);
  }
  return missed;
}

/// Returns the outliers, together with touches of unknown points that become uninformative because too few of them
/// remain.
std::vector<int> withOrphans(const std::vector<int>& outliers, const std::vector<Measurement>& measurements) {
  const auto isLeft = [&](std::size_t k) {
    return !measurements[k].is_held_out && !std::binary_search(outliers.begin(), outliers.end(), static_cast<int>(k));
  };
  const auto touches = remainingTouches(outliers, measurements);
  std::vector<int> all = outliers;
  for (std::size_t k = 0; k < measurements.size(); ++k)
    if (isLeft(k) && hasUnknownPlace(measurements[k]) &&
        touches.at(placeOf(measurements[k])) < leastOfPlace(measurements[k]))
      all.push_back(static_cast<int>(k));
  std::ranges::sort(all);
  return all;
}

}  // namespace

std::vector<int> placesFitted(const std::vector<Measurement>& measurements, const std::vector<int>& set_aside) {
  auto places = othersThan(set_aside, measurements.size());
  std::erase_if(places, [&](int k) { return measurements[static_cast<std::size_t>(k)].is_held_out; });
  return places;
}

double countOutliers(const std::vector<int>& set_aside, const std::vector<Measurement>& measurements) {
  const auto remaining = remainingTouches(set_aside, measurements);
  const auto removed_points = std::ranges::count_if(remaining, [](const auto& point) { return point.second == 0; });
  return static_cast<double>(set_aside.size()) - static_cast<double>(removed_points);
}

std::optional<WithoutOutliers> withoutOutliers(const std::vector<Measurement>& measurements,
                                               const Identification& baseline, double level, const BaselineFit& fit) {
  std::optional<WithoutOutliers> found;
  std::vector<int> outliers = outliersOf(baseline);
  if (outliers.empty() && baseline.p_value < kLackOfFit) outliers = outliersOf(fit(measurements, RobustLoss::kHuber));
  while (found ? outliers.size() > found->set_aside.size() : !outliers.empty()) {
    std::ranges::sort(outliers);
    if (outliers.size() > measurements.size() / kFewOutliers) return std::nullopt;
    const std::vector<int> set_aside = withOrphans(outliers, measurements);
    Identification refit = fit(withoutMeasurements(measurements, set_aside), RobustLoss::kNone);
    if (refit.status == IdentificationStatus::kRefused) return found;
    if (!found)
      if (auto missed = missedBy(refit, outliers, measurements, level); missed.size() < outliers.size()) {
        outliers = std::move(missed);
        continue;
      }
    outliers = set_aside;
    const std::vector<int> remaining = othersThan(set_aside, measurements.size());
    for (const int place : outliersOf(refit)) outliers.push_back(remaining.at(static_cast<std::size_t>(place)));
    found = WithoutOutliers{set_aside, std::move(refit)};
  }
  return found;
}

std::vector<int> measurementsToSetAside(const PlacedArm& start, const std::vector<Measurement>& measurements,
                                        const Identification& baseline, const IdentificationOptions& options) {
  const BaselineFit fit = [&](const std::vector<Measurement>& some, RobustLoss loss) {
    IdentificationOptions cheap = options;
    cheap.folds = 0;
    cheap.intervals_by_profile = false;
    cheap.uncertainty.reset();
    cheap.observe = {};
    cheap.loss = loss;
    cheap.may_hold_all = true;
    return identify(start, some, cheap);
  };
  const auto without = withoutOutliers(measurements, baseline, options.outlier_level, fit);
  return without ? without->set_aside : std::vector<int>();
}

}  // namespace tubeplan::calibration
