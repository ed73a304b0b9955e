// Tests of the stepped tool: the number of steps that enter, and its probabilities against closed forms and sampling.
#include "tubesheets/stepped_tool.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <string>

#include "tests/tubesheets/example_sheets.hpp"

namespace tubeplan::tubesheets {
namespace {

constexpr double kMetresInAnInch = 0.0254;
constexpr double kHole = 0.760 * kMetresInAnInch;

/// Returns the stepped tool of Calkins 1994, table 5.7.
SteppedTool thesisTool() {
  return {{{0.582 * kMetresInAnInch, 0.089 * kMetresInAnInch},
           {0.644 * kMetresInAnInch, 0.058 * kMetresInAnInch},
           {0.740 * kMetresInAnInch, 0.010 * kMetresInAnInch}},
          {0.5 * kMetresInAnInch, 0.5 * kMetresInAnInch, 0.5 * kMetresInAnInch}};
}

Eigen::Matrix2d covarianceOf(double sigma_1, double sigma_2, double angle) {
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(angle).toRotationMatrix();
  return R * Eigen::Vector2d(sigma_1 * sigma_1, sigma_2 * sigma_2).asDiagonal() * R.transpose();
}

TEST(StepsInserted, FollowsTable57) {
  const SteppedTool tool = thesisTool();
  EXPECT_EQ(stepsInserted(tool, 0), 3);
  EXPECT_EQ(stepsInserted(tool, 0.010 * kMetresInAnInch), 3);
  EXPECT_EQ(stepsInserted(tool, 0.0101 * kMetresInAnInch), 2);
  EXPECT_EQ(stepsInserted(tool, 0.058 * kMetresInAnInch), 2);
  EXPECT_EQ(stepsInserted(tool, 0.0581 * kMetresInAnInch), 1);
  EXPECT_EQ(stepsInserted(tool, 0.089 * kMetresInAnInch), 1);
  EXPECT_EQ(stepsInserted(tool, 0.0891 * kMetresInAnInch), 0);
  EXPECT_EQ(stepsInserted(tool, kNan), 0);
  EXPECT_EQ(stepsInserted(tool, std::numeric_limits<double>::infinity()), 0);
}

TEST(PlayInTube, IsAStepsToleranceLessHowFarItIsOff) {
  const SteppedTool tool = thesisTool();
  const Eigen::Vector2d off(0.003 * kMetresInAnInch, 0.004 * kMetresInAnInch), upright(0, 0);
  EXPECT_EQ(playInTube(tool, off, upright, 0), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(playInTube(tool, off, upright, 0.3 * kMetresInAnInch), 0.084 * kMetresInAnInch, 1e-15);
  EXPECT_NEAR(playInTube(tool, off, upright, 0.5 * kMetresInAnInch + 1e-9), 0.084 * kMetresInAnInch,
              1e-15);  // 1 nm past the first step, the next step has not entered
  EXPECT_NEAR(playInTube(tool, off, upright, 0.6 * kMetresInAnInch), 0.053 * kMetresInAnInch, 1e-15);
  EXPECT_NEAR(playInTube(tool, off, upright, 9 * kMetresInAnInch), 0.005 * kMetresInAnInch,
              1e-15);  // beyond its length the tool is as thick as its last step
  SteppedTool without = tool;
  without.lengths.clear();
  EXPECT_NEAR(playInTube(without, off, upright, 9 * kMetresInAnInch), 0.084 * kMetresInAnInch, 1e-15);
}

TEST(PlayInTube, ALeanCountsAtTheFarthestEndThatIsIn) {
  const SteppedTool tool = thesisTool();
  const Eigen::Vector2d lean(0.05, 0), centred(0, 0);
  EXPECT_NEAR(playInTube(tool, centred, lean, 0.4 * kMetresInAnInch), (0.089 - 0.02) * kMetresInAnInch, 1e-15);
  EXPECT_NEAR(playInTube(tool, centred, lean, 0.8 * kMetresInAnInch), (0.058 - 0.04) * kMetresInAnInch, 1e-15);
  EXPECT_LT(playInTube(tool, centred, lean, 1.2 * kMetresInAnInch), 0);
  // Reference value: the smallest clearance at closely spaced points along the tool.
  const Eigen::Vector2d off(-0.01 * kMetresInAnInch, 0.006 * kMetresInAnInch), askew(0.02, -0.03);
  const double depth = 0.93 * kMetresInAnInch;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= 10000; ++k) {
    const double below = depth * k / 10000;
    const auto& step = tool.steps[below <= 0.5 * kMetresInAnInch ? 0 : 1];
    least = std::min(least, step.tolerance - (off - below * askew).norm());
  }
  EXPECT_NEAR(playInTube(tool, off, askew, depth), least, 1e-6);
}

TEST(StepWords, SayHowManyOfTheToolsSteps) {
  EXPECT_EQ(stepWords(thesisTool()), (std::vector<std::string>{"no step enters", "one step enters", "two steps enter",
                                                               "all three steps enter"}));
  EXPECT_EQ(stepWords({{{0.01, 0.001}}, {}}), (std::vector<std::string>{"no step enters", "one step enters"}));
}

TEST(StepsInserted, ALaterStepNeedsAllEarlierOnes) {
  const SteppedTool tool{{{0.01, 0.001}, {0.012, 0.003}, {0.014, 0.0005}}, {}};
  EXPECT_EQ(stepsInserted(tool, 0.002), 0);
  EXPECT_EQ(stepsInserted(tool, 0.0007), 2);
}

TEST(ProbabilityWithin, IsRayleighForARoundSpreadAboutTheAxis) {
  for (const double sigma : {1e-6, 1e-4, 1e-3, 0.02, 3.0})
    for (const double radius : {1e-5, 2e-4, 1e-3, 0.0022606, 0.05})
      EXPECT_NEAR(probabilityWithin(radius, {0, 0}, covarianceOf(sigma, sigma, 0.3)),
                  -std::expm1(-radius * radius / (2 * sigma * sigma)), 1e-11)
          << sigma << " " << radius;
}

/// Rice distribution: returns the probability that an isotropic normal offset with mean length `offset` lies within
/// `radius`, as a series of Poisson weights times chi-square probabilities with 2j + 2 degrees of freedom.
double riceWithin(double radius, double offset, double sigma) {
  const double a = offset * offset / (2 * sigma * sigma), b = radius * radius / (2 * sigma * sigma);
  double weight = std::exp(-a), term = std::exp(-b), tail = term, sum = 0;
  for (int j = 0; j < 600; ++j) {
    sum += weight * (1 - tail);
    weight *= a / (j + 1);
    term *= b / (j + 1);
    tail += term;
  }
  return sum;
}

TEST(ProbabilityWithin, IsRiceForARoundSpreadOffTheAxis) {
  for (const double offset : {0.0, 0.3, 1.0, 2.0, 5.0})
    for (const double radius : {0.1, 0.9, 1.0, 2.5, 6.0})
      for (const double turn : {0.0, 1.0, 2.5})
        EXPECT_NEAR(probabilityWithin(radius * 1e-3, 1e-3 * offset * Eigen::Vector2d(std::cos(turn), std::sin(turn)),
                                      covarianceOf(0.7e-3, 0.7e-3, 0)),
                    riceWithin(radius, offset, 0.7), 1e-11)
            << offset << " " << radius << " " << turn;
}

TEST(ProbabilityWithin, KnowsALineAndAPoint) {
  const double radius = 2e-3, sigma = 1e-3;
  const auto band = [&](double half, double mean) {
    return (std::erf((half - mean) / (sigma * std::sqrt(2))) + std::erf((half + mean) / (sigma * std::sqrt(2)))) / 2;
  };
  EXPECT_NEAR(probabilityWithin(radius, {0, 0}, covarianceOf(sigma, 0, 0)), band(radius, 0), 1e-12);
  EXPECT_NEAR(probabilityWithin(radius, {0.5e-3, 1.2e-3}, covarianceOf(sigma, 0, 0)), band(1.6e-3, 0.5e-3), 1e-12);
  EXPECT_EQ(probabilityWithin(radius, {0, 2.1e-3}, covarianceOf(sigma, 0, 0)), 0);
  EXPECT_EQ(probabilityWithin(radius, {1e-3, 1.7e-3}, Eigen::Matrix2d::Zero()), 1);
  EXPECT_EQ(probabilityWithin(radius, {1.2e-3, 1.7e-3}, Eigen::Matrix2d::Zero()), 0);
}

TEST(ProbabilityWithin, ApproachesTheLineAsTheSpreadThins) {
  const Eigen::Vector2d mean(0.5e-3, 1.2e-3);
  const double line = probabilityWithin(2e-3, mean, covarianceOf(1e-3, 0, 0));
  double last = std::numeric_limits<double>::infinity();
  for (const double thin : {1e-4, 1e-5, 1e-6, 1e-7, 1e-9, 1e-11, 1e-13}) {
    const double error = std::abs(probabilityWithin(2e-3, mean, covarianceOf(1e-3, thin, 0)) - line);
    EXPECT_LE(error, std::max(1e-11, last / 10)) << thin;
    last = error;
  }
  EXPECT_LT(last, 1e-11);
}

TEST(ProbabilityWithin, DoesNotTurnWithTheAxes) {
  for (const double ratio : {1.0, 0.3, 1e-2, 1e-4}) {
    const Eigen::Vector2d mean(0.8e-3, -1.1e-3);
    const double straight = probabilityWithin(1.5e-3, mean, covarianceOf(1e-3, ratio * 1e-3, 0));
    for (const double turn : {0.1, 0.785, 1.5, 3.0}) {
      const Eigen::Vector2d turned = Eigen::Rotation2Dd(turn) * mean;
      EXPECT_NEAR(probabilityWithin(1.5e-3, turned, covarianceOf(1e-3, ratio * 1e-3, turn)), straight, 1e-10);
    }
  }
}

/// Returns the probability of probabilityWithin() by a plain sum in polar coordinates: slow, independent of the tested
/// code, accurate to 1e-9 for smooth densities.
double sumWithin(double radius, const Eigen::Vector2d& mean, const Eigen::Matrix2d& covariance) {
  const Eigen::Matrix2d information = covariance.inverse();
  const double scale = 1 / (2 * M_PI * std::sqrt(covariance.determinant()));
  const int rings = 4000, angles = 720;
  double sum = 0;
  for (int i = 0; i < rings; ++i) {
    const double r = radius * (i + 0.5) / rings;
    double ring = 0;
    for (int j = 0; j < angles; ++j) {
      const double angle = 2 * M_PI * j / angles;
      const Eigen::Vector2d e = Eigen::Vector2d(r * std::cos(angle), r * std::sin(angle)) - mean;
      ring += std::exp(-0.5 * e.dot(information * e));
    }
    sum += ring * r;
  }
  return scale * sum * (radius / rings) * (2 * M_PI / angles);
}

TEST(ProbabilityWithin, AgreesWithPlainSummation) {
  for (const unsigned seed : {5u, 6u, 7u, 8u}) {
    std::mt19937_64 random(seed);
    const auto uniform = [&](double low, double high) { return low + (high - low) * std::ldexp(random() >> 11, -53); };
    const Eigen::Vector2d mean(uniform(-2, 2), uniform(-2, 2));
    const Eigen::Matrix2d covariance = covarianceOf(uniform(0.3, 2), uniform(0.3, 2), uniform(0, 3));
    const double radius = uniform(0.5, 3);
    EXPECT_NEAR(probabilityWithin(radius, mean, covariance), sumWithin(radius, mean, covariance), 3e-8);
  }
}

/// Returns the probability of probabilityWithin() by the midpoint rule over strips perpendicular to the wide axis.
double sumAcrossWide(double radius, const Eigen::Vector2d& mean, double wide, double thin) {
  const int strips = 400000;
  double sum = 0;
  for (int i = 0; i < strips; ++i) {
    const double angle = M_PI * ((i + 0.5) / strips - 0.5);
    const double x = radius * std::sin(angle), half = radius * std::cos(angle), deviate = (x - mean.x()) / wide;
    const double band =
        std::erfc((mean.y() - half) / (thin * std::sqrt(2))) - std::erfc((mean.y() + half) / (thin * std::sqrt(2)));
    sum += std::exp(-deviate * deviate / 2) / (wide * std::sqrt(2 * M_PI)) * band / 2 * half;
  }
  return sum * M_PI / strips;
}

TEST(ProbabilityWithin, AgreesWithStripsAcrossTheOtherAxis) {
  for (const double thin : {0.9, 0.1, 0.01, 0.003})
    for (const Eigen::Vector2d& mean : {Eigen::Vector2d(0.2, 0.4), Eigen::Vector2d(0.6, 0.8), Eigen::Vector2d(0.01, 1)})
      EXPECT_NEAR(probabilityWithin(1, mean, covarianceOf(0.7, thin * 0.7, 0)), sumAcrossWide(1, mean, 0.7, thin * 0.7),
                  1e-10)
          << thin << " " << mean.transpose();
}

TEST(ProbabilityWithin, OnTheRimIsHalfAsTheSpreadShrinks) {
  // The curvature of the rim must reduce the half-plane's probability of 1/2 by sigma / (radius sqrt(8 pi)).
  for (const double sigma : {1e-3, 1e-5, 1e-7, 1e-9})
    EXPECT_NEAR(probabilityWithin(1, {0.6, 0.8}, covarianceOf(sigma, sigma, 0)), 0.5 - sigma / std::sqrt(8 * M_PI),
                1e-7 * sigma / 1e-3 + 1e-8)
        << sigma;
}

TEST(ProbabilityBySteps, AgreesWithSampling) {
  const SteppedTool tool = thesisTool();
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const Eigen::Vector2d mean = 0.03 * kMetresInAnInch * Eigen::Vector2d(normal(random), normal(random));
    const Eigen::Matrix2d covariance = covarianceOf(0.04 * kMetresInAnInch, 0.01 * kMetresInAnInch * seed, 0.4 * seed);
    const Eigen::Matrix2d root = covariance.llt().matrixL();
    std::vector<double> counts(4, 0);
    const int runs = 200000;
    for (int i = 0; i < runs; ++i)
      ++counts[stepsInserted(tool, (mean + root * Eigen::Vector2d(normal(random), normal(random))).norm())];
    const std::vector<double> probability = probabilityBySteps(tool, mean, covariance);
    for (int k = 0; k <= 3; ++k) {
      const double sigma = std::sqrt(probability[k] * (1 - probability[k]) / runs);
      EXPECT_NEAR(counts[k] / runs, probability[k], 4.5 * sigma + 1e-9) << k;
    }
  }
}

TEST(StepsInserted, CountsTheLeanOverTheStepsLengths) {
  const SteppedTool tool = thesisTool();
  const Eigen::Vector2d centred = Eigen::Vector2d::Zero();
  EXPECT_EQ(stepsInserted(tool, centred, centred), 3);
  // The third step ends 1.5 in below the tip, so that a tilt above 1 in 150 must exceed its tolerance of 0.010 in.
  EXPECT_EQ(stepsInserted(tool, centred, {0, 1 / 151.}), 3);
  EXPECT_EQ(stepsInserted(tool, centred, {0, 1 / 149.}), 2);
  // If the tilt compensates the offset at the third step, that step must enter; with the opposite tilt it must not.
  EXPECT_EQ(stepsInserted(tool, {0.012 * kMetresInAnInch, 0}, {0.01, 0}), 3);
  EXPECT_EQ(stepsInserted(tool, {0.012 * kMetresInAnInch, 0}, {-0.01, 0}), 2);
  EXPECT_EQ(stepsInserted(tool, {0.07 * kMetresInAnInch, 0}, {-0.05, 0}), 0);
  EXPECT_EQ(stepsInserted({tool.steps, {}}, centred, {0.5, 0}), 3) << "without lengths nothing is known of it";
}

TEST(ProbabilityBySteps, OfALeaningToolAgreesWithSampling) {
  const SteppedTool tool = thesisTool();
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const Eigen::Vector2d mean = 0.01 * kMetresInAnInch * Eigen::Vector2d(normal(random), normal(random));
    const Eigen::Vector2d lean = 0.01 * Eigen::Vector2d(normal(random), normal(random));
    const Eigen::Matrix2d covariance = covarianceOf(0.02 * kMetresInAnInch, 0.006 * kMetresInAnInch * seed, 0.4 * seed);
    const Eigen::Matrix2d root = covariance.llt().matrixL();
    std::vector<double> counts(4, 0);
    const int runs = 200000;
    for (int i = 0; i < runs; ++i)
      ++counts[stepsInserted(tool, mean + root * Eigen::Vector2d(normal(random), normal(random)), lean)];
    const std::vector<double> probability = probabilityBySteps(tool, mean, covariance, lean);
    for (int k = 0; k <= 3; ++k) {
      const double sigma = std::sqrt(probability[k] * (1 - probability[k]) / runs);
      EXPECT_NEAR(counts[k] / runs, probability[k], 4.5 * sigma + 1e-6) << k;
    }
  }
}

