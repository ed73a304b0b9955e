#include "calibration/estimation/shared_noise.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// Set-up and joint readings of a measurement. Measurements at the same station share their encoder errors.
using Station = std::pair<std::string, std::vector<double>>;

Station stationOf(const std::string& setup, const Measurement& measurement) {
  std::vector<double> joints(measurement.q.begin(), measurement.q.end());
  joints.insert(joints.end(), measurement.side_q.begin(), measurement.side_q.end());
  return {setup, std::move(joints)};
}

/// A measurement at a station, and the first of the columns in its matrix `by_joints` that belong to this station.
struct Share {
  int measurement = 0;
  Index first = 0;
};

/// Returns the indices of the rows of these measurements; `first_row_of` gives the index of each measurement's first
/// row.
template <class FirstRow>
std::vector<Index> rowsOfThese(const MeasurementWeights& weights, const std::vector<int>& measurements,
                               const FirstRow& first_row_of) {
  std::vector<Index> rows;
  for (const int k : measurements)
    for (Index row = 0; row < weights.whitener[static_cast<std::size_t>(k)].rows(); ++row)
      rows.push_back(first_row_of(k) + row);
  return rows;
}

std::vector<Index> rowsOfThese(const MeasurementWeights& weights, const std::vector<int>& measurements) {
  return rowsOfThese(weights, measurements, [&](int k) { return weights.first_row[static_cast<std::size_t>(k)]; });
}

void removeSharedPart(const SharedNoise& shared, const std::vector<Index>& rows, Eigen::Ref<MatrixXd> columns) {
  const MatrixXd own = columns(rows, Eigen::all);
  columns(rows, Eigen::all) = own - shared.Q * (shared.shrink.asDiagonal() * (shared.Q.transpose() * own));
}

/// Returns true if the noise shared by these measurements can be modelled. Each unknown point is eliminated separately,
/// so its touches may share noise only with one another.
bool canShare(const std::vector<Share>& shares, const std::vector<Measurement>& measurements) {
  const auto at = [&](const Share& share) -> const Measurement& {
    return measurements[static_cast<std::size_t>(share.measurement)];
  };
  const bool is_blind = hasUnknownPlace(at(shares.front()));
  return std::ranges::all_of(shares, [&](const Share& share) {
    return hasUnknownPlace(at(share)) == is_blind && (!is_blind || placeOf(at(share)) == placeOf(at(shares.front())));
  });
}

/// For each station, returns true if its shared noise can be computed at an acceptable cost. Long chains of
/// displacements connect many stations, and the matrices Q would then have the rows of all their measurements.
std::vector<bool> areAffordable(const std::vector<const std::vector<Share>*>& stations,
                                const std::vector<Measurement>& measurements, Index joints) {
  constexpr double kMostNumbers = 5e6;  // largest total number of entries in the matrices Q of connected stations
  std::vector<int> leader(measurements.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto leaderOf = [&](int k) {
    while (leader[static_cast<std::size_t>(k)] != k)
      k = leader[static_cast<std::size_t>(k)] = leader[static_cast<std::size_t>(leader[static_cast<std::size_t>(k)])];
    return k;
  };
  for (const auto* shares : stations)
    for (const Share& share : *shares)
      leader[static_cast<std::size_t>(leaderOf(share.measurement))] = leaderOf(shares->front().measurement);
  std::map<int, double> rows, stations_of;
  for (std::size_t k = 0; k < measurements.size(); ++k) rows[leaderOf(static_cast<int>(k))] += rowsOf(measurements[k]);
  for (const auto* shares : stations) stations_of[leaderOf(shares->front().measurement)] += 1;
  std::vector<bool> affordable;
  for (const auto* shares : stations) {
    const int group = leaderOf(shares->front().measurement);
    affordable.push_back(rows[group] * stations_of[group] * static_cast<double>(joints) <= kMostNumbers);
  }
  return affordable;
}

SharedNoise sharedBy(const std::vector<Share>& shares, const VectorXd& sigmas, std::vector<MatrixXd>& by_joints) {
  SharedNoise shared;
  for (const auto& [measurement, first] : shares) {
    auto columns = by_joints[static_cast<std::size_t>(measurement)].middleCols(first, sigmas.size());
    const MatrixXd slopes = columns * sigmas.asDiagonal();
    columns.setZero();
    // A displacement that ends at its reference posture is listed twice in succession, so its derivatives are summed.
    if (!shared.measurements.empty() && shared.measurements.back() == measurement) {
      shared.slopes.back() += slopes;
      continue;
    }
    shared.measurements.push_back(measurement);
    shared.slopes.push_back(slopes);
  }
  return shared;
}

}  // namespace

VectorXd encoderSigmas(const deflection::Arm& arm) {
  VectorXd sigmas(arm.jointCount());
  Index k = 0;
  for (const auto& joint : arm.joints()) sigmas[k++] = joint.encoder_sigma;
  return sigmas;
}

std::pair<std::map<int, Index>, Index> stackedRows(const MeasurementWeights& weights,
                                                   const std::vector<int>& measurements) {
  std::map<int, Index> first_row;
  Index rows = 0;
  for (const int k : measurements) {
    first_row[k] = rows;
    rows += weights.whitener[static_cast<std::size_t>(k)].rows();
  }
  return {std::move(first_row), rows};
}

