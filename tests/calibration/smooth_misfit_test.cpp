// What follows the joints smoothly is seen in a misfit, whatever its law; noise is not taken for it.
#include "calibration/diagnosis/smooth_misfit.hpp"

#include <gtest/gtest.h>

#include "calibration/identification.hpp"
#include "tests/calibration/bench_readings.hpp"

namespace tubeplan::calibration {
namespace {

double chanceAfterFit(const app::Cell& cell, const std::vector<Measurement>& readings) {
  IdentificationOptions options;
  options.free = {cell.identify, !cell.base_known};
  options.folds = 0;
  options.intervals_by_profile = false;
  const auto fit = identify(benchStart(cell, readings), readings, options);
  const auto weights = weighReadings(fit.fitted, readings);
  const auto unknowns = fittedUnknowns(fit);
  const auto residual = whitenedResidual(fit.fitted, unknowns, readings, *weights,
                                         Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns.size())), true);
  return findSmoothMisfit(fit.fitted, readings, *weights, residual).p_value;
}

/// A wave of the third harmonic in the reading of joint 3, that no catalogue has.
std::vector<Measurement> withThirdHarmonic(const app::Cell& cell, double size, std::uint64_t seed) {
  auto readings = benchReadings(cell, "", "", {}, 100, seed);
  for (auto& reading : readings) {
    Measurement moved = reading;
    moved.q[2] += size * std::sin(3 * reading.q[2]);
    *reading.p_W +=
        predictReading(cell.arm, cell.X_WB, moved).value - predictReading(cell.arm, cell.X_WB, reading).value;
  }
  return readings;
}

TEST(SmoothMisfit, NoiseAloneIsRefusedAboutAsOftenAsItsLevelSays) {
  const auto cell = shippedBench();
  int refused = 0;
  constexpr int kSets = 60;
  for (int seed = 1; seed <= kSets; ++seed)
    refused += chanceAfterFit(cell, benchReadings(cell, "", "", {}, 60, static_cast<std::uint64_t>(seed))) < 0.05;
  EXPECT_LE(refused, 9);  // of 60 at 5 %: more has a chance of 2 in 1,000
}

TEST(SmoothMisfit, OneWaveOfOneJointIsSeenWhereChiSquareOverAllReadingsIsBlind) {
  const auto cell = shippedBench();
  int seen = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    seen += chanceAfterFit(cell, withThirdHarmonic(cell, 0.02 * kDegree, seed)) < 0.01;
  EXPECT_GE(seen, 9);
}

TEST(SmoothMisfit, HasAnAnswerForAsFewReadingsAsItHasFunctions) {
  const auto cell = shippedBench();
  const double p = chanceAfterFit(cell, benchReadings(cell, "", "", {}, 20, 3));
  EXPECT_GT(p, 0);
  EXPECT_LE(p, 1);
}

}  // namespace
}  // namespace tubeplan::calibration
