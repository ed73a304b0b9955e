#include "calibration/measurement_checks/coordinate_scale.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "calibration/measurement_checks/coordinate_unit.hpp"
#include "calibration/measurement_checks/robust_fit.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/weights.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::calibration::mistakes::coordinate_scale {

namespace {

using Eigen::Index, Eigen::MatrixX4d, Eigen::VectorXd;

constexpr double kLeastChange = 1.1;   // smallest factor, or inverse factor, that no scale error of a machine reaches
constexpr double kSameAsUnit = 0.02;   // difference from a ratio of units, up to which the coordinate's unit is wrong
constexpr Index kFewest = 8;           // smallest number of positions from which a factor is estimated
constexpr std::size_t kMostTips = 80;  // largest number of positions that are used
constexpr double kKeptShare = 0.9;     // fraction of the positions that fit best, to which the second fit is limited
constexpr double kFlat = 0.02;         // spread of the tips in one direction relative to that in another; see slopeOf()
constexpr double kLeastMove = 0.01;    // smallest rms move of the corrected coordinates, as a fraction of the reach
constexpr int kRepeats = 3;            // number of fits of the arm by which a factor is refined

/// Returns the measurements of the first set-up whose coordinates of the tip are in the file, thinned to kMostTips.
std::vector<Measurement> writtenPositions(const CheckedMeasurements& checked) {
  std::vector<Measurement> written;
  const auto& all = checked.measurements;
  const std::size_t stride = 1 + all.size() / kMostTips;
  for (std::size_t k = 0; k < all.size(); k += stride)
    if (statesPlace(all[k]) && coordinates_unit::areWritten(checked, all[k]) && all[k].setup == all.front().setup)
      written.push_back(all[k]);
  return written;
}

/// Returns the predicted positions of the tip [m], each followed by a 1; empty if a shape does not converge.
MatrixX4d tipsOf(const PlacedArm& placed, const std::vector<Measurement>& written) {
  MatrixX4d tips(written.size(), 4);
  for (std::size_t k = 0; k < written.size(); ++k) {
    const auto tool = toolAt(placed, written[k]);
    if (!tool) return {};
    tips.row(static_cast<Index>(k)) << tool->p_W.transpose(), 1;
  }
  return tips;
}

VectorXd coordinateOf(const std::vector<Measurement>& written, Index axis) {
  VectorXd coordinate(written.size());
  for (std::size_t k = 0; k < written.size(); ++k) coordinate[static_cast<Index>(k)] = (*written[k].p_W)[axis];
  return coordinate;
}

/// Returns the length of the slope of a coordinate over the tips, which is 1 for any base if the coordinate is right; 0
/// if it is unknown, because there are few tips, or because they lie in a plane.
double slopeOf(const MatrixX4d& tips, const std::vector<Measurement>& written, Index axis) {
  if (tips.rows() < kFewest) return 0;
  const VectorXd coordinate = coordinateOf(written, axis);
  const Eigen::ColPivHouseholderQR<MatrixX4d> all(tips);
  if (std::abs(all.matrixR()(3, 3)) < kFlat * std::abs(all.matrixR()(1, 1))) return 0;
  const VectorXd off = (coordinate - tips * all.solve(coordinate)).cwiseAbs();
  std::vector<Index> order(static_cast<std::size_t>(off.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](Index k) { return off[k]; });
  order.resize(static_cast<std::size_t>(kKeptShare * static_cast<double>(order.size())));
  const MatrixX4d kept = tips(order, Eigen::all);
  return kept.colPivHouseholderQr().solve(VectorXd(coordinate(order))).head<3>().norm();
}

/// Returns the factor that fits the arm with its free parameters, starting from the factor that fits the arm as drawn.
double refined(double factor, const CheckedMeasurements& checked, std::vector<Measurement> written, Index axis) {
  RobustFitOptions options{checked.free};
  options.free.base = true;  // frees base poses that are not known
  for (Measurement& measurement : written) (*measurement.p_W)[axis] *= factor;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    const RobustFit fit = fitRobustly(checked.start, written, options);
    const double slope = fit.ok ? slopeOf(tipsOf(fit.placed, written), written, axis) : 0;
    if (!(slope > 0)) return factor;
    for (Measurement& measurement : written) (*measurement.p_W)[axis] /= slope;
    factor /= slope;
  }
  return factor;
}

/// Returns true if the factor moves the coordinates farther than the physical effects of a machine move the tip.
bool movesFar(const CheckedMeasurements& checked, const std::vector<Measurement>& written, Index axis, double slope) {
  const VectorXd coordinate = coordinateOf(written, axis);
  const double spread = (coordinate.array() - coordinate.mean()).matrix().norm() / std::sqrt(coordinate.size());
  return std::abs(1 - 1 / slope) * spread > kLeastMove * deflection::reachOf(checked.start.arm);
}

bool isRatioOfUnits(const CheckedMeasurements& checked, double slope) {
  return std::ranges::any_of(checked.units.lengths, [&](const NamedUnit& unit) {
    return std::abs(std::log(slope * unit.factor / checked.units.coordinates.factor)) < kSameAsUnit;
  });
}

std::vector<std::string> valuesOf(const CheckedMeasurements& checked) {
  std::vector<std::string> values;
  const auto written = writtenPositions(checked);
  const MatrixX4d tips = tipsOf(checked.start, written);
  for (Index axis = 0; axis < 3; ++axis) {
    const double slope = slopeOf(tips, written, axis);
    if (!(slope > 0) || std::abs(std::log(slope)) < std::log(kLeastChange) || isRatioOfUnits(checked, slope)) continue;
    if (!movesFar(checked, written, axis, slope)) continue;
    values.push_back(fmt::format("{}:{:.8g}", coordinate_unit::kAxes[static_cast<std::size_t>(axis)],
                                 refined(1 / slope, checked, written, axis)));
  }
  return values;
}

std::optional<Correction> correctionOf(const CheckedMeasurements& checked, const std::string& value) {
  const auto [axis, number] = partedAtColon(value);
  const std::size_t at = coordinate_unit::axisNamed(axis);
  const double factor = tubesheets::parseNumber(number).value_or(0);
  if (at == std::string_view::npos || !(factor > 0)) return std::nullopt;
  Correction correction{"coordinate-scale", value,
                        fmt::format("the column of {} is too {}: multiplied by {:.5g} it is a coordinate in {}", axis,
                                    factor < 1 ? "large" : "small", factor, checked.units.coordinates.name)};
  correction.change = coordinate_unit::multiplied(checked, at, factor);
  correction.numbers_fitted = 1;
  return correction;
}

}  // namespace

MistakeKind kind() {
  return {.name = "coordinate-scale",
          .value = "AXIS:FACTOR",
          .expected = "x, y or z and the factor for its column, such as z:2",
          .values = valuesOf,
          .correction = correctionOf,
          .joins_itself = true};
}

}  // namespace tubeplan::calibration::mistakes::coordinate_scale
