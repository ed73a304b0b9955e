#include "calibration/estimation/identifiability.hpp"

#include <algorithm>
#include <cmath>

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

// A parameter is identifiable only if its sigma is at most this fraction of its prior uncertainty.
constexpr double kSharpened = 0.5;
constexpr double kCorrelated = 0.3;  // correlation above which another parameter is reported as a partner
// Correlation above which a parameter is identifiable only together with its partner.
constexpr double kOneWithIt = 0.95;
constexpr std::size_t kMostPartners = 4;
// A compliance is identifiable only if it differs from zero by more than this many sigmas; otherwise, the stiffness
// would have no upper bound.
constexpr double kSeen = 2;

/// Returns the prior uncertainty of a parameter, which is the smaller of its typical size and its prior sigma.
double yardstickOf(const Unknown& unknown) { return std::min(unknown.typical, unknown.prior_sigma); }

bool isSharp(const Unknown& unknown, double sigma, double x) {
  if (!(sigma <= kSharpened * yardstickOf(unknown))) return false;
  return unknown.scale == Unknown::Scale::kLinear || kSeen * sigma < 1 / valueAt(unknown, x);
}

std::vector<int> partnersOf(Index k, const MatrixXd& covariance) {
  const auto correlation = [&](Index other) {
    return std::abs(covariance(k, other)) / std::sqrt(covariance(k, k) * covariance(other, other));
  };
  std::vector<int> partners;
  for (Index other = 0; other < covariance.rows(); ++other)
    if (other != k && correlation(other) > kCorrelated) partners.push_back(static_cast<int>(other));
  std::ranges::stable_sort(partners, [&](int a, int b) { return correlation(a) > correlation(b); });
  if (partners.size() > kMostPartners) partners.resize(kMostPartners);
  return partners;
}

}  // namespace

std::vector<NumberIdentifiability> judgeIdentifiability(const MatrixXd& jacobian, const MatrixXd& covariance,
                                                        const std::vector<Unknown>& unknowns, const VectorXd& at) {
  std::vector<NumberIdentifiability> numbers(unknowns.size());
  for (std::size_t n = 0; n < unknowns.size(); ++n) {
    const auto k = static_cast<Index>(n);
    const Unknown& unknown = unknowns[n];
    if (isSharp(unknown, std::sqrt(covariance(k, k)), at[k])) {
      numbers[n].verdict = Identifiability::kYes;
      continue;
    }
    const double alone = 1 / std::sqrt(jacobian.col(k).squaredNorm() + 1 / (unknown.prior_sigma * unknown.prior_sigma));
    if (!isSharp(unknown, alone, at[k])) continue;
    numbers[n].with = partnersOf(k, covariance);
    if (!numbers[n].with.empty()) numbers[n].verdict = Identifiability::kInCombination;
  }
  // A parameter is not identifiable if the measurements cannot distinguish it from another parameter that is not
  // identifiable.
  for (std::size_t n = 0; n < unknowns.size(); ++n) {
    if (numbers[n].verdict != Identifiability::kYes) continue;
    const auto k = static_cast<Index>(n);
    std::vector<int> partners = partnersOf(k, covariance);
    std::erase_if(partners, [&](int other) {
      return std::abs(covariance(k, other)) < kOneWithIt * std::sqrt(covariance(k, k) * covariance(other, other)) ||
             isSharp(unknowns[static_cast<std::size_t>(other)], std::sqrt(covariance(other, other)), at[other]);
    });
    if (!partners.empty()) numbers[n] = {Identifiability::kInCombination, std::move(partners)};
  }
  return numbers;
}

}  // namespace tubeplan::calibration
