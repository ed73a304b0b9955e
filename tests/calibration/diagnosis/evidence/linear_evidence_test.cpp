// The evidence computed from inner products of columns must equal the evidence by definition, computed from explicit
// covariances with their determinants and inverses.
#include "calibration/diagnosis/evidence/linear_evidence.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>
#include <random>

namespace tubeplan::calibration {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd drawn(std::mt19937_64& random, Index rows, Index columns) {
  MatrixXd matrix(rows, columns);
  for (double& value : matrix.reshaped()) value = 2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1;
  return matrix;
}

/// Measurements, columns and priors, with all results of the evidence computed by definition.
struct KnownMeasurements {
  MatrixXd J, S, Z;
  VectorXd y;
  std::vector<Unknown> fitted;
  EvidenceOptions options;

  explicit KnownMeasurements(std::uint64_t seed, Index rows = 20) {
    std::mt19937_64 random(seed);
    J = drawn(random, rows, 3), S = drawn(random, rows, 3), Z = drawn(random, rows, 4);
    y = 3 * drawn(random, rows, 1) + 2 * S.col(0);
    for (int k = 0; k < 3; ++k) {
      Unknown unknown;
      unknown.typical = 0.1 * (k + 1);
      unknown.prior_sigma = 0.5 + 0.3 * k;
      unknown.prior_mean = 0.2 * k - 0.1;
      fitted.push_back(unknown);
    }
    options.discrepancies = {0.4, 1.7};
    options.discrepancy_prior = 0.2;
    options.source_prior = 0.05;
    options.noise_scales = {1, 1.4};
    options.noise_rows = 9;
  }

  [[nodiscard]] EvidenceGram gram() const {
    EvidenceGram gram;
    gram.log_density = -4.5;
    gram.add(J, S, Z, y);
    return gram;
  }
  [[nodiscard]] LinearEvidence evidence() const { return {gram(), fitted, options}; }

  /// Returns the covariance of the noise, the fitted parameters, and a discrepancy of the given size.
  [[nodiscard]] MatrixXd covariance(double size) const {
    MatrixXd C = MatrixXd::Identity(y.size(), y.size()) + size * size * Z * Z.transpose();
    for (Index k = 0; k < J.cols(); ++k)
      C += std::pow(fitted[static_cast<std::size_t>(k)].prior_sigma, 2) * J.col(k) * J.col(k).transpose();
    return C;
  }
  [[nodiscard]] VectorXd missed() const {
    VectorXd residual = y;
    for (Index k = 0; k < J.cols(); ++k) residual -= fitted[static_cast<std::size_t>(k)].prior_mean * J.col(k);
    return residual;
  }
  [[nodiscard]] MatrixXd columnsOf(const std::vector<PriorSize>& causes) const {
    MatrixXd columns(y.size(), static_cast<Index>(causes.size()));
    for (std::size_t k = 0; k < causes.size(); ++k) columns.col(static_cast<Index>(k)) = S.col(causes[k].column);
    return columns;
  }

  struct Sizes {
    VectorXd best, sigma;
  };
  [[nodiscard]] Sizes sizesOf(const std::vector<PriorSize>& causes, double size) const {
    const MatrixXd columns = columnsOf(causes), inverse = covariance(size).inverse();
    MatrixXd information = columns.transpose() * inverse * columns;
    for (std::size_t k = 0; k < causes.size(); ++k)
      information(static_cast<Index>(k), static_cast<Index>(k)) += 1 / (causes[k].sigma * causes[k].sigma);
    const MatrixXd of_sizes = information.inverse();
    return {of_sizes * columns.transpose() * inverse * missed(), of_sizes.diagonal().cwiseSqrt()};
  }

