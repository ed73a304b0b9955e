#include "calibration/diagnosis/evidence/linear_evidence.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/estimation/prior.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr Index kMostAxes = 120;     // maximum number of axes of the discrepancy; the largest are kept
constexpr double kLeastAxis = 1e-5;  // fraction of the discrepancy's variance that may be neglected
// A column is absorbed by the fitted parameters if at most this fraction of its squared length remains; such a
// remainder is rounding error.
constexpr double kLeastLeft = 1e-8;
constexpr Index kPanel = 64;         // number of columns that are multiplied at once
constexpr Index kRowsAtOnce = 4096;  // number of rows that are copied for one multiplication
constexpr double kSmallest = 1e-300;

double logOfSum(const std::vector<double>& logs) {
  const double most = *std::ranges::max_element(logs);
  if (!std::isfinite(most)) return most;
  double sum = 0;
  for (const double log : logs) sum += std::exp(log - most);
  return most + std::log(sum);
}

/// Returns the log of the standard normal distribution function.
double logBelow(double x) {
  if (x < -30) return -x * x / 2 - std::log(-x * std::sqrt(2 * std::numbers::pi));
  return std::log(std::max(kSmallest, std::erfc(-x / std::numbers::sqrt2) / 2));
}

/// Returns L such that L L^T approximates the positive semidefinite matrix: a pivoted Cholesky factor, truncated when
/// the residual is small.
MatrixXd pivotedCholesky(const MatrixXd& matrix) {
  VectorXd residual_diagonal = matrix.diagonal().cwiseMax(0);
  const double trace = residual_diagonal.sum();
  MatrixXd L(matrix.rows(), std::min(kMostAxes, matrix.rows()));
  Index rank = 0;
  for (; rank < L.cols() && residual_diagonal.sum() > kLeastAxis * trace; ++rank) {
    Index pivot = 0;
    const double most = residual_diagonal.maxCoeff(&pivot);
    auto column = L.col(rank);
    column = matrix.col(pivot);
    if (rank > 0) column.noalias() -= L.leftCols(rank) * L.row(pivot).head(rank).transpose();
    column /= std::sqrt(most);
    residual_diagonal = (residual_diagonal - column.cwiseAbs2()).cwiseMax(0);
    residual_diagonal[pivot] = 0;
  }
  return L.leftCols(rank);
}

}  // namespace

double logSum(double a, double b) {
  const double most = std::max(a, b);
  return std::isfinite(most) ? most + std::log1p(std::exp(std::min(a, b) - most)) : most;
}

void EvidenceGram::add(const MatrixXd& J, const MatrixXd& S, const MatrixXd& Z, const VectorXd& y) {
  fitted = J.cols(), causes = S.cols(), discrepancy = Z.cols();
  const Index count = fitted + causes + discrepancy + 1;
  if (products.size() == 0) products = MatrixXd::Zero(count, count);
  for (Index row = 0; row < y.size(); row += kRowsAtOnce) {
    const Index rows = std::min(kRowsAtOnce, y.size() - row);
    MatrixXd all(rows, count);
    all << J.middleRows(row, rows), S.middleRows(row, rows), Z.middleRows(row, rows), y.segment(row, rows);
    const Index panels = (count + kPanel - 1) / kPanel;
    tbb::parallel_for(Index{0}, panels, [&](Index panel) {
      const Index first = panel * kPanel, width = std::min(kPanel, count - first);
      products.block(first, first, count - first, width).noalias() +=
          all.rightCols(count - first).transpose() * all.middleCols(first, width);
    });
  }
}

LinearEvidence::LinearEvidence(const EvidenceGram& gram, const std::vector<Unknown>& fitted,
                               const EvidenceOptions& options)
    : options_(options), log_density_(gram.log_density) {
  if (options_.noise_scales.empty()) options_.noise_scales = {1};
  integrateFitted(gram, fitted);
  listLevels();
}

