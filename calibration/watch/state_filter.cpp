#include "calibration/watch/state_filter.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "calibration/diagnosis/evidence/linear_evidence.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::Matrix2d, Eigen::MatrixXd, Eigen::Vector2d, Eigen::VectorXd;

namespace {

constexpr double kTooRare = 1e-9;  // probability below which a count does not update the state

double withBlunders(double p) { return (1 - kBlunder) * p + kBlunder; }

}  // namespace

StateFilter::StateFilter(const WatchedRows& rows)
    : rows_(rows), state_{VectorXd::Zero(rows.H.cols()), MatrixXd::Identity(rows.H.cols(), rows.H.cols()), 0} {}

CountChances StateFilter::add(int k) {
  if (rows_.isCounted(k)) return addCount(k);
  const auto H = rows_.H.middleRows(rows_.first(k), rows_.rowsOf(k));
  const VectorXd innovation = rows_.r.segment(rows_.first(k), rows_.rowsOf(k)) + H * state_.mean;
  const MatrixXd PH = state_.covariance * H.transpose();
  const Eigen::LLT<MatrixXd> S(MatrixXd::Identity(H.rows(), H.rows()) + H * PH);
  state_.deviance += innovation.dot(S.solve(innovation)) + logDeterminant(S);
  state_.mean -= PH * S.solve(innovation);
  state_.covariance -= PH * S.solve(PH.transpose());
  return {};
}

CountChances StateFilter::addCount(int k) {
  const auto H = rows_.H.middleRows<2>(rows_.first(k));
  const CountedSteps& count = *rows_.counted[static_cast<std::size_t>(k)];
  const Vector2d mean = rows_.r.segment<2>(rows_.first(k)) + H * state_.mean;
  const MatrixXd PH = state_.covariance * H.transpose();
  const Matrix2d S = Matrix2d::Identity() + H * PH;
  const RegionProbability now = probabilityOf(count, count.entered, mean, S);
  CountChances chances{withBlunders(now.p), {}};
  state_.deviance -= 2 * std::log(chances.unchanged);
  for (std::size_t t = 0; t < kSpreads.size(); ++t) {
    const double spread = kSpreads[t] / rows_.scale[static_cast<std::size_t>(k)];
    const Matrix2d wider = S + spread * spread * Matrix2d::Identity();
    chances.spread[t] = withBlunders(probabilityOf(count, count.entered, mean, wider).p);
  }
  if (now.p < kTooRare) return chances;
  const Vector2d slope = now.slope / now.p;
  const Matrix2d curvature = now.curvature / now.p - slope * slope.transpose();
  state_.mean += PH * slope;
  state_.covariance += PH * curvature * PH.transpose();
  return chances;
}

double CountWatch::add(int k, const CountChances& chances) {
  double total = -std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t t = 0; t < kSpreads.size(); ++t) {
    const double ratio = std::log(chances.spread[t] / chances.unchanged);
    sums_[t] = logSum(sums_[t], log_weight_) + ratio;
    total = logSum(total, sums_[t]);
    if (rise_[t] <= 0) {
      rise_[t] = 0;
      since_[t] = k;
    }
    rise_[t] += ratio;
    if (rise_[t] <= most) continue;
    most = rise_[t];
    best_ = t;
  }
  return total;
}

}  // namespace tubeplan::calibration