TEST(ProbabilityBySteps, OfAToolThatHardlyLeansIsThatOfAnUprightOne) {
  const Eigen::Vector2d mean(0.004 * kMetresInAnInch, 0.01 * kMetresInAnInch);
  const Eigen::Matrix2d covariance = covarianceOf(0.03 * kMetresInAnInch, 0.01 * kMetresInAnInch, 0.5);
  const auto upright = probabilityBySteps(thesisTool(), mean, covariance);
  const auto leaning = probabilityBySteps(thesisTool(), mean, covariance, {1e-9, 1e-9});
  for (int k = 0; k <= 3; ++k) EXPECT_NEAR(upright[k], leaning[k], 1e-6);
}

TEST(ProbabilityBySteps, IsADistribution) {
  const SteppedTool tool = thesisTool();
  for (const double offset : {0.0, 1e-6, 0.01, 0.058, 0.1, 10.0})
    for (const double wide : {0.0, 1e-9, 1e-4, 0.01, 1.0, 1e6})
      for (const double thin : {0.0, 1e-12, 1e-3, 1.0}) {
        const auto probability =
            probabilityBySteps(tool, Eigen::Vector2d(0, offset * kMetresInAnInch),
                               covarianceOf(wide * kMetresInAnInch, thin * wide * kMetresInAnInch, 0.7));
        ASSERT_EQ(probability.size(), 4u);
        for (const double p : probability)
          EXPECT_TRUE(p >= 0 && p <= 1) << offset << " " << wide << " " << thin << " " << p;
        EXPECT_NEAR(std::accumulate(probability.begin(), probability.end(), 0.0), 1, 1e-12);
      }
}

