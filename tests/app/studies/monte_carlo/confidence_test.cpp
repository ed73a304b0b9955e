#include "app/studies/monte_carlo/confidence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tubeplan::app {
namespace {

TEST(WilsonInterval, HasThePublishedValues) {
  // R. G. Newcombe, Statistics in Medicine 17 (1998), table I, method 3: 81/263, 15/148, 0/20, 1/29.
  const struct {
    double count, of, low, high;
  } cases[] = {{81, 263, 0.2553, 0.3662}, {15, 148, 0.0624, 0.1605}, {0, 20, 0., 0.1611}, {1, 29, 0.0061, 0.1718}};
  for (const auto& known : cases) {
    const Probability p = wilsonInterval(known.count, known.of);
    EXPECT_NEAR(p.low, known.low, 5e-5);
    EXPECT_NEAR(p.high, known.high, 5e-5);
    EXPECT_EQ(p.value, known.count / known.of);
  }
  EXPECT_TRUE(std::isnan(wilsonInterval(0, 0).value));
  EXPECT_EQ(wilsonInterval(0, 0).low, 0);
  EXPECT_EQ(wilsonInterval(0, 0).high, 1);
}

/// Returns the exact probability that the interval contains `share`: a sum over all counts.
double coverage(int of, double share) {
  double sum = 0;
  for (int count = 0; count <= of; ++count) {
    const Probability p = wilsonInterval(count, of);
    if (p.low <= share && share <= p.high)
      sum += std::exp(std::lgamma(of + 1.) - std::lgamma(count + 1.) - std::lgamma(of - count + 1.) +
                      count * std::log(share) + (of - count) * std::log1p(-share));
  }
  return sum;
}

TEST(WilsonInterval, CoversTheTruthAsOftenAsItSays) {
  for (const int of : {20, 100, 1000}) {
    double sum = 0;
    int cases = 0;
    for (double share = 0.02; share < 0.985; share += 0.005, ++cases) {
      const double covered = coverage(of, share);
      EXPECT_GT(covered, 0.83) << share << " of " << of;  // the coverage is known to dip near 0 and 1
      sum += covered;
    }
    EXPECT_NEAR(sum / cases, 0.95, 0.01) << of;
  }
}

/// Returns the sums over runs of ten cases each; all cases of a run have the same random success probability.
RunSums clusteredRuns(int runs, double spread, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  RunSums sums;
  for (int run = 0; run < runs; ++run) {
    const double chance = 0.7 + spread * (2 * uniform(random) - 1);
    std::uint64_t count = 0;
    for (int k = 0; k < 10; ++k) count += uniform(random) < chance;
    sums.add(count, 10);
  }
  return sums;
}

TEST(RunSums, BandsHoldTheTruthWhereCasesOfARunAreAlike) {
  std::mt19937_64 random(3);
  int held = 0, naive = 0;
  constexpr int kTries = 1000;
  for (int k = 0; k < kTries; ++k) {
    const RunSums sums = clusteredRuns(200, 0.3, random);
    const Probability p = sums.probability();
    held += p.low <= 0.7 && 0.7 <= p.high;
    const Probability alone = wilsonInterval(sums.mean() * 2000, 2000);
    naive += alone.low <= 0.7 && 0.7 <= alone.high;
  }
  EXPECT_NEAR(held / 1000., 0.95, 0.025);  // 3.6 sigma for 1000 tries
  EXPECT_LT(naive, 900);                   // intervals for independent cases are too narrow
}

TEST(RunSums, StandardErrorIsThatOfTheRatio) {
  RunSums sums;
  const std::pair<std::uint64_t, std::uint64_t> runs[] = {{3, 10}, {7, 10}, {0, 4}, {9, 9}};
  for (const auto& [sum, count] : runs) sums.add(sum, count);
  const double mean = 19. / 33;
  double spread = 0;
  for (const auto& [sum, count] : runs)
    spread += std::pow(static_cast<double>(sum) - mean * static_cast<double>(count), 2);
  EXPECT_DOUBLE_EQ(sums.mean(), mean);
  EXPECT_NEAR(sums.standardError(), std::sqrt(spread * 4 / 3) / 33, 1e-15);
}

TEST(RunSums, OneRunOrNoneTellsNoError) {
  RunSums sums;
  EXPECT_TRUE(std::isnan(sums.mean()));
  EXPECT_EQ(sums.probability().high, 1);
  sums.add(10, 10);
  EXPECT_TRUE(std::isnan(sums.standardError()));
  EXPECT_LT(sums.probability().low, 0.3);  // one run counts as one case
  TallyWords words;
  sums.put(words);
  WordReader reader(words);
  EXPECT_EQ(RunSums::read(reader), sums);
  EXPECT_TRUE(reader.isWhole());
}

}  // namespace
}  // namespace tubeplan::app
