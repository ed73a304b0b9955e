// If a clock was set or misread during a campaign, the checks name the first affected measurement and correct the
// times. They do not report pauses and rows that are not in time order.
#include "calibration/measurement_checks/clock.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "calibration/random_stream.hpp"

namespace tubeplan::calibration {
namespace {

constexpr double kMinute = 60, kHourLong = 3600;  // [s]

/// Returns `count` measurements, about one minute apart.
CheckedMeasurements timedMeasurements(int count, std::uint64_t seed) {
  CheckedMeasurements checked;
  RandomStream random(seed);
  double time = 1000;
  for (int k = 0; k < count; ++k) {
    Measurement measurement;
    measurement.id = "P" + std::to_string(k + 1);
    measurement.conditions[deflection::Condition::kTime] = time;
    time += random.uniform(0.6, 1.5) * kMinute;
    checked.measurements.push_back(measurement);
  }
  return checked;
}

void setClock(CheckedMeasurements& checked, std::size_t first, double by) {
  for (std::size_t k = first; k < checked.measurements.size(); ++k)
    checked.measurements[k].conditions[deflection::Condition::kTime] += by;
}

TEST(Clock, IsNamedWithTheMeasurementWhereItWasSet) {
  for (const double by : {-kHourLong, kHourLong, 2 * kHourLong, -600., -86400., -1000 * 86400., 400 * 86400.})
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      auto checked = timedMeasurements(30, seed);
      const auto clean = checked.measurements;
      const std::size_t first = 5 + seed * 2;
      setClock(checked, first, by);
      const auto checks = clockJumps(checked);
      ASSERT_EQ(checks.size(), 1U) << by << " seed " << seed;
      // A step back by one day is midnight on a clock without a date; any other step may be right.
      EXPECT_EQ(checks.front().severity, by == -86400. ? CheckSeverity::kMistake : CheckSeverity::kRemark) << by;
      const std::string assume = checks.front().assume, id = checked.measurements[first].id;
      ASSERT_TRUE(assume.starts_with("clock=") && assume.ends_with("@" + id)) << assume << " for " << id;
      const auto correction = mistakes::clock::kind().correction(checked, assume.substr(6));
      ASSERT_TRUE(correction) << assume;
      auto corrected = checked.measurements;
      correction->apply(corrected);
      for (std::size_t k = 0; k < corrected.size(); ++k)
        EXPECT_NEAR(corrected[k].conditions[deflection::Condition::kTime],
                    clean[k].conditions[deflection::Condition::kTime], kMinute + 1e-5 * std::abs(by))
            << by << " seed " << seed;
    }
}

TEST(Clock, OneTimeThatIsOffIsNamedAlone) {
  for (const double by : {-900., 5000., -7e5, 7e5})
    for (std::size_t k : {1U, 7U, 15U, 28U}) {
      auto checked = timedMeasurements(30, k);
      checked.measurements[k].conditions[deflection::Condition::kTime] += by;
      const auto checks = clockJumps(checked);
      ASSERT_EQ(checks.size(), 1U) << by << " at " << k;
      EXPECT_NE(checks.front().sentence.find("reading " + checked.measurements[k].id + " is"), std::string::npos)
          << checks.front().sentence;
      EXPECT_EQ(checks.front().assume, "");
    }
}

TEST(Clock, TwoThatWereSetAreBothNamed) {
  auto checked = timedMeasurements(60, 3);
  setClock(checked, 10, -kHourLong);
  setClock(checked, 40, -500);
  const auto checks = clockJumps(checked);
  ASSERT_EQ(checks.size(), 2U);
  EXPECT_TRUE(checks[0].assume.ends_with("@P11")) << checks[0].assume;
  EXPECT_TRUE(checks[1].assume.ends_with("@P41")) << checks[1].assume;
}

TEST(Clock, PausesAndOtherOrdersAreLeftAlone) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    auto checked = timedMeasurements(40, seed);
    EXPECT_TRUE(clockJumps(checked).empty()) << seed;
    setClock(checked, 20, 2500 + 17 * static_cast<double>(seed));  // a coffee break
    EXPECT_TRUE(clockJumps(checked).empty()) << seed;
    setClock(checked, 12, 14.5 * kHourLong);  // a night's pause
    EXPECT_TRUE(clockJumps(checked).empty()) << seed;
    RandomStream(seed).shuffle(checked.measurements);
    EXPECT_TRUE(clockJumps(checked).empty()) << seed;
    for (auto& measurement : checked.measurements) measurement.conditions[deflection::Condition::kTime] = 5;
    EXPECT_TRUE(clockJumps(checked).empty()) << seed;
    for (auto& measurement : checked.measurements)
      measurement.conditions[deflection::Condition::kTime] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(clockJumps(checked).empty()) << seed;
  }
}

TEST(Clock, IsCorrectedFromAMeasurementOn) {
  const auto checked = timedMeasurements(10, 1);
  for (const char* value : {"", "3600", "x@P3", "@P3", "3600@P99", "nan@P3"})
    EXPECT_FALSE(mistakes::clock::kind().correction(checked, value)) << value;
}

}  // namespace
}  // namespace tubeplan::calibration