  /// Returns the log evidence for a discrepancy of the given size and noise `scale` times the stated noise.
  [[nodiscard]] double logOf(const std::vector<PriorSize>& causes, double size, double scale) const {
    MatrixXd C = covariance(size);
    for (const auto& cause : causes)
      C += cause.sigma * cause.sigma * S.col(cause.column) * S.col(cause.column).transpose();
    const auto tried = static_cast<double>(options.discrepancies.size());
    double log = -4.5 - std::log(C.determinant()) / 2 - missed().dot(C.inverse() * missed()) / (2 * scale * scale);
    log += size == 0 ? std::log(1 - options.discrepancy_prior - options.source_prior)
                     : std::log(options.discrepancy_prior / tried);
    const Sizes sizes = sizesOf(causes, size);
    for (std::size_t k = 0; k < causes.size(); ++k)
      if (causes[k].sign != 0) {
        const auto x = static_cast<long double>(causes[k].sign * sizes.best[static_cast<Index>(k)] /
                                                sizes.sigma[static_cast<Index>(k)]);
        log += static_cast<double>(std::log(std::erfc(-x / std::numbers::sqrt2_v<long double>)));  // 2 Phi(x)
      }
    return log - options.noise_rows * std::log(scale) - std::log(static_cast<double>(options.noise_scales.size()));
  }
};

const std::vector<std::vector<PriorSize>> kHypotheses{
    {}, {{0, 1.5, 0}}, {{1, 0.7, 1}}, {{1, 0.7, -1}}, {{2, 0.3, 0}, {0, 2, 1}}, {{0, 1, -1}, {1, 2, 0}, {2, 0.5, 1}}};

TEST(LinearEvidence, IsTheDensityOfTheMeasurementsOverAllThatIsNotKnown) {
  for (std::uint64_t seed : {1, 2, 3})
    for (const auto& causes : kHypotheses) {
      const KnownMeasurements measurements(seed);
      const Evidence found = measurements.evidence().of(causes);
      double all = 0, none = 0, most = -1e300, most_of_none = most, size_of_most = -1, scale_of_most = 0,
             none_scale = 0;
      std::size_t level_of_most = 0;
      const std::vector<double> sizes{0, 0.4, 1.7};
      for (std::size_t level = 0; level < sizes.size(); ++level)
        for (const double scale : measurements.options.noise_scales) {
          const double log = measurements.logOf(causes, sizes[level], scale);
          all += std::exp(log);
          if (level == 0) none += std::exp(log);
          if (level == 0 && log > most_of_none) most_of_none = log, none_scale = scale;
          if (log > most) most = log, size_of_most = sizes[level], scale_of_most = scale, level_of_most = level;
        }
      EXPECT_NEAR(found.log, std::log(all), 1e-9);
      EXPECT_NEAR(found.log_none, std::log(none), 1e-9);
      EXPECT_NEAR(found.discrepancy_probability, 1 - none / all, 1e-9);
      EXPECT_EQ(found.discrepancy, size_of_most);
      EXPECT_EQ(found.level, level_of_most);
      EXPECT_EQ(found.noise_scale, scale_of_most);
      EXPECT_EQ(found.none_scale, none_scale);
      const auto expected = measurements.sizesOf(causes, size_of_most);
      ASSERT_EQ(found.sizes.size(), static_cast<Index>(causes.size()));
      EXPECT_TRUE(found.sizes.isApprox(expected.best, 1e-9));
      EXPECT_TRUE(found.sigma.isApprox(expected.sigma, 1e-9));
    }
}

TEST(LinearEvidence, AtOneSizeCountsThatOneAndNoneAlone) {
  const KnownMeasurements measurements(4);
  for (const auto& causes : kHypotheses) {
    double none = 0, with = 0;
    for (const double scale : measurements.options.noise_scales) {
      none += std::exp(measurements.logOf(causes, 0, scale));
      with += std::exp(measurements.logOf(causes, 1.7, scale));
    }
    EXPECT_NEAR(measurements.evidence().of(causes, 2).log, std::log(none + with), 1e-9);
    EXPECT_NEAR(measurements.evidence().of(causes, 0).log, std::log(none), 1e-9);
  }
}

/// If the options list no sizes of a discrepancy and no noise scales, the evidence must be that of the stated noise
/// without a discrepancy.
TEST(LinearEvidence, HasNoDiscrepancyWhereNoSizeIsTried) {
  KnownMeasurements measurements(5);
  measurements.options = {};
  const Evidence found = measurements.evidence().of(kHypotheses[1]);
  measurements.options.noise_scales = {1};
  EXPECT_NEAR(found.log, measurements.logOf(kHypotheses[1], 0, 1) - std::log(0.9), 1e-9);  // prior of no discrepancy
  EXPECT_EQ(found.discrepancy_probability, 0);
  EXPECT_EQ(found.discrepancy, 0);
  EXPECT_EQ(found.noise_scale, 1);
}

/// If a required sign contradicts the measurements by many standard deviations, the log evidence must fall by the log
/// of the normal tail probability, even where that probability underflows.
TEST(LinearEvidence, ASignAgainstAllMeasurementsCostsItsTail) {
  for (const double far : {5., 20., 29., 31., 60.}) {
    KnownMeasurements measurements(6);
    measurements.options = {};
    const PriorSize plus{0, 1e3, 1}, any{0, 1e3, 0};
    const auto sizes = measurements.sizesOf({any}, 0);
    measurements.y -= (sizes.best[0] + far * sizes.sigma[0]) * measurements.S.col(0);
    const double x = measurements.sizesOf({any}, 0).best[0] / measurements.sizesOf({any}, 0).sigma[0];
    ASSERT_NEAR(x, -far, 1e-3 * far);
    const double tail = std::log(std::numbers::inv_sqrtpi / std::numbers::sqrt2 / far) - x * x / 2 -
                        std::log1p(1 / (far * far));  // accurate to a relative error of far^-4
    EXPECT_NEAR(measurements.evidence().of({plus}).log - measurements.evidence().of({any}).log,
                std::numbers::ln2 + tail, 5 / std::pow(far, 2));
  }
}

/// The difference in log evidence between two hypotheses must be the same for flat and for very wide priors of the
/// fitted parameters.
TEST(LinearEvidence, NeedsNoPriorOfFittedNumbers) {
  KnownMeasurements flat(7), wide(7);
  for (auto& unknown : flat.fitted)
    unknown.prior_sigma = std::numeric_limits<double>::infinity(), unknown.prior_mean = 0;
  for (auto& unknown : wide.fitted) unknown.prior_sigma = 1e4, unknown.prior_mean = 0;
  for (const auto& causes : kHypotheses)
    EXPECT_NEAR(flat.evidence().of(causes).log - flat.evidence().of({}).log,
                wide.evidence().of(causes).log - wide.evidence().of({}).log, 1e-6);
}

TEST(LinearEvidence, AColumnIsSeenByWhatFittedNumbersLeaveOfIt) {
  KnownMeasurements measurements(8);
  const MatrixXd inverse = measurements.covariance(0).inverse();
  for (int c = 0; c < 3; ++c) {
    const double visible = std::sqrt(measurements.S.col(c).dot(inverse * measurements.S.col(c)));
    EXPECT_NEAR(measurements.evidence().visibility(c), visible, 1e-9);
    EXPECT_NEAR(measurements.evidence().keptShare(c), visible / measurements.S.col(c).norm(), 1e-9);
  }
  for (auto& unknown : measurements.fitted) unknown.prior_sigma = std::numeric_limits<double>::infinity();
  measurements.S.col(1) = measurements.J * Eigen::Vector3d(1, -2, 0.5);
  measurements.S.col(2).setZero();
  const LinearEvidence evidence = measurements.evidence();
  EXPECT_GT(evidence.visibility(0), 0.5);
  for (int c : {1, 2}) {
    EXPECT_EQ(evidence.visibility(c), 0);
    EXPECT_EQ(evidence.keptShare(c), 0);
    EXPECT_NEAR(evidence.of({{c, 1, 0}}).log, evidence.of({}).log, 1e-9);
  }
}

TEST(LinearEvidence, TheDiscrepancysErrorsAreItsMostProbable) {
  const KnownMeasurements measurements(9);
  const LinearEvidence evidence = measurements.evidence();
  for (const auto& causes : kHypotheses)
    for (const double size : {0.4, 0.9, 1.7}) {  // 0.9 is not among the tried sizes
      const VectorXd residual =
          measurements.missed() - measurements.columnsOf(causes) * measurements.sizesOf(causes, size).best;
      const VectorXd expected = size * size * measurements.Z * measurements.Z.transpose() *
                                measurements.covariance(size).inverse() * residual;
      const VectorXd found = measurements.Z * evidence.discrepancyWeights(causes, size);
      EXPECT_TRUE(found.isApprox(expected, 1e-9)) << found.transpose() << "\n" << expected.transpose();
    }
  EXPECT_TRUE(evidence.discrepancyWeights({}, 0).isZero(0));
  KnownMeasurements without(9);
  without.Z.setZero();
  EXPECT_TRUE(without.evidence().discrepancyWeights({}, 0.4).isZero(0));
}

TEST(LinearEvidence, TheRichestFitTakesTheLargestSize) {
  const KnownMeasurements measurements(10);
  const MatrixXd with = measurements.covariance(1.7).inverse(), without = measurements.covariance(0).inverse();
  const RichestFit found = measurements.evidence().richest();
  EXPECT_NEAR(measurements.evidence().chi2(), measurements.missed().dot(without * measurements.missed()), 1e-9);
  EXPECT_NEAR(found.chi2, measurements.missed().dot(with * measurements.missed()), 1e-9);
  EXPECT_NEAR(found.numbers, (1.7 * 1.7 * measurements.Z.transpose() * with * measurements.Z).trace(), 1e-9);
  KnownMeasurements plain(10);
  plain.options.discrepancies.clear();
  EXPECT_NEAR(plain.evidence().richest().chi2, plain.evidence().chi2(), 1e-12);
  EXPECT_EQ(plain.evidence().richest().numbers, 0);
}

TEST(LinearEvidence, PrincipalTermsAreSquareToOneAnotherAndStandForAll) {
  KnownMeasurements measurements(11);
  const MatrixXd K = measurements.Z.transpose() * measurements.covariance(0).inverse() * measurements.Z;
  const MatrixXd terms = measurements.evidence().principalTerms(100);
  ASSERT_EQ(terms.cols(), 4);
  EXPECT_TRUE((terms * terms.transpose()).isIdentity(1e-9));
  const MatrixXd products = terms.transpose() * K * terms;
  EXPECT_TRUE(products.isDiagonal(1e-9));
  for (Index k = 1; k < 4; ++k) EXPECT_LE(products(k, k), products(k - 1, k - 1));
  EXPECT_TRUE(measurements.evidence().principalTerms(2).isApprox(terms.leftCols(2), 1e-12));
}

/// Redundant terms and zero terms must not change the evidence. If there are too many terms, the largest must be kept.
TEST(LinearEvidence, TermsOfTheDiscrepancyMayBeAlike) {
  KnownMeasurements measurements(12), alike(12);
  alike.Z.resize(20, 40);
  std::mt19937_64 random(12);
  // Because W^T W = I, the forty terms have the covariance of the original four.
  const MatrixXd W = Eigen::HouseholderQR<MatrixXd>(drawn(random, 40, 4)).householderQ() * MatrixXd::Identity(40, 4);
  alike.Z = measurements.Z * W.transpose();
  EXPECT_EQ(alike.evidence().principalTerms(100).cols(), 4);
  for (const auto& causes : kHypotheses)
    EXPECT_NEAR(alike.evidence().of(causes).log, measurements.evidence().of(causes).log, 1e-7);
  KnownMeasurements none(12);
  none.Z.setZero();
  EXPECT_EQ(none.evidence().principalTerms(100).cols(), 0);
  EXPECT_EQ(none.evidence().of({}).discrepancy_probability, 0);
  KnownMeasurements many(13, 200);
  many.Z = drawn(random, 200, 150);
  EXPECT_EQ(many.evidence().principalTerms(1000).cols(), 120);
  // Only small terms may be omitted: a last column with a hundredth of the variance must be kept, one with a millionth
  // must not.
  KnownMeasurements small(14);
  small.Z.col(3) *= 0.1;
  EXPECT_EQ(small.evidence().principalTerms(100).cols(), 4);
  small.Z.col(3) *= 0.01;
  EXPECT_EQ(small.evidence().principalTerms(100).cols(), 3);
}

TEST(LinearEvidence, TermsOfTheDiscrepancyMayHaveAnyUnit) {
  const KnownMeasurements measurements(15);
  for (const double unit : {1e-5, 1e5}) {
    KnownMeasurements scaled(15);
    scaled.Z *= unit;
    for (double& size : scaled.options.discrepancies) size /= unit;
    EXPECT_EQ(scaled.evidence().principalTerms(100).cols(), 4);
    for (const auto& causes : kHypotheses)
      EXPECT_NEAR(scaled.evidence().of(causes).log, measurements.evidence().of(causes).log, 1e-9);
  }
}

TEST(LinearEvidence, ColumnsTakeWhatTheyHaveOfTheResidualAndNoneTakesNothing) {
  MatrixXd S(4, 2);
  S << 1, 0, 1, 0, 0, 2, 0, 0;
  const Eigen::Vector4d y(3, 1, 4, 5);  // the columns explain 8 and 16 of a chi-square of 51
  EvidenceGram gram;
  gram.add(MatrixXd(4, 0), S, MatrixXd(4, 0), y);
  const LinearEvidence evidence(gram, {}, {});
  EXPECT_NEAR(evidence.chi2(), 51, 1e-9);
  EXPECT_EQ(evidence.fall({}), 0);
  EXPECT_NEAR(evidence.fall({0}), 8, 1e-9);
  EXPECT_NEAR(evidence.fall({0, 1}), 24, 1e-9);
  EXPECT_NEAR(evidence.fall({1, 1}), 16, 1e-9);
}

TEST(EvidenceGram, AddsUpMeasurementsInAnyNumberOfParts) {
  std::mt19937_64 random(15);
  const MatrixXd J = drawn(random, 9001, 2), S = drawn(random, 9001, 90), Z = drawn(random, 9001, 50);
  const VectorXd y = drawn(random, 9001, 1);
  MatrixXd all(9001, 143);
  all << J, S, Z, y;
  const MatrixXd expected = all.transpose() * all;
  EvidenceGram once, parts;
  once.add(J, S, Z, y);
  for (const auto& [first, rows] : {std::pair<Index, Index>{0, 1}, {1, 0}, {1, 4097}, {4098, 4903}})
    parts.add(J.middleRows(first, rows), S.middleRows(first, rows), Z.middleRows(first, rows), y.segment(first, rows));
  for (const EvidenceGram& gram : {once, parts}) {
    EXPECT_EQ(gram.fitted, 2);
    EXPECT_EQ(gram.causes, 90);
    EXPECT_EQ(gram.discrepancy, 50);
    EXPECT_TRUE(MatrixXd(gram.products.selfadjointView<Eigen::Lower>()).isApprox(expected, 1e-12));
  }
}

TEST(LogSum, AddsWhatMayBeNothing) {
  const double nothing = -std::numeric_limits<double>::infinity();
  EXPECT_NEAR(logSum(std::log(2), std::log(3)), std::log(5), 1e-15);
  EXPECT_NEAR(logSum(std::log(3), std::log(2)), std::log(5), 1e-15);
  EXPECT_EQ(logSum(nothing, 1), 1);
  EXPECT_EQ(logSum(nothing, nothing), nothing);
  EXPECT_EQ(logSum(-1000, 0), 0);
}

}  // namespace
}  // namespace tubeplan::calibration
