#include "calibration/measurement_checks/row_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/measurement_checks/robust_fit.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kBlind = 0.01;   // errors below this, relative to the reach, are treated as zero
constexpr double kMostOfRow = 3;  // largest evidence from one row: log of the ratio of its errors
constexpr std::size_t kEndRows = 20;

}  // namespace

std::vector<PlacedArm> likelyPlacings(const CheckedMeasurements& checked) {
  std::vector<PlacedArm> placed{checked.start};
  const auto& bases = checked.start.base_poses;
  if (std::ranges::all_of(bases, &BasePose::is_known)) return placed;
  const auto count = static_cast<std::ptrdiff_t>(std::min(kEndRows, checked.measurements.size()));
  const auto begin = checked.measurements.begin(), end = checked.measurements.end();
  for (const auto& part : {std::vector(begin, begin + count), std::vector(end - count, end)}) {
    RobustFitOptions options;
    options.free.priors = checked.free.priors;
    if (RobustFit fit = fitRobustly(checked.start, part, options); fit.ok) placed.push_back(std::move(fit.placed));
  }
  return placed;
}

double RowErrors::at(std::size_t k) {
  if (!known_[k]) known_[k] = errorOf(k);
  return *known_[k];
}

double RowErrors::errorOf(std::size_t k) {
  const Measurement& measurement = measurements_[k];
  if (!statesPlace(measurement)) return kNotKnown;
  const auto found = predictor_.predict(basePoseAt(placed_, measurement), measurement);
  if (!found.ok || found.value.size() < 3) return kNotKnown;
  return (found.value.head<3>() - *measurement.p_W).norm();
}

RowComparison::RowComparison(RowErrors& as_is, RowErrors& corrected, double reach)
    : as_is_(as_is), corrected_(corrected), blind_(kBlind * reach) {}

double RowComparison::at(std::size_t k) {
  const double ratio = std::log((as_is_.at(k) + blind_) / (corrected_.at(k) + blind_));
  return std::isfinite(ratio) ? std::clamp(ratio, -kMostOfRow, kMostOfRow) : 0;
}

}  // namespace tubeplan::calibration
