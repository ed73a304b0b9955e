#include "calibration/estimation/campaign_residual.hpp"

#include <algorithm>

#include "calibration/estimation/prior.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/predict_all.hpp"
#include "calibration/measurements/surfaces.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

namespace {

/// Subtracts from whitened columns the components that the estimated positions of unknown points and surfaces absorb.
void takePointsOff(const MeasurementWeights& weights, Eigen::Ref<MatrixXd> columns) {
  for (const auto& point : weights.points) {
    // All measurements of a point have the same number of rows.
    const Index rows = point.Q.rows() / static_cast<Index>(point.measurements.size());
    const auto rowsOfTouch = [&](int measurement) {
      return columns.middleRows(weights.first_row[static_cast<std::size_t>(measurement)], rows);
    };
    const auto basisOf = [&](std::size_t i) { return point.Q.middleRows(rows * static_cast<Index>(i), rows); };
    MatrixXd common = MatrixXd::Zero(point.Q.cols(), columns.cols());
    for (std::size_t i = 0; i < point.measurements.size(); ++i)
      common.noalias() += basisOf(i).transpose().lazyProduct(rowsOfTouch(point.measurements[i]));
    for (std::size_t i = 0; i < point.measurements.size(); ++i)
      rowsOfTouch(point.measurements[i]).noalias() -= basisOf(i).lazyProduct(common);
  }
}

/// Subtracts from the errors the part that the estimated positions of unknown points and surfaces explain.
void takeEstimatesOff(const MeasurementWeights& weights, VectorXd& error) {
  for (const auto& point : weights.points) {
    const Index rows = point.Q.rows() / static_cast<Index>(point.measurements.size());
    const auto rowsOfTouch = [&](int measurement) {
      return error.segment(weights.first_row[static_cast<std::size_t>(measurement)], rows);
    };
    VectorXd estimate = VectorXd::Zero(point.estimate.rows());
    for (std::size_t i = 0; i < point.measurements.size(); ++i)
      estimate += point.estimate.middleCols(rows * static_cast<Index>(i), rows) * rowsOfTouch(point.measurements[i]);
    for (const int k : point.measurements)
      rowsOfTouch(k) -= weights.by_place_numbers[static_cast<std::size_t>(k)] * estimate;
  }
}

}  // namespace

std::vector<int> basePosesOf(const PlacedArm& placed, const std::vector<Measurement>& measurements) {
  std::vector<int> base_poses;
  for (const auto& measurement : measurements) base_poses.push_back(basePoseOf(placed, measurement));
  return base_poses;
}

void removeSharedParts(const MeasurementWeights& weights, Eigen::Ref<MatrixXd> columns) {
  decorrelate(weights, columns);
  takePointsOff(weights, columns);
}

void removeSharedPartsWithin(const MeasurementWeights& weights, const std::vector<int>& measurements, MatrixXd& rows) {
  decorrelateWithin(weights, measurements, rows);
  const auto first_row = stackedRows(weights, measurements).first;
  for (const auto& point : weights.points) {
    if (!std::ranges::all_of(point.measurements, [&](int k) { return first_row.contains(k); })) continue;
    const Index rows_of_touch = point.Q.rows() / static_cast<Index>(point.measurements.size());
    std::vector<Index> own;
    for (const int k : point.measurements)
      for (Index i = 0; i < rows_of_touch; ++i) own.push_back(first_row.at(k) + i);
    const MatrixXd touches = rows(own, Eigen::all);
    rows(own, Eigen::all) = touches - point.Q * (point.Q.transpose() * touches);
  }
}

CampaignResidual::CampaignResidual(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                   const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                                   Priors priors, StopQuestion stop)
    : start_(start),
      unknowns_(unknowns),
      measurements_(measurements),
      weights_(weights),
      stop_(std::move(stop)),
      placed_(start) {
  if (priors == Priors::kAppended) prior_slopes_ = priorSlopes(unknowns);
  base_pose_of_ = basePosesOf(start, measurements);
  if (touchSurfaces(measurements)) settled_ = measurements;
  bases_.resize(start.base_poses.size());
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const Unknown& unknown = unknowns[k];
    if (unknown.owner == Unknown::Owner::kArm) {
      requested_slopes_.numbers.push_back(deflection::Variable::number(unknown.path));
      numbers_.push_back(static_cast<Index>(k));
      continue;
    }
    requested_slopes_.by_base = true;
    auto& base = bases_[static_cast<std::size_t>(unknown.base_pose)];
    base.resize(6, -1);
    base[static_cast<std::size_t>(unknown.component)] = static_cast<Index>(k);
  }
  slopes_.resize(numbers_.size());
  if (numbers_.empty()) prepared_.emplace(placed_.arm);
}