TEST(ProbabilityBySteps, OfAKnownOffsetIsItsStep) {
  const auto probability = probabilityBySteps(thesisTool(), {0.02 * kMetresInAnInch, 0}, Eigen::Matrix2d::Zero());
  EXPECT_EQ(probability, (std::vector<double>{0, 0, 1, 0}));
}

TEST(ProbabilityBySteps, HonoursStepsThatBlockLaterOnes) {
  const SteppedTool tool{{{0.01, 0.001}, {0.012, 0.003}}, {}};
  const auto probability = probabilityBySteps(tool, {0, 0}, covarianceOf(1e-3, 1e-3, 0));
  EXPECT_NEAR(probability[0], std::exp(-0.5), 1e-11);
  EXPECT_EQ(probability[1], 0);
}

TEST(ProbabilityBySteps, IsNaNForNonsense) {
  const auto allNaN = [](const Eigen::Vector2d& mean, const Eigen::Matrix2d& covariance) {
    const auto probability = probabilityBySteps(thesisTool(), mean, covariance);
    return probability.size() == 4 &&
           std::all_of(probability.begin(), probability.end(), [](double p) { return std::isnan(p); });
  };
  EXPECT_TRUE(allNaN({kNan, 0}, Eigen::Matrix2d::Identity()));
  EXPECT_TRUE(allNaN({0, 0}, Eigen::Matrix2d::Constant(kNan)));
  EXPECT_TRUE(allNaN({0, 0}, Eigen::Vector2d(1, -1).asDiagonal().toDenseMatrix()));
  EXPECT_TRUE(allNaN({0, 0}, -Eigen::Matrix2d::Identity()));
  EXPECT_TRUE(allNaN({0, std::numeric_limits<double>::infinity()}, Eigen::Matrix2d::Identity()));
}

