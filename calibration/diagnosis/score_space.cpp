#include "calibration/diagnosis/score_space.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cassert>
#include <cmath>

#include "calibration/span.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kAbsorbed = 1e-4;  // kept share of a column below which it is the fit's own
constexpr double kBeyondBand = 2;   // sigmas by which a size may pass the plausible band
constexpr double kSingular = 1e-8;  // of the largest eigenvalue
constexpr double kRidge = 1e-10;    // of the largest diagonal

constexpr int kMostColumns = 8;

/// -log10 of the chance of a fall that large by noise alone.
double evidenceOf(double fall, double degrees, bool one_sided) {
  double p = boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees), std::max(0., fall)));
  if (one_sided) p /= 2;
  return -std::log10(std::max(p, 1e-300));
}

/// Empty where the block is singular.
MatrixXd inverseOf(const MatrixXd& block) {
  if (block.rows() == 1) return block(0, 0) > 0 ? MatrixXd::Constant(1, 1, 1 / block(0, 0)) : MatrixXd();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(block);
  const VectorXd& values = eigen.eigenvalues();
  if (!(values[0] > kSingular * values[values.size() - 1])) return {};
  return eigen.eigenvectors() * values.cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose();
}

/// All non-empty choices of sizes; with more than four only single ones and all of them.
std::vector<std::vector<int>> choicesOf(int sizes) {
  std::vector<std::vector<int>> choices;
  for (unsigned mask = 1; mask < (1u << sizes); ++mask) {
    std::vector<int> choice;
    for (int k = 0; k < sizes; ++k)
      if (mask & (1u << k)) choice.push_back(k);
    if (sizes <= 4 || choice.size() == 1 || static_cast<int>(choice.size()) == sizes) choices.push_back(choice);
  }
  return choices;
}

}  // namespace

ScoreSpace::ScoreSpace(const Catalogue& catalogue, const MatrixXd& jacobian, const VectorXd& r) {
  Index count = 0;
  for (const auto& entry : catalogue.columns) count += entry.columns.cols();
  MatrixXd S(r.size(), count);
  Index column = 0;
  for (const auto& entry : catalogue.columns) {
    const Candidate& candidate = catalogue.candidates[static_cast<std::size_t>(entry.candidate)];
    const Index first = column;
    for (Index k = 0; k < entry.columns.cols(); ++k, ++column) {
      S.col(column) = entry.columns.col(k);
      length_.push_back(S.col(column).norm());
      const int value = candidate.sizes[static_cast<std::size_t>(k)];
      const double unit = candidate.unit[static_cast<std::size_t>(value)];
      const double neutral = candidate.neutral.values[static_cast<std::size_t>(value)];
      lower_.push_back(std::max(-1., (candidate.lower[static_cast<std::size_t>(value)] - neutral) / unit));
      upper_.push_back(std::min(1., (candidate.upper[static_cast<std::size_t>(value)] - neutral) / unit));
    }
    for (const auto& choice : choicesOf(static_cast<int>(entry.columns.cols()))) {
      Variant variant{
          entry.candidate, entry.level, choice, {}, static_cast<int>(choice.size()) + (candidate.shape >= 0), {}};
      for (const int size : choice) variant.columns.push_back(static_cast<int>(first) + size);
      variants_.push_back(std::move(variant));
    }
  }
  const MatrixXd Q = spanOf(jacobian);
  S = without(Q, S);
  G_ = S.transpose() * S;
  b_ = S.transpose() * -without(Q, r);
  std::erase_if(variants_, [&](const Variant& variant) {
    return std::any_of(variant.columns.begin(), variant.columns.end(), [&](int c) {
      return !(std::sqrt(G_(c, c)) > kAbsorbed * length_[static_cast<std::size_t>(c)]);
    });
  });
  for (Variant& variant : variants_) variant.inverse = inverseOf(G_(variant.columns, variant.columns));
}

/// A hard bound (a gap below none) ends an effect; the plausible band may be passed by what noise explains.
bool ScoreSpace::isPhysical(int column, double size, double sigma) const {
  const auto c = static_cast<std::size_t>(column);
  const double slack = kBeyondBand * sigma;
  return !(lower_[c] == 0 && size < 0) && !(upper_[c] == 0 && size > 0) && size >= lower_[c] - slack &&
         size <= upper_[c] + slack;
}

Score ScoreSpace::solved(const std::vector<int>& columns, const MatrixXd& inverse, const VectorXd& b) const {
  Score score;
  if (inverse.size() == 0) {
    score.is_physical = false;
    return score;
  }
  const VectorXd right = b(columns);
  score.sizes = inverse * right;
  score.sigma = inverse.diagonal().cwiseSqrt();
  for (Index k = 0; k < right.size(); ++k) {
    if (!isPhysical(columns[static_cast<std::size_t>(k)], score.sizes[k], score.sigma[k])) score.is_physical = false;
  }
  if (score.is_physical) score.fall = right.dot(score.sizes);
  return score;
}

