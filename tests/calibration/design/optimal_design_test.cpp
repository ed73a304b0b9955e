// Choice of the most informative measurements, tested on random linear problems.
#include "calibration/design/optimal_design.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>
#include <set>

namespace tubeplan::calibration {
namespace {

using Eigen::MatrixXd;

MatrixXd randomMatrix(int rows, int columns, std::mt19937_64& random) {
  std::normal_distribution<double> normal(0, 1);
  MatrixXd m(rows, columns);
  for (double& x : m.reshaped()) x = normal(random);
  return m;
}

/// Returns a random problem with six variables; each candidate gives much information on two of them and little on the
/// others.
DesignProblem randomProblem(int candidates, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  DesignProblem problem;
  problem.information = MatrixXd::Identity(6, 6);
  for (int k = 0; k < candidates; ++k) {
    MatrixXd H = 0.3 * randomMatrix(3, 6, random);
    H.middleCols(2 * (k % 3), 2) *= 20;
    problem.candidates.push_back(H);
  }
  for (int w = 0; w < 12; ++w) problem.work.push_back(0.01 * randomMatrix(3, 6, random));
  return problem;
}

MatrixXd covarianceOf(const DesignProblem& problem, const std::vector<int>& chosen) {
  MatrixXd information = problem.information;
  for (const int k : chosen) {
    const auto& H = problem.candidates[static_cast<std::size_t>(k)];
    information += H.transpose() * H;
  }
  return information.inverse();
}

std::vector<int> chosenOf(const Design& design) {
  std::vector<int> chosen;
  for (const auto& step : design.steps) chosen.push_back(step.candidate);
  return chosen;
}

double logDeterminant(const MatrixXd& covariance) { return std::log(covariance.determinant()); }

double worstOf(const DesignProblem& problem, const MatrixXd& covariance) {
  double worst = 0;
  for (const auto& J : problem.work) worst = std::max(worst, (J * covariance * J.transpose()).trace() / 3);
  return std::sqrt(worst);
}

DesignOptions optionsFor(Optimality optimality, int count) {
  DesignOptions options;
  options.optimality = optimality;
  options.count = count;
  return options;
}

class OptimalDesign : public ::testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Seeds, OptimalDesign, ::testing::Range<std::uint64_t>(1, 9));

TEST_P(OptimalDesign, FiguresAreThoseOfThePlainInverse) {
  const auto problem = randomProblem(40, GetParam());
  const auto design = chooseMeasurements(problem, optionsFor(Optimality::kDeterminant, 5));
  ASSERT_EQ(design.status, DesignStatus::kDone);
  const auto chosen = chosenOf(design);
  EXPECT_EQ(std::set<int>(chosen.begin(), chosen.end()).size(), 5u);
  EXPECT_LT((design.covariance - covarianceOf(problem, chosen)).norm(), 1e-9 * design.covariance.norm());
  std::vector<int> before;
  for (const auto& step : design.steps) {
    auto after = before;
    after.push_back(step.candidate);
    const MatrixXd C0 = covarianceOf(problem, before), C1 = covarianceOf(problem, after);
    EXPECT_NEAR(step.bits, (logDeterminant(C0) - logDeterminant(C1)) / 2 / std::log(2.), 1e-8);
    EXPECT_NEAR(step.tip.worst, worstOf(problem, C1), 1e-12);
    EXPECT_NEAR(step.helped_by, std::sqrt((C1.diagonal().array() / C0.diagonal().array()).minCoeff()), 1e-9);
    before = after;
  }
}

TEST_P(OptimalDesign, BeatsRandomChoices) {
  const auto problem = randomProblem(60, GetParam());
  const auto by_determinant = chooseMeasurements(problem, optionsFor(Optimality::kDeterminant, 6));
  const auto by_worst = chooseMeasurements(problem, optionsFor(Optimality::kWorstTip, 6));
  const auto by_mean = chooseMeasurements(problem, optionsFor(Optimality::kMeanTip, 6));
  for (const auto& choice : drawChoices(60, 6, 200, GetParam())) {
    const MatrixXd random = covarianceOf(problem, choice);
    EXPECT_LT(logDeterminant(by_determinant.covariance), logDeterminant(random));
    EXPECT_LT(worstOf(problem, by_worst.covariance), worstOf(problem, random));
    EXPECT_LT(tipSigma(problem.work, by_mean.covariance).rms, tipSigma(problem.work, random).rms);
  }
}

// The criterion of the chosen three measurements must be within 1 % of the best, which is found by trying all 364
// triples of 14.
TEST_P(OptimalDesign, ExchangeComesWithinAPercentOfTheBestTriple) {
  const auto problem = randomProblem(14, GetParam());
  double best_determinant = 1e300, best_mean = 1e300;
  for (int i = 0; i < 14; ++i)
    for (int j = i + 1; j < 14; ++j)
      for (int k = j + 1; k < 14; ++k) {
        const MatrixXd covariance = covarianceOf(problem, {i, j, k});
        best_determinant = std::min(best_determinant, logDeterminant(covariance));
        best_mean = std::min(best_mean, tipSigma(problem.work, covariance).rms);
      }
  const auto in_all = chooseMeasurements(problem, optionsFor(Optimality::kDeterminant, 3));
  const auto at_tip = chooseMeasurements(problem, optionsFor(Optimality::kMeanTip, 3));
  EXPECT_LE(logDeterminant(in_all.covariance), best_determinant + 0.01 * std::abs(best_determinant));
  EXPECT_LE(tipSigma(problem.work, at_tip.covariance).rms, 1.01 * best_mean);
}

TEST_P(OptimalDesign, ExchangeNeverMakesTheChoiceWorse) {
  const auto problem = randomProblem(40, GetParam());
  for (const auto optimality : {Optimality::kDeterminant, Optimality::kWorstTip, Optimality::kMeanTip}) {
    auto options = optionsFor(optimality, 5);
    const auto exchanged = chooseMeasurements(problem, options);
    options.most_passes = 0;
    const auto greedy = chooseMeasurements(problem, options);
    const auto score = [&](const Design& design) {
      if (optimality == Optimality::kDeterminant) return logDeterminant(design.covariance);
      const TipSigma tip = tipSigma(problem.work, design.covariance);
      return optimality == Optimality::kWorstTip ? tip.worst : tip.rms;
    };
    EXPECT_LE(score(exchanged), score(greedy) + 1e-12);
    EXPECT_EQ(greedy.swaps, 0);
  }
}

TEST_P(OptimalDesign, TheWorstPlaceIsKnownBetterByEachMeasurement) {
  const auto problem = randomProblem(40, GetParam());
  const auto by_worst = chooseMeasurements(problem, optionsFor(Optimality::kWorstTip, 8));
  double before = tipSigma(problem.work, problem.information.inverse()).worst;
  for (const auto& step : by_worst.steps) {
    EXPECT_LT(step.tip.worst, before);
    before = step.tip.worst;
  }
  double fewer = 1e300;
  for (int count = 1; count <= 8; ++count) {
    const double now =
        tipSigma(problem.work, chooseMeasurements(problem, optionsFor(Optimality::kWorstTip, count)).covariance).worst;
    EXPECT_LT(now, fewer);
    fewer = now;
  }
  const auto by_determinant = chooseMeasurements(problem, optionsFor(Optimality::kDeterminant, 8));
  EXPECT_LE(by_worst.steps.back().tip.worst, by_determinant.steps.back().tip.worst);
}

TEST(OptimalDesign, TooFewCandidatesAreTold) {
  const auto problem = randomProblem(4, 1);
  const auto design = chooseMeasurements(problem, optionsFor(Optimality::kDeterminant, 5));
  EXPECT_EQ(design.status, DesignStatus::kTooFewCandidates);
  EXPECT_NE(design.reason.find("4 readings"), std::string::npos) << design.reason;
  EXPECT_TRUE(design.steps.empty());
}

TEST(OptimalDesign, DrawsAreDifferentMeasurementsAndTheSameForTheSameSeed) {
  const auto choices = drawChoices(9, 4, 50, 3);
  ASSERT_EQ(choices.size(), 50u);
  std::set<int> seen;
  for (const auto& choice : choices) {
    EXPECT_EQ(std::set<int>(choice.begin(), choice.end()).size(), 4u);
    for (const int k : choice) EXPECT_TRUE(k >= 0 && k < 9);
    seen.insert(choice.begin(), choice.end());
  }
  EXPECT_EQ(seen.size(), 9u);
  EXPECT_EQ(choices, drawChoices(9, 4, 50, 3));
  EXPECT_NE(choices, drawChoices(9, 4, 50, 4));
}

}  // namespace
}  // namespace tubeplan::calibration