std::vector<SharedNoise> separateSharedNoise(const deflection::Arm& arm, const std::vector<Measurement>& measurements,
                                             std::vector<MatrixXd>& by_joints) {
  const VectorXd sigmas = encoderSigmas(arm);
  if (sigmas.isZero(0)) return {};
  std::map<Station, std::vector<Share>> stations;
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    stations[stationOf(measurements[k].setup, measurements[k])].push_back({static_cast<int>(k), 0});
    if (const Measurement* from = referenceOf(measurements[k]))
      stations[stationOf(measurements[k].setup, *from)].push_back({static_cast<int>(k), sigmas.size()});
  }
  std::vector<const std::vector<Share>*> common;
  for (const auto& [station, shares] : stations)
    if (shares.size() > 1 && canShare(shares, measurements)) common.push_back(&shares);
  const std::vector<bool> is_affordable = areAffordable(common, measurements, sigmas.size());
  std::vector<SharedNoise> all;
  for (std::size_t s = 0; s < common.size(); ++s)
    if (is_affordable[s]) all.push_back(sharedBy(*common[s], sigmas, by_joints));
  std::ranges::stable_sort(all,
                           [](const auto& a, const auto& b) { return a.measurements.size() < b.measurements.size(); });
  return all;
}

namespace {

/// Earlier groups of shared noise that affect certain measurements, in order, and all measurements that these groups
/// mix.
struct Reach {
  std::vector<std::size_t> before;
  std::vector<int> mixed;
};

Reach reachOf(const std::vector<SharedNoise>& shared, const std::vector<int>& measurements,
              const std::vector<std::vector<std::size_t>>& placed) {
  Reach reach;
  std::set<int> mixed(measurements.begin(), measurements.end());
  std::set<std::size_t> open;
  for (const int k : measurements)
    open.insert(placed[static_cast<std::size_t>(k)].begin(), placed[static_cast<std::size_t>(k)].end());
  while (!open.empty()) {
    const std::size_t next = *open.begin();
    open.erase(open.begin());
    reach.before.push_back(next);
    for (const int k : shared[next].mixed)
      // The rows of U of this measurement are zero before group `next`, so only later groups matter.
      if (mixed.insert(k).second)
        for (const std::size_t other : placed[static_cast<std::size_t>(k)])
          if (other > next) open.insert(other);
  }
  reach.mixed.assign(mixed.begin(), mixed.end());
  return reach;
}

}  // namespace

void placeSharedNoise(MeasurementWeights& weights) {
  constexpr double kSeen = 1e-9;  // eigenvalues of U U^T below this are negligible compared with the unit variance
  // For each measurement, indices of the groups already placed that mix it.
  std::vector<std::vector<std::size_t>> placed(weights.whitener.size());
  for (std::size_t s = 0; s < weights.shared.size(); ++s) {
    SharedNoise& shared = weights.shared[s];
    const Reach reach = reachOf(weights.shared, shared.measurements, placed);
    shared.mixed = reach.mixed;
    const auto [first_row, rows] = stackedRows(weights, shared.mixed);
    const auto firstOf = [&](int k) { return first_row.at(k); };
    MatrixXd U = MatrixXd::Zero(rows, shared.slopes.front().cols());
    for (std::size_t i = 0; i < shared.measurements.size(); ++i) {
      const MatrixXd& whitener = weights.whitener[static_cast<std::size_t>(shared.measurements[i])];
      U.middleRows(firstOf(shared.measurements[i]), whitener.rows()) = whitener * shared.slopes[i];
    }
    for (const std::size_t other : reach.before)
      removeSharedPart(weights.shared[other], rowsOfThese(weights, weights.shared[other].mixed, firstOf), U);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(U.transpose() * U);
    const Index count = (gram.eigenvalues().array() > kSeen).count();
    const VectorXd sizes = gram.eigenvalues().tail(count);
    shared.Q = U * gram.eigenvectors().rightCols(count) * sizes.cwiseSqrt().cwiseInverse().asDiagonal();
    shared.shrink = (1 - (1 + sizes.array()).rsqrt()).matrix();
    for (const int k : shared.mixed) placed[static_cast<std::size_t>(k)].push_back(s);
  }
}

void decorrelate(const MeasurementWeights& weights, Eigen::Ref<MatrixXd> columns) {
  for (const auto& shared : weights.shared) removeSharedPart(shared, rowsOfThese(weights, shared.mixed), columns);
}

void decorrelateWithin(const MeasurementWeights& weights, const std::vector<int>& measurements,
                       Eigen::Ref<MatrixXd> rows) {
  if (weights.shared.empty()) return;
  const auto first_row = stackedRows(weights, measurements).first;
  for (const auto& shared : weights.shared)
    if (std::ranges::all_of(shared.mixed, [&](int k) { return first_row.contains(k); }))
      removeSharedPart(shared, rowsOfThese(weights, shared.mixed, [&](int k) { return first_row.at(k); }), rows);
}

}  // namespace tubeplan::calibration