/// Replaces each product a^T b by a^T (I + J P J^T)^-1 b = a^T b - a^T J H^-1 J^T b with H = J^T J + P^-1, after J
/// times the prior mean has been subtracted from y.
void LinearEvidence::integrateFitted(const EvidenceGram& gram, const std::vector<Unknown>& fitted) {
  MatrixXd K = gram.products.selfadjointView<Eigen::Lower>();
  const Index n = gram.fitted, kept = K.rows() - n;
  const VectorXd scale = typicalsOf(fitted), information = priorInformation(fitted);
  if (n > 0) {
    VectorXd mean(n);
    for (Index k = 0; k < n; ++k) mean[k] = fitted[static_cast<std::size_t>(k)].prior_mean;
    const VectorXd of_mean = K.leftCols(n) * mean;
    const Index y = K.rows() - 1;
    const double square = K(y, y) - 2 * of_mean[y] + mean.dot(of_mean.head(n));
    K.col(y) -= of_mean;
    K.row(y) = K.col(y).transpose();
    K(y, y) = square;
    K.topRows(n) = (scale.asDiagonal() * K.topRows(n)).eval();
    K.leftCols(n) = (K.leftCols(n) * scale.asDiagonal()).eval();
    MatrixXd H = K.topLeftCorner(n, n);
    H.diagonal() += information;
    const Eigen::LDLT<MatrixXd> factor(H);
    K.bottomRightCorner(kept, kept).noalias() -= K.bottomLeftCorner(kept, n) * factor.solve(K.topRightCorner(n, kept));
    for (Index k = 0; k < n; ++k) {
      log_det_fitted_ += std::log(std::max(kSmallest, factor.vectorD()[k]));
      if (information[k] > 0) log_det_fitted_ -= std::log(information[k]);
    }
  }
  const Index s = gram.causes, z = gram.discrepancy;
  length_ = gram.products.diagonal().segment(n, s).cwiseSqrt();
  S_y_.resize(s + 1, s + 1);
  S_y_ << K.block(n, n, s, s), K.block(n, n + s + z, s, 1), K.block(n + s + z, n, 1, s), K.bottomRightCorner<1, 1>();
  // A column that the fitted parameters absorb up to rounding is set to zero.
  std::vector<Index> absorbed;
  for (Index c = 0; c < s; ++c)
    if (!(S_y_(c, c) > kLeastLeft * length_[c] * length_[c])) absorbed.push_back(c);
  MatrixXd Z_S_y(z, s + 1);
  Z_S_y << K.block(n + s, n, z, s), K.block(n + s, n + s + z, z, 1);
  for (const Index c : absorbed) {
    S_y_.row(c).setZero();
    S_y_.col(c).setZero();
    Z_S_y.col(c).setZero();
  }
  findAxes(K.block(n + s, n + s, z, z), Z_S_y);
}

/// Restricts the discrepancy to the span of a pivoted Cholesky factor L of Z^T Z. Let B be an orthonormal basis of this
/// span, and B^T Z^T Z B = U Lambda U^T. The unit axes in the measurements' space are then u_k, the columns of
/// Z B U / sqrt(Lambda), and Z B (Z B)^T is the sum of Lambda_k u_k u_k^T.
void LinearEvidence::findAxes(const MatrixXd& Z_Z, const MatrixXd& Z_S_y) {
  along_.resize(0, Z_S_y.cols());
  axes_.resize(Z_Z.rows(), 0);
  if (Z_Z.rows() == 0) return;
  const MatrixXd L = pivotedCholesky(Z_Z);
  if (L.cols() == 0) return;
  const MatrixXd B = Eigen::HouseholderQR<MatrixXd>(L).householderQ() * MatrixXd::Identity(L.rows(), L.cols());
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(B.transpose() * Z_Z * B);
  Index first = 0;
  while (first < L.cols() && !(eigen.eigenvalues()[first] > 1e-10 * eigen.eigenvalues().tail<1>()[0])) ++first;
  squares_ = eigen.eigenvalues().tail(L.cols() - first);
  axes_ = B * eigen.eigenvectors().rightCols(squares_.size()) * squares_.cwiseSqrt().cwiseInverse().asDiagonal();
  along_ = axes_.transpose() * Z_S_y;
}

void LinearEvidence::listLevels() {
  std::vector<double> sizes{0};
  if (squares_.size() > 0) sizes.insert(sizes.end(), options_.discrepancies.begin(), options_.discrepancies.end());
  const auto tried = static_cast<double>(sizes.size() - 1);
  for (const double size : sizes) {
    Level level = levelOf(size);
    level.log_prior = tried == 0  ? 0
                      : size == 0 ? std::log1p(-options_.discrepancy_prior - options_.source_prior)
                                  : std::log(options_.discrepancy_prior / tried);
    levels_.push_back(std::move(level));
  }
}

/// Returns the level for this size of the discrepancy; its prior is not set.
LinearEvidence::Level LinearEvidence::levelOf(double size) const {
  Level level;
  level.size = size;
  const VectorXd variance = size * size * squares_;
  level.taken = variance.array() / (1 + variance.array());
  level.along = level.taken.cwiseSqrt().asDiagonal() * along_;
  level.log_det = log_det_fitted_ + variance.array().log1p().sum();
  return level;
}

