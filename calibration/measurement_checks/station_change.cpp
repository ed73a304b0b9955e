#include "calibration/measurement_checks/station_change.hpp"

#include <Eigen/SVD>
#include <cmath>

#include "calibration/measurement_checks/quick_alignment.hpp"
#include "calibration/measurement_checks/step_scan.hpp"
#include "deflection/weights.hpp"

namespace tubeplan::calibration {

using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

constexpr std::size_t kFewestOfStation = 6;  // smallest number of positions before and after a change of station
constexpr double kBlindOfStation = 5e-4;     // errors of the rigid drawing below this, relative to the reach, are noise

/// Sums over pairs of a predicted tip and a measured position [m], from which the error of their best rigid alignment
/// follows (Arun, Huang and Blostein 1987).
struct PairSums {
  double count = 0, squares = 0;
  Vector3d tip = Vector3d::Zero(), place = Vector3d::Zero();
  Matrix3d product = Matrix3d::Zero();

  void add(const Vector3d& a, const Vector3d& b) {
    count += 1, squares += a.squaredNorm() + b.squaredNorm();
    tip += a, place += b, product += a * b.transpose();
  }

  [[nodiscard]] PairSums without(const PairSums& part) const {
    return {count - part.count, squares - part.squares, tip - part.tip, place - part.place, product - part.product};
  }

  /// Returns the sum of the squared distances after the best alignment [m^2].
  [[nodiscard]] double error() const {
    const Matrix3d H = product - tip * place.transpose() / count;
    const Vector3d s = H.jacobiSvd().singularValues();
    const double traced = s[0] + s[1] + (H.determinant() < 0 ? -s[2] : s[2]);
    return squares - (tip.squaredNorm() + place.squaredNorm()) / count - 2 * traced;
  }
};

}  // namespace

std::optional<std::size_t> stationChange(const PlacedArm& drawing, const std::vector<Measurement>& measurements,
                                         const std::string& setup) {
  const double reach = deflection::reachOf(drawing.arm);
  const auto tips = QuickAlignment(drawing, reach).tips(measurements);
  std::vector<std::size_t> members;
  std::vector<PairSums> until{{}};
  Vector3d origin = Vector3d::Zero();
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    if (measurements[k].setup != setup || !tips[k].allFinite()) continue;
    if (members.empty()) origin = *measurements[k].p_W;  // keeps the sums small for positions far from the origin
    members.push_back(k);
    until.push_back(until.back());
    until.back().add(tips[k], *measurements[k].p_W - origin);
  }
  if (members.size() < 2 * kFewestOfStation) return std::nullopt;
  const auto rows = 3 * static_cast<double>(members.size());
  const double blind = std::pow(kBlindOfStation * reach, 2);
  const auto cost = [&](double squares) { return rows / 2 * std::log(std::max(blind, squares / rows)); };
  double least = cost(until.back().error()) - priceOfStep(6, measurements);
  std::optional<std::size_t> best;
  for (std::size_t m = kFewestOfStation; m + kFewestOfStation <= members.size(); ++m)
    if (const double found = cost(until[m].error() + until.back().without(until[m]).error()); found < least)
      least = found, best = members[m];
  return best;
}

}  // namespace tubeplan::calibration