void CampaignResidual::moveTo(const VectorXd& x) {
  apply(start_, unknowns_, x, placed_);
  for (std::size_t n = 0; n < numbers_.size(); ++n)
    slopes_[n] = slopeAt(unknowns_[static_cast<std::size_t>(numbers_[n])], x[numbers_[n]]);
  turns_.clear();
  for (const auto& base : bases_) {
    Vector3d turn = Vector3d::Zero();
    for (std::size_t axis = 0; axis < 3 && !base.empty(); ++axis)
      if (base[3 + axis] >= 0) turn[static_cast<Index>(axis)] = x[base[3 + axis]];
    turns_.push_back(deflection::leftJacobian(turn));
  }
}

bool CampaignResidual::evaluate(const VectorXd& x, VectorXd& r, MatrixXd* jacobian, VectorXd* error) {
  if (!linearize(x, jacobian != nullptr)) return false;
  r.resize(weights_.rows + prior_slopes_.size());
  if (jacobian) jacobian->setZero(r.size(), x.size());
  if (x.size() == 0) jacobian = nullptr;  // an empty Jacobian has no storage and must not be accessed below
  applyWeights(r, jacobian);
  if (error) *error = last_.error;
  removeSharedParts(weights_, r);
  if (jacobian) removeSharedParts(weights_, *jacobian);
  if (error) takeEstimatesOff(weights_, *error);
  if (prior_slopes_.size() == 0) return true;
  r.tail(x.size()) = priorResiduals(unknowns_, x);
  if (jacobian) jacobian->bottomRows(x.size()).diagonal() = prior_slopes_;
  return true;
}

/// Computes the errors at x, and their Jacobian if requested, unless they are already known from the last evaluation.
bool CampaignResidual::linearize(const VectorXd& x, bool with_jacobian) {
  const bool is_there = last_.ok && last_.x.size() == x.size() && last_.x == x && last_.error.size() == weights_.rows;
  if (is_there && (!with_jacobian || last_.jacobian.cols() == x.size())) return true;
  last_.ok = false;
  moveTo(x);
  last_.error.resize(weights_.rows);
  last_.jacobian.setZero(with_jacobian ? weights_.rows : 0, with_jacobian ? x.size() : 0);
  if (!settled_.empty() && !settleSurfaces(placed_, settled_)) return false;
  if (!fill(with_jacobian)) {
    throwIfStopped(stop_);  // if a stop made `fill` fail, throw instead of reporting a model failure
    return false;
  }
  last_.x = x;
  return last_.ok = true;
}

namespace {

/// Computes `to` = `whitener` * `from`; uses fixed-size matrices for measurements with three rows, which are the most
/// common.
void whiten(const MatrixXd& whitener, const Eigen::Ref<const MatrixXd>& from, Eigen::Ref<MatrixXd> to) {
  if (whitener.rows() == 3)
    to.noalias() = Matrix3d(whitener).lazyProduct(from);
  else
    to.noalias() = whitener.lazyProduct(from);
}

}  // namespace

void CampaignResidual::applyWeights(VectorXd& r, MatrixXd* jacobian) const {
  for (std::size_t k = 0; k < measurements_.size(); ++k) {
    const MatrixXd& whitener = weights_.whitener[k];
    const Index row = weights_.first_row[k], rows = whitener.rows();
    r.segment(row, rows) = whitener.lazyProduct(last_.error.segment(row, rows));
    if (jacobian) whiten(whitener, last_.jacobian.middleRows(row, rows), jacobian->middleRows(row, rows));
  }
}

/// Fills `last_` with the errors of all measurements and, if requested, their Jacobian. Returns false if the arm's
/// deflected shape does not converge or a stop is requested.
bool CampaignResidual::fill(bool with_jacobian) {
  static const PredictionRequest kValues;
  const auto& measurements = taken();
  const auto put = [&](std::size_t k, const Prediction& prediction) {
    last_.error.segment(weights_.first_row[k], prediction.value.size()) =
        prediction.value - kindOf(measurements[k]).measured(measurements[k]);
    if (with_jacobian) scatter(base_pose_of_[k], prediction, weights_.first_row[k]);
  };
  return predictAll(placed_, measurements, base_pose_of_, with_jacobian ? requested_slopes_ : kValues, stop_, put,
                    prepared_ ? &*prepared_ : nullptr);
}

void CampaignResidual::scatter(int base_pose, const Prediction& prediction, Index row) {
  const Index rows = prediction.value.size();
  for (std::size_t n = 0; n < numbers_.size(); ++n)
    last_.jacobian.block(row, numbers_[n], rows, 1) = prediction.by_numbers.col(static_cast<Index>(n)) * slopes_[n];
  const auto& base = bases_[static_cast<std::size_t>(base_pose)];
  if (base.empty()) return;
  Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 6, 6> by_base = prediction.by_base;
  by_base.rightCols<3>() = prediction.by_base.rightCols<3>().lazyProduct(turns_[static_cast<std::size_t>(base_pose)]);
  for (Index k = 0; k < 6; ++k)
    if (base[static_cast<std::size_t>(k)] >= 0)
      last_.jacobian.block(row, base[static_cast<std::size_t>(k)], rows, 1) = by_base.col(k);
}

}  // namespace tubeplan::calibration
