#include "calibration/watch/watched_rows.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>

#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kCertain = 1e-9;         // eigenvalue, relative to unit variances, below which a direction is certain
constexpr double kToleranceError = 0.03;  // standard deviation of a step's tolerance, as a fraction of the tolerance

/// Returns the unknowns of base and parameters, whose variables are all 0 at the watched arm.
std::vector<Unknown> watchedUnknowns(const WatchedArm& watched, PlacedArm& placed) {
  FreeChoice base_alone{{}, true, {}};
  std::vector<Unknown> unknowns = chooseUnknowns(placed, base_alone).list;
  for (const Unknown& number : watched.uncertainty.numbers)
    unknowns.push_back(rebased(number, deflection::locate(placed.arm, number.path)));
  return unknowns;
}

/// Returns a matrix L with L L^T = P, with one column for each direction that is uncertain at all.
MatrixXd uncertainDirections(const MatrixXd& P) {
  const VectorXd scale = P.diagonal().cwiseMax(0).cwiseSqrt();
  const VectorXd inverse = (scale.array() > 0).select(scale.cwiseInverse(), VectorXd::Zero(scale.size()));
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(inverse.asDiagonal() * P * inverse.asDiagonal());
  const Index first = (axes.eigenvalues().array() < kCertain).count();
  const Index count = P.rows() - first;
  return scale.asDiagonal() * axes.eigenvectors().rightCols(count) *
         axes.eigenvalues().tail(count).cwiseSqrt().asDiagonal();
}

/// Turns every count of steps into a measurement of both components of the offset, whose noise is that of the encoders
/// and of the tolerances alone.
std::vector<Measurement> withOffsets(const std::vector<Measurement>& measurements) {
  std::vector<Measurement> offsets = measurements;
  for (Measurement& measurement : offsets) {
    if (!kindOf(measurement).counts_steps) continue;
    const double tolerance = measurement.own[1] > 0 ? measurement.own[1] : measurement.own[2];
    measurement.own[1] = 0;
    measurement.own[2] = tolerance;
    measurement.sigma = kToleranceError * tolerance;
  }
  return offsets;
}

/// Whitens each measurement by its own covariance, and a count by the mean variance of its offset. Encoder noise that
/// measurements at the same joint values share is then counted as if it were independent, because a watch must not mix
/// a measurement with later ones.
void whitenApart(const std::vector<Measurement>& measurements, MeasurementWeights& weights,
                 std::vector<double>& scale) {
  weights.shared.clear();
  scale.assign(measurements.size(), 0);
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    MatrixXd covariance = weights.covariance(k);
    const Index rows = covariance.rows();
    if (kindOf(measurements[k]).counts_steps) {
      scale[k] = std::sqrt(covariance.trace() / static_cast<double>(rows));
      weights.whitener[k] = MatrixXd::Identity(rows, rows) / scale[k];
    } else {
      weights.whitener[k] = covariance.llt().matrixL().solve(MatrixXd::Identity(rows, rows));
    }
  }
}

void addRings(const std::vector<Measurement>& measurements, WatchedRows& rows) {
  std::set<double> tolerances;
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    if (!kindOf(measurements[k]).counts_steps) {
      rows.ring.emplace_back();
      continue;
    }
    const double lower = std::max(0., measurements[k].own[1]), upper = measurements[k].own[2];
    rows.ring.push_back(CountedRing{lower / rows.scale[k], upper / rows.scale[k]});
    if (lower > 0) tolerances.insert(lower);
    if (std::isfinite(upper)) tolerances.insert(upper);
  }
  rows.tolerances.assign(tolerances.begin(), tolerances.end());
}

}  // namespace

RowsAndCandidates watchedRows(const WatchedArm& watched, const std::vector<Measurement>& measurements,
                              const StopQuestion& stop) {
  RowsAndCandidates result;
  WatchedRows& rows = result.rows;
  if (measurements.empty()) {
    rows.reason = "there are no readings";
    return result;
  }
  if (std::ranges::any_of(measurements, [&](const auto& m) { return m.setup != measurements.front().setup; })) {
    rows.reason = "the readings are of several set-ups, but a watch is about one";
    return result;
  }
  PlacedArm placed{watched.arm, {{measurements.front().setup, watched.X_WB, false}}};
  const std::vector<Unknown> unknowns = watchedUnknowns(watched, placed);
  const std::vector<Measurement> offsets = withOffsets(measurements);
  rows.reason = "the model cannot be evaluated at the readings";
  auto weights = weighMeasurements(placed, offsets, {}, watched.model_error, stop);
  if (!weights) return result;
  if (!weights->points.empty()) {
    rows.reason = "readings of points or surfaces of unknown place cannot be watched one by one";
    return result;
  }
  whitenApart(measurements, *weights, rows.scale);
  const auto residual = whitenedResidual(placed, unknowns, offsets, *weights, zerosOf(unknowns), true, stop);
  if (!residual.ok) return result;
  result.candidates = candidateChanges(placed, offsets, *weights, residual.jacobian.leftCols<6>(), stop);
  if (result.candidates.columns.rows() != residual.r.size()) return result;
  rows.r = residual.r;
  rows.H = residual.jacobian * uncertainDirections(watched.uncertainty.covariance);
  rows.changes = std::move(result.candidates.columns);
  rows.first_row = weights->first_row;
  rows.whitener = std::move(weights->whitener);
  addRings(measurements, rows);
  rows.reason.clear();
  return result;
}

}  // namespace tubeplan::calibration
