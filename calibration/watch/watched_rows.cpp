#include "calibration/watch/watched_rows.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/measurements/counted_section.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector2d, Eigen::Vector3d, Eigen::VectorXd;

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

/// Measurements in which every count of steps is one of both components of the offset of the section amid the last
/// step, whose noise is that of the encoders and of the tolerances alone.
struct CountedOffsets {
  bool ok = true;  ///< false if the arm's shape does not converge
  std::vector<Measurement> measurements;
  std::vector<Vector2d> lean;  ///< predicted tilt of the tool at each count; zero for other measurements
};

CountedOffsets countedOffsets(const WatchedArm& watched, const std::vector<Measurement>& measurements) {
  CountedOffsets counted{true, measurements, std::vector<Vector2d>(measurements.size(), Vector2d::Zero())};
  for (std::size_t k = 0; k < measurements.size() && counted.ok; ++k) {
    Measurement& offset = counted.measurements[k];
    if (!kindOf(offset).counts_steps) continue;
    const auto axis = toolAxisAt(watched.arm, watched.X_WB, offset);
    counted.ok = axis.has_value();
    if (!axis) continue;
    counted.lean[k] = axis->lean();
    offset.p_QS = -midDepthOfLastStep(watched.tool) / axis->axis_W.z() * axis->axis_T;
    const auto next = std::min(static_cast<std::size_t>(offset.kind_values[0]), watched.tool.steps.size() - 1);
    offset.kind_values[1] = 0;
    offset.kind_values[2] = watched.tool.steps[next].tolerance;
    offset.sigma = kToleranceError * offset.kind_values[2];
  }
  return counted;
}

/// Whitens each measurement by its own covariance, and a count by the mean variance of its offset. Encoder noise that
/// measurements at the same joint values share is then counted as if it were independent, because a watch must not mix
/// a measurement with later ones.
void whitenIndependently(const std::vector<Measurement>& measurements, MeasurementWeights& weights,
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

}  // namespace

bool WatchedRows::hasCounts() const {
  return std::ranges::any_of(counted, [](const auto& count) { return count.has_value(); });
}

RowsAndCandidates watchedRows(const WatchedArm& watched, const std::vector<Measurement>& measurements,
                              const StopQuestion& stop) {
  RowsAndCandidates result;
  WatchedRows& rows = result.rows;
  if (measurements.empty()) {
    rows.reason = "there are no readings";
    return result;
  }
  if (std::ranges::any_of(measurements, [&](const auto& m) { return m.setup != measurements.front().setup; })) {
    rows.reason = "the readings are of several set-ups, but a watch uses only one";
    return result;
  }
  const auto counts = [](const Measurement& m) { return kindOf(m).counts_steps; };
  if (watched.tool.steps.empty() && std::ranges::any_of(measurements, counts)) {
    rows.reason = "the readings count steps of a tool that the cell does not state";
    return result;
  }
  PlacedArm placed{watched.arm, {{measurements.front().setup, watched.X_WB, false}}};
  const std::vector<Unknown> unknowns = watchedUnknowns(watched, placed);
  rows.reason = "the model cannot be evaluated at the readings";
  const auto [ok, offsets, lean] = countedOffsets(watched, measurements);
  if (!ok) return result;
  auto weights = weighMeasurements(placed, offsets, {}, watched.model_error, stop);
  if (!weights) return result;
  if (!weights->points.empty()) {
    rows.reason = "readings of points or surfaces of unknown place cannot be watched one by one";
    return result;
  }
  whitenIndependently(measurements, *weights, rows.scale);
  const auto residual = whitenedResidual(placed, unknowns, offsets, *weights, zerosOf(unknowns), true, stop);
  if (!residual.ok) return result;
  result.candidates = candidateChanges(placed, offsets, *weights, residual.jacobian.leftCols<6>(), stop);
  if (result.candidates.columns.rows() != residual.r.size()) return result;
  rows.r = residual.r;
  rows.H = residual.jacobian * uncertainDirections(watched.uncertainty.covariance);
  rows.changes = std::move(result.candidates.columns);
  rows.first_row = weights->first_row;
  rows.whitener = std::move(weights->whitener);
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    rows.counted.emplace_back();
    if (!counts(measurements[k])) continue;
    const int entered = static_cast<int>(measurements[k].kind_values[0]);
    rows.counted.back() = countedSteps(watched.tool, lean[k], rows.scale[k], entered);
  }
  rows.reason.clear();
  return result;
}

}  // namespace tubeplan::calibration