LinearEvidence::Solution LinearEvidence::solve(const std::vector<PriorSize>& causes, const Level& level) const {
  const auto n = static_cast<Index>(causes.size());
  const Index y = S_y_.rows() - 1;
  const bool has_discrepancy = level.size > 0;
  Solution solution;
  solution.square = S_y_(y, y);
  if (has_discrepancy) solution.square -= level.along.col(y).squaredNorm();
  if (n == 0) return solution;
  MatrixXd M(n, n);
  VectorXd b(n), sigma(n);
  for (Index i = 0; i < n; ++i) {
    const PriorSize& a = causes[static_cast<std::size_t>(i)];
    sigma[i] = a.sigma;
    b[i] = S_y_(a.column, y);
    if (has_discrepancy) b[i] -= level.along.col(a.column).dot(level.along.col(y));
    for (Index j = 0; j <= i; ++j) {
      const int other = causes[static_cast<std::size_t>(j)].column;
      M(i, j) = S_y_(a.column, other);
      if (has_discrepancy) M(i, j) -= level.along.col(a.column).dot(level.along.col(other));
      M(j, i) = M(i, j);
    }
  }
  M = (sigma.asDiagonal() * M * sigma.asDiagonal()).eval();
  M.diagonal().array() += 1;
  const Eigen::LLT<MatrixXd> factor(M);
  const VectorXd scaled = sigma.cwiseProduct(b);
  const VectorXd best = factor.solve(scaled);
  solution.square -= scaled.dot(best);
  solution.log_det = 2 * MatrixXd(factor.matrixL()).diagonal().array().log().sum();
  solution.sizes = sigma.cwiseProduct(best);
  solution.sigma = sigma.cwiseProduct(factor.solve(MatrixXd::Identity(n, n)).diagonal().cwiseSqrt());
  for (Index i = 0; i < n; ++i)
    if (const int sign = causes[static_cast<std::size_t>(i)].sign; sign != 0)
      solution.log_signs += std::numbers::ln2 + logBelow(sign * solution.sizes[i] / solution.sigma[i]);
  return solution;
}

double LinearEvidence::logOf(const Solution& solution, const Level& level, double noise_scale) const {
  return log_density_ + level.log_prior - (level.log_det + solution.log_det) / 2 + solution.log_signs -
         options_.noise_rows * std::log(noise_scale) - solution.square / (2 * noise_scale * noise_scale);
}

Evidence LinearEvidence::of(const std::vector<PriorSize>& causes, std::optional<std::size_t> only) const {
  Evidence evidence;
  std::vector<double> all, with, none;
  double most = -std::numeric_limits<double>::infinity(), most_of_none = most;
  const double log_scales = std::log(static_cast<double>(options_.noise_scales.size()));
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    if (only && k > 0 && k != *only) continue;
    const Level& level = levels_[k];
    const Solution solution = solve(causes, level);
    for (const double scale : options_.noise_scales) {
      const double log = logOf(solution, level, scale) - log_scales;
      all.push_back(log);
      (level.size > 0 ? with : none).push_back(log);
      if (level.size == 0 && log > most_of_none) most_of_none = log, evidence.none_scale = scale;
      if (!(log > most)) continue;
      most = log;
      evidence.discrepancy = level.size;
      evidence.level = k;
      evidence.noise_scale = scale;
      evidence.sizes = solution.sizes;
      evidence.sigma = solution.sigma;
    }
  }
  evidence.log = logOfSum(all);
  evidence.log_none = logOfSum(none);
  if (!with.empty()) evidence.discrepancy_probability = std::exp(logOfSum(with) - evidence.log);
  return evidence;
}

double LinearEvidence::visibility(int column) const { return std::sqrt(std::max(0., S_y_(column, column))); }

double LinearEvidence::keptShare(int column) const {
  return length_[column] > 0 ? visibility(column) / length_[column] : 0;
}

double LinearEvidence::fall(const std::vector<int>& columns) const {
  if (columns.empty()) return 0;
  const Index y = S_y_.rows() - 1;
  const MatrixXd G = S_y_(columns, columns);
  const VectorXd b = S_y_(columns, std::vector<Index>{y});
  const VectorXd scale = G.diagonal().cwiseMax(kSmallest).cwiseSqrt().cwiseInverse();
  const MatrixXd unit = scale.asDiagonal() * G * scale.asDiagonal();
  const VectorXd right = scale.cwiseProduct(b);
  return std::max(0., right.dot(unit.completeOrthogonalDecomposition().solve(right)));
}

RichestFit LinearEvidence::richest() const {
  const Level& last = levels_.back();
  if (last.size == 0) return {chi2(), 0};
  return {chi2() - (last.taken.array() * along_.rightCols<1>().array().square()).sum(), last.taken.sum()};
}

MatrixXd LinearEvidence::principalTerms(Index most) const {
  const Index count = std::min(most, axes_.cols());
  return axes_.rightCols(count).rowwise().reverse() * squares_.tail(count).reverse().cwiseSqrt().asDiagonal();
}

VectorXd LinearEvidence::discrepancyWeights(const std::vector<PriorSize>& causes, double size) const {
  const Level level = levelOf(size);
  const Solution solution = solve(causes, level);
  VectorXd residual = along_.rightCols<1>();
  for (std::size_t i = 0; i < causes.size(); ++i)
    residual -= along_.col(causes[i].column) * solution.sizes[static_cast<Index>(i)];
  return axes_ * level.taken.cwiseProduct(residual);
}

}  // namespace tubeplan::calibration
