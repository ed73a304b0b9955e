#include "calibration/whitened_residual.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cassert>
#include <cmath>
#include <map>

#include "calibration/reading_prediction.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

namespace {

/// Calls `each(predictor, k)` for every reading, on all cores; false as soon as one call is.
template <class Each>
bool predictAll(const PlacedArm& placed, std::size_t readings, const Each& each) {
  constexpr std::size_t kAtOnce = 16;  // readings that share what is prepared of the arm
  std::atomic<bool> ok = true;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, readings, kAtOnce), [&](const auto& range) {
    ReadingPredictor predictor(placed.arm);
    for (std::size_t k = range.begin(); k != range.end(); ++k)
      if (!each(predictor, k)) ok = false;
  });
  return ok;
}

bool touchesUnknownPoint(const Measurement& reading) {
  return reading.kind == MeasurementKind::kTouch && !reading.p_W.has_value();
}

void eliminatePoints(const std::vector<Measurement>& readings, ReadingWeights& weights) {
  std::map<std::string, std::size_t> index;
  for (std::size_t k = 0; k < readings.size(); ++k) {
    if (!touchesUnknownPoint(readings[k])) continue;
    const auto [at, is_new] = index.emplace(readings[k].point, weights.points.size());
    if (is_new) weights.points.push_back({readings[k].point, {}, {}, {}});
    weights.points[at->second].readings.push_back(static_cast<int>(k));
  }
  for (auto& point : weights.points) {
    const auto n = static_cast<Index>(point.readings.size());
    MatrixXd stacked(3 * n, 3);
    for (Index i = 0; i < n; ++i)
      stacked.middleRows(3 * i, 3) =
          weights.whitener[static_cast<std::size_t>(point.readings[static_cast<std::size_t>(i)])];
    const Eigen::HouseholderQR<MatrixXd> qr(stacked);
    point.Q = qr.householderQ() * MatrixXd::Identity(3 * n, 3);
    const MatrixXd R = point.Q.transpose() * stacked;
    point.estimate = R.inverse() * point.Q.transpose();
    for (Index i = 0; i < n; ++i)
      point.estimate.middleCols(3 * i, 3) *=
          weights.whitener[static_cast<std::size_t>(point.readings[static_cast<std::size_t>(i)])];
    weights.degrees_of_freedom -= 3;
  }
}

/// The variables of one reading's prediction and the columns they go to.
struct Columns {
  PredictionRequest request;
  std::vector<Index> numbers;             ///< column of each number
  std::vector<double> slopes;             ///< of its parameter by its variable
  std::vector<std::vector<Index>> bases;  ///< of each placing: six columns, or none
  std::vector<Eigen::Matrix3d> turns;     ///< from the rotation vector's rate to the turn's, at the step
};

/// d(turn)/d(rotation vector) at a step w.
Eigen::Matrix3d leftJacobian(const Vector3d& w) {
  const double t = w.norm();
  Eigen::Matrix3d K;
  K << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  if (t < 1e-6) return Eigen::Matrix3d::Identity() + K / 2;
  return Eigen::Matrix3d::Identity() + (1 - std::cos(t)) / (t * t) * K + (t - std::sin(t)) / (t * t * t) * K * K;
}

Columns columnsOf(const PlacedArm& start, const std::vector<Unknown>& unknowns, const VectorXd& x) {
  Columns columns;
  columns.bases.resize(start.placings.size());
  std::vector<Vector3d> turns(start.placings.size(), Vector3d::Zero());
  for (Index k = 0; k < x.size(); ++k) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(k)];
    if (unknown.owner == Unknown::Owner::kArm) {
      columns.request.numbers.push_back(deflection::Variable::number(unknown.path));
      columns.numbers.push_back(k);
      columns.slopes.push_back(slopeAt(unknown, x[k]));
      continue;
    }
    auto& base = columns.bases[static_cast<std::size_t>(unknown.placing)];
    base.resize(6, -1);
    base[static_cast<std::size_t>(unknown.component)] = k;
    if (unknown.component >= 3) turns[static_cast<std::size_t>(unknown.placing)][unknown.component - 3] = x[k];
  }
  for (const auto& turn : turns) columns.turns.push_back(leftJacobian(turn));
  return columns;
}

void scatter(const Columns& columns, int placing, const Prediction& prediction, const MatrixXd& whitener, Index row,
             MatrixXd& jacobian) {
  const Index rows = prediction.value.size();
  for (std::size_t n = 0; n < columns.numbers.size(); ++n)
    jacobian.block(row, columns.numbers[n], rows, 1) =
        whitener * prediction.by_numbers.col(static_cast<Index>(n)) * columns.slopes[n];
  const auto& base = columns.bases[static_cast<std::size_t>(placing)];
  if (base.empty()) return;
  MatrixXd by_base = whitener * prediction.by_base;
  by_base.rightCols<3>() = (by_base.rightCols<3>() * columns.turns[static_cast<std::size_t>(placing)]).eval();
  for (Index k = 0; k < 6; ++k)
    if (base[static_cast<std::size_t>(k)] >= 0)
      jacobian.block(row, base[static_cast<std::size_t>(k)], rows, 1) = by_base.col(k);
}

/// What was measured: nothing for an unknown point, whose elimination takes it off.
VectorXd measuredOf(const Measurement& reading) {
  if (reading.kind == MeasurementKind::kDistance) return VectorXd::Constant(1, reading.distance);
  return reading.p_W ? VectorXd(*reading.p_W) : VectorXd::Zero(3);
}