Score ScoreSpace::score(const std::vector<int>& variants) const {
  if (variants.size() == 1) {
    const Variant& only = variants_[static_cast<std::size_t>(variants.front())];
    return solved(only.columns, only.inverse, b_);
  }
  std::vector<int> columns;
  for (const int v : variants) {
    const auto& some = variants_[static_cast<std::size_t>(v)].columns;
    columns.insert(columns.end(), some.begin(), some.end());
  }
  return solved(columns, inverseOf(G_(columns, columns)), b_);
}

bool ScoreSpace::isOneSided(int variant) const {
  const Variant& v = variants_[static_cast<std::size_t>(variant)];
  const auto c = static_cast<std::size_t>(v.columns.front());
  return v.columns.size() == 1 && (lower_[c] == 0 || upper_[c] == 0);
}

double ScoreSpace::evidence(int variant, const Score& score) const {
  if (!score.is_physical || score.fall <= 0) return 0;
  const auto degrees = static_cast<double>(variants_[static_cast<std::size_t>(variant)].columns.size());
  return evidenceOf(score.fall, degrees, isOneSided(variant));
}

double ScoreSpace::keptFraction(int variant) const {
  const Variant& v = variants_[static_cast<std::size_t>(variant)];
  double best = 0;
  for (const int c : v.columns)
    if (length_[static_cast<std::size_t>(c)] > 0)
      best = std::max(best, std::sqrt(G_(c, c)) / length_[static_cast<std::size_t>(c)]);
  return best;
}

double ScoreSpace::visibility(int variant) const {
  const int c = variants_[static_cast<std::size_t>(variant)].columns.front();
  return std::sqrt(G_(c, c));
}

double ScoreSpace::correlation(int a, int b) const {
  const auto& A = variants_[static_cast<std::size_t>(a)].columns;
  const auto& B = variants_[static_cast<std::size_t>(b)].columns;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> left(MatrixXd(G_(A, A))), right(MatrixXd(G_(B, B)));
  const MatrixXd cross = left.operatorInverseSqrt() * G_(A, B) * right.operatorInverseSqrt();
  return std::min(1., cross.jacobiSvd().singularValues()[0]);
}

/// As score(), without a place for the sizes on the heap.
double ScoreSpace::fallAt(const Variant& variant, const VectorXd& b) const {
  const auto n = static_cast<Index>(variant.columns.size());
  if (variant.inverse.size() == 0) return 0;
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostColumns, 1> right(n), sizes(n);
  for (Index k = 0; k < n; ++k) right[k] = b[variant.columns[static_cast<std::size_t>(k)]];
  sizes.noalias() = variant.inverse * right;
  for (Index k = 0; k < n; ++k)
    if (!isPhysical(variant.columns[static_cast<std::size_t>(k)], sizes[k], std::sqrt(variant.inverse(k, k)))) return 0;
  return right.dot(sizes);
}

double ScoreSpace::mostEvidence(const VectorXd& b) const {
  // Within variants of as many columns, the largest fall is the largest evidence: only that one needs its tail.
  std::array<std::array<double, 2>, kMostColumns + 1> most{};
  for (std::size_t v = 0; v < variants_.size(); ++v) {
    double& fall = most[variants_[v].columns.size()][isOneSided(static_cast<int>(v))];
    fall = std::max(fall, fallAt(variants_[v], b));
  }
  double evidence = 0;
  for (std::size_t degrees = 1; degrees < most.size(); ++degrees)
    for (const bool one_sided : {false, true})
      if (most[degrees][one_sided] > 0)
        evidence = std::max(evidence, evidenceOf(most[degrees][one_sided], static_cast<double>(degrees), one_sided));
  return evidence;
}

std::vector<double> ScoreSpace::familyThresholds(const std::vector<double>& levels, int draws,
                                                 std::uint64_t seed) const {
  std::vector<double> thresholds(levels.size(), 0);
  if (variants_.empty()) return thresholds;
  const Index n = G_.rows();
  // A ridge far below anything that counts makes the root of a singular G by Cholesky.
  MatrixXd root = G_;
  root.diagonal().array() += kRidge * G_.diagonal().maxCoeff();
  const Eigen::LLT<MatrixXd> factor(root);
  boost::random::mt19937_64 random(seed);
  boost::random::normal_distribution<double> normal;
  MatrixXd noise(n, draws);
  for (double& value : noise.reshaped()) value = normal(random);
  const MatrixXd b = factor.matrixL() * noise;
  std::vector<double> best(static_cast<std::size_t>(draws));
  tbb::parallel_for(0, draws,
                    [&](int k) { best[static_cast<std::size_t>(k)] = mostEvidence(b.col(static_cast<Index>(k))); });
  std::sort(best.begin(), best.end());
  for (std::size_t k = 0; k < levels.size(); ++k)
    thresholds[k] = best[std::min(best.size() - 1, static_cast<std::size_t>((1 - levels[k]) * draws))];
  return thresholds;
}

}  // namespace tubeplan::calibration
