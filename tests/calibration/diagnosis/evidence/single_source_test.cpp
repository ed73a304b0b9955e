// The evidence of a model with one source, relative to the model without it, must equal the ratio of the corresponding
// normal densities.
#include "calibration/diagnosis/evidence/single_source.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>
#include <random>

namespace tubeplan::calibration {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd drawn(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

double logDensity(const VectorXd& y, const MatrixXd& C) {
  const Eigen::LLT<MatrixXd> factor(C);
  const VectorXd diagonal = MatrixXd(factor.matrixL()).diagonal();
  return -y.dot(factor.solve(y)) / 2 - diagonal.array().log().sum() -
         0.5 * static_cast<double>(y.size()) * std::log(2 * std::numbers::pi);
}

struct Example {
  MatrixXd Z = drawn(40, 7, 1), W = drawn(40, 3, 2);
  VectorXd y = drawn(40, 1, 3), scale = VectorXd::Constant(3, 2.), information = VectorXd::Constant(3, 0.5);
  std::vector<std::vector<int>> sources{{0, 1, 4}, {2, 3}, {5, 6}};
  std::vector<double> shares{0.1, 0.2, 0.05, 0.15, 0.1, 0.3, 0.1};

  [[nodiscard]] SourceEvidence evidenceWithSource(const std::vector<double>& sizes, double noise_scale) const {
    MatrixXd W_y(40, 4);
    W_y << W, y;
    const SingleSources single(Z, sources, shares);
    return single.evidenceWithSource(single.viewOf(W_y), scale, information, sizes, noise_scale);
  }
};

TEST(SingleSources, HaveTheEvidenceOfTheirNormalDensities) {
  const Example e;
  const std::vector<double> sizes{0.3, 1, 2};
  for (const double noise : {1., 1.4}) {
    const MatrixXd numbers = e.W * e.scale.asDiagonal();
    const MatrixXd C =
        MatrixXd::Identity(40, 40) + numbers * e.information.cwiseInverse().asDiagonal() * numbers.transpose();
    double factors = 0;
    for (const auto& terms : e.sources) {
      double share = 0;
      for (const int term : terms) share += e.shares[static_cast<std::size_t>(term)];
      const MatrixXd own = e.Z(Eigen::all, terms) / std::sqrt(share);
      for (const double size : sizes)
        factors += std::exp(logDensity(e.y, noise * noise * (C + size * size * own * own.transpose())) -
                            logDensity(e.y, noise * noise * C));
    }
    EXPECT_NEAR(e.evidenceWithSource(sizes, noise).log_factor, std::log(factors / 9), 1e-9);
  }
}

TEST(SingleSources, FindTheOneThatErrs) {
  Example e;
  const VectorXd error = e.Z(Eigen::all, e.sources[1]) * Eigen::Vector2d(8, -5);
  e.y += error;
  const auto found = e.evidenceWithSource({0.5, 2, 8, 32}, 1);
  EXPECT_EQ(found.source, 1);
  EXPECT_GT(found.log_factor, 50);
  EXPECT_LT((SingleSources(e.Z, e.sources, e.shares).errorsOf(1, found.weights) - error).norm(), 0.1 * error.norm());
}

}  // namespace
}  // namespace tubeplan::calibration