TEST(ToolProblems, TheThesisToolHasNone) {
  const auto problems = findToolProblems(thesisTool(), kHole);
  EXPECT_TRUE(problems.empty()) << problems.front().sentence();
}

TEST(ToolProblems, NameTheStep) {
  const auto first = [](auto change) {
    SteppedTool tool = thesisTool();
    change(tool);
    const auto problems = findToolProblems(tool, kHole);
    return problems.empty() ? std::string("none") : problems.front().what;
  };
  EXPECT_EQ(first([](auto& tool) { tool.steps.clear(); }), "steps");
  EXPECT_EQ(first([](auto& tool) { tool.steps[1].tolerance = kNan; }), "steps[1].tolerance");
  EXPECT_EQ(first([](auto& tool) { tool.steps[1].tolerance = 0; }), "steps[1].tolerance");
  EXPECT_EQ(first([](auto& tool) { tool.steps[2].tolerance = -0.001; }), "steps[2].tolerance");
  EXPECT_EQ(first([](auto& tool) { tool.steps[0].tolerance = 0.089; }),
            "steps[0].tolerance");  // value in inches, read as metres
  EXPECT_EQ(first([](auto& tool) { tool.steps[2].diameter = kHole; }), "steps[2].diameter");
  EXPECT_EQ(first([](auto& tool) { tool.steps[0].diameter = kNan; }), "steps[0].diameter");
  EXPECT_EQ(first([](auto& tool) { tool.steps[1].diameter = std::numeric_limits<double>::infinity(); }),
            "steps[1].diameter");
  EXPECT_EQ(first([](auto& tool) { std::swap(tool.steps[0], tool.steps[1]); }), "steps[1].diameter");
  EXPECT_EQ(first([](auto& tool) { tool.steps[2].diameter = tool.steps[1].diameter; }), "steps[2].diameter");
  EXPECT_EQ(first([](auto& tool) { tool.steps[1].tolerance = tool.steps[2].tolerance; }), "steps[2].tolerance");
  EXPECT_EQ(first([](auto& tool) { tool.lengths.pop_back(); }), "lengths");
  EXPECT_EQ(first([](auto& tool) { tool.lengths[1] = -1; }), "lengths[1]");
  EXPECT_EQ(first([](auto& tool) { tool.lengths.clear(); }), "none");
  EXPECT_FALSE(findToolProblems(thesisTool(), kNan).empty());
}

}  // namespace
}  // namespace tubeplan::tubesheets
