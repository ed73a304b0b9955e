#include "calibration/measurement_checks/coordinate_scale.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "calibration/measurement_checks/coordinate_unit.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::calibration::mistakes::coordinate_scale {

namespace {

using Eigen::Index, Eigen::MatrixX4d, Eigen::VectorXd;

constexpr double kLeastChange = 1.1;   // smallest factor, or inverse factor, that no scale error of a machine reaches
constexpr double kSameAsUnit = 0.02;   // difference from a ratio of units, up to which the coordinate's unit is wrong
constexpr std::size_t kFewest = 8;     // smallest number of positions from which a factor is estimated
constexpr std::size_t kMostTips = 80;  // largest number of positions that are used
constexpr double kKeptShare = 0.9;     // fraction of the positions that fit best, to which the second fit is limited
constexpr double kFlat = 0.02;         // spread of the tips in one direction relative to that in another; see slopeOf()

/// Written positions of the tip [m], and the positions of the tip as drawn, in the frame of the base [m].
struct WrittenTips {
  std::vector<Eigen::Vector3d> p_W, p_B;
};

WrittenTips tipsOf(const CheckedMeasurements& checked) {
  WrittenTips tips;
  const auto& all = checked.measurements;
  const std::size_t stride = 1 + all.size() / kMostTips;
  for (std::size_t k = 0; k < all.size(); k += stride) {
    if (!statesPlace(all[k]) || !coordinates_unit::areWritten(checked, all[k]) || all[k].setup != all.front().setup)
      continue;
    const auto& X_WB = basePoseAt(checked.start, all[k]);
    if (const auto tool = toolAt(checked.start.arm, X_WB, all[k])) {
      tips.p_W.push_back(*all[k].p_W);
      tips.p_B.push_back(X_WB.inverse() * tool->p_W);
    }
  }
  return tips;
}

/// Returns the length of the slope of a coordinate over the tips, which is 1 for any base if the coordinate is right; 0
/// if the tips lie in a plane, and the slope across it is unknown.
double slopeOf(const MatrixX4d& tips, const VectorXd& coordinate) {
  const Eigen::ColPivHouseholderQR<MatrixX4d> all(tips);
  if (std::abs(all.matrixR()(3, 3)) < kFlat * std::abs(all.matrixR()(1, 1))) return 0;
  const VectorXd off = (coordinate - tips * all.solve(coordinate)).cwiseAbs();
  std::vector<Index> order(static_cast<std::size_t>(off.size()));
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<Index>(k);
  std::ranges::stable_sort(order, {}, [&](Index k) { return off[k]; });
  order.resize(static_cast<std::size_t>(kKeptShare * static_cast<double>(order.size())));
  const MatrixX4d kept = tips(order, Eigen::all);
  return kept.colPivHouseholderQr().solve(VectorXd(coordinate(order))).head<3>().norm();
}

std::vector<std::string> valuesOf(const CheckedMeasurements& checked) {
  std::vector<std::string> values;
  const auto [p_W, p_B] = tipsOf(checked);
  if (p_W.size() < kFewest) return values;
  MatrixX4d tips(p_B.size(), 4);
  for (std::size_t k = 0; k < p_B.size(); ++k) tips.row(static_cast<Index>(k)) << p_B[k].transpose(), 1;
  for (Index axis = 0; axis < 3; ++axis) {
    VectorXd coordinate(p_W.size());
    for (std::size_t k = 0; k < p_W.size(); ++k) coordinate[static_cast<Index>(k)] = p_W[k][axis];
    const double slope = slopeOf(tips, coordinate);
    if (!(slope > 0) || std::abs(std::log(slope)) < std::log(kLeastChange)) continue;
    const bool is_unit = std::ranges::any_of(checked.units.lengths, [&](const NamedUnit& unit) {
      return std::abs(std::log(slope * unit.factor / checked.units.coordinates.factor)) < kSameAsUnit;
    });
    if (!is_unit)
      values.push_back(fmt::format("{}:{:.5g}", coordinate_unit::kAxes[static_cast<std::size_t>(axis)], 1 / slope));
  }
  return values;
}

std::optional<Correction> correctionOf(const CheckedMeasurements& checked, const std::string& value) {
  const auto [axis, number] = partedAtColon(value);
  const auto at = axis.size() == 1 ? coordinate_unit::kAxes.find(axis.front()) : std::string_view::npos;
  const double factor = tubesheets::parseNumber(number).value_or(0);
  if (at == std::string_view::npos || !(factor > 0)) return std::nullopt;
  Correction correction{"coordinate-scale", value,
                        fmt::format("the column of {} is too {}: multiplied by {:.5g} it is a coordinate in {}", axis,
                                    factor < 1 ? "large" : "small", factor, checked.units.coordinates.name)};
  correction.change = toEach([checked = &checked, at, factor](Measurement& measurement) {
    if (coordinates_unit::areWritten(*checked, measurement)) (*measurement.p_W)[static_cast<Index>(at)] *= factor;
  });
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