/// Rows of a point's readings, one above the other.
MatrixXd stackedRows(const ReadingWeights& weights, const ReadingWeights::UnknownPoint& point, const MatrixXd& of) {
  MatrixXd stacked(3 * static_cast<Index>(point.readings.size()), of.cols());
  for (std::size_t i = 0; i < point.readings.size(); ++i)
    stacked.middleRows(3 * static_cast<Index>(i), 3) =
        of.middleRows(weights.first_row[static_cast<std::size_t>(point.readings[i])], 3);
  return stacked;
}

void spreadRows(const ReadingWeights& weights, const ReadingWeights::UnknownPoint& point, const MatrixXd& stacked,
                MatrixXd& to) {
  for (std::size_t i = 0; i < point.readings.size(); ++i)
    to.middleRows(weights.first_row[static_cast<std::size_t>(point.readings[i])], 3) =
        stacked.middleRows(3 * static_cast<Index>(i), 3);
}

void takePointsOffErrors(const ReadingWeights& weights, VectorXd& error) {
  for (const auto& point : weights.points) {
    const Vector3d estimate = point.estimate * stackedRows(weights, point, error);
    for (const int k : point.readings) error.segment<3>(weights.first_row[static_cast<std::size_t>(k)]) -= estimate;
  }
}

}  // namespace

std::optional<ReadingWeights> weighReadings(const PlacedArm& placed, const std::vector<Measurement>& readings,
                                            const VectorXd& factors) {
  assert(factors.size() == 0 || factors.size() == static_cast<Index>(readings.size()));
  ReadingWeights weights;
  weights.whitener.resize(readings.size());
  weights.covariance.resize(readings.size());
  for (const auto& reading : readings) {
    weights.first_row.push_back(weights.rows);
    weights.rows += rowsOf(reading);
  }
  weights.degrees_of_freedom = weights.rows;
  PredictionRequest request;
  request.by_joints = true;
  const bool ok = predictAll(placed, readings.size(), [&](ReadingPredictor& predictor, std::size_t k) {
    const auto& X_WB = placed.placings[static_cast<std::size_t>(placingOf(placed, readings[k]))].X_WB;
    const Prediction prediction = predictor.predict(X_WB, readings[k], request);
    if (!prediction.ok) return false;
    weights.covariance[k] = readingCovariance(placed.arm, readings[k], prediction.by_joints);
    const Eigen::LLT<MatrixXd> factor(weights.covariance[k]);
    weights.whitener[k] = factor.matrixL().solve(MatrixXd::Identity(rowsOf(readings[k]), rowsOf(readings[k])));
    if (factors.size()) weights.whitener[k] *= std::sqrt(factors[static_cast<Index>(k)]);
    return true;
  });
  if (!ok) return std::nullopt;
  eliminatePoints(readings, weights);
  return weights;
}

WhitenedResidual whitenedResidual(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                  const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                  const VectorXd& x, bool with_jacobian) {
  const PlacedArm placed = applied(start, unknowns, x);
  const Columns columns = columnsOf(start, unknowns, x);
  WhitenedResidual result;
  result.r.resize(weights.rows);
  result.error.resize(weights.rows);
  if (with_jacobian) result.jacobian = MatrixXd::Zero(weights.rows, x.size());
  result.ok = predictAll(placed, readings.size(), [&](ReadingPredictor& predictor, std::size_t k) {
    const int placing = placingOf(placed, readings[k]);
    PredictionRequest request;
    if (with_jacobian) {
      request.numbers = columns.request.numbers;
      request.by_base = !columns.bases[static_cast<std::size_t>(placing)].empty();
    }
    const Prediction prediction =
        predictor.predict(placed.placings[static_cast<std::size_t>(placing)].X_WB, readings[k], request);
    if (!prediction.ok) return false;
    const Index row = weights.first_row[k];
    const VectorXd error = prediction.value - measuredOf(readings[k]);
    result.error.segment(row, error.size()) = error;
    result.r.segment(row, error.size()) = weights.whitener[k] * error;
    if (with_jacobian) scatter(columns, placing, prediction, weights.whitener[k], row, result.jacobian);
    return true;
  });
  if (!result.ok) return result;
  MatrixXd r = result.r;
  takePointsOff(weights, r);
  result.r = r;
  takePointsOff(weights, result.jacobian);
  takePointsOffErrors(weights, result.error);
  return result;
}

void takePointsOff(const ReadingWeights& weights, MatrixXd& columns) {
  if (columns.cols() == 0) return;
  for (const auto& point : weights.points) {
    MatrixXd stacked = stackedRows(weights, point, columns);
    stacked -= (point.Q * (point.Q.transpose() * stacked)).eval();
    spreadRows(weights, point, stacked, columns);
  }
}

VectorXd errorLengths(const std::vector<Measurement>& readings, const ReadingWeights& weights, const VectorXd& error) {
  VectorXd lengths(static_cast<Index>(readings.size()));
  for (std::size_t k = 0; k < readings.size(); ++k)
    lengths[static_cast<Index>(k)] = error.segment(weights.first_row[k], rowsOf(readings[k])).norm();
  return lengths;
}

double noiseFloor(const std::vector<Measurement>& readings, const ReadingWeights& weights) {
  double sum = 0;
  for (const auto& covariance : weights.covariance) sum += covariance.trace();
  for (const auto& point : weights.points)
    for (const int k : point.readings)
      sum -= weights.covariance[static_cast<std::size_t>(k)].trace() / static_cast<double>(point.readings.size());
  return std::sqrt(sum / static_cast<double>(readings.size()));
}

}  // namespace tubeplan::calibration
