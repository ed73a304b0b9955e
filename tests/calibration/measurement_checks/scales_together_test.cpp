// If several joints are read in encoder pulses, with different or equal counts per degree, the checks find their
// scales, unless there are too few measurements.
#include "calibration/measurement_checks/scales_together.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/calibration/measurement_checks/seeded_pairs.hpp"

namespace tubeplan::calibration {
namespace {

/// Converts measurements of the listed joints to whole encoder counts, at `counts` per degree.
void countPulses(SeededSet& set, const std::vector<int>& joints, const std::vector<double>& counts) {
  constexpr double kDegree = std::numbers::pi / 180;
  for (auto& m : set.table.measurements)
    for (std::size_t k = 0; k < joints.size(); ++k)
      m.q[joints[k]] = std::round(m.q[joints[k]] / kDegree * counts[k]) * kDegree;
}

// The scales are found in at least three quarters of the sets. In the others, all of them may have the wrong sign,
// because an arm with all signs reversed fits with another base.
TEST(ScalesTogether, OfSeveralJointsAreNamed) {
  int made = 0, corrected = 0;
  std::string found;
  for (const std::vector<int>& joints : {std::vector{1, 2}, std::vector{0, 2}, std::vector{1, 2, 3}})
    for (const bool are_alike : {true, false})
      for (const std::uint64_t number : {0, 5}) {
        auto set = cleanSet(number);
        ASSERT_TRUE(set);
        SeededRandom random(number + 31);
        SeededPair pulses{*set, set->table.measurements, {}, "pulses"};
        std::vector<double> counts;
        for (std::size_t k = 0; k < joints.size(); ++k)
          counts.push_back(are_alike && k > 0 ? counts.front() : drawnBetween(200, 5000, random));
        countPulses(pulses.set, joints, counts);
        ++made;
        const auto checks = checksOf(pulses.set);
        const auto* gross = firstMistake(checks);
        if (gross && distanceAfterCorrection(pulses, gross->assume) < 0.02)
          ++corrected;
        else
          found +=
              fmt::format("{} joints in {}: {}\n", joints.size(), pulses.set.name, gross ? gross->assume : "nothing");
      }
  EXPECT_GE(corrected, made * 3 / 4) << found;
}

TEST(ScalesTogether, AreNoneOfTooManyJointsOrTooFewMeasurements) {
  auto set = cleanSet(0);
  ASSERT_TRUE(set);
  countPulses(*set, {1, 2}, {700, 900});
  set->table.measurements.resize(3);
  const CheckedMeasurements few{app::startOf(set->cell, set->table.measurements), set->table.measurements,
                                app::freeNumbersOf(set->cell), set->table.units, nullptr};
  EXPECT_TRUE(likelyScales(few, {1, 2}).empty());
}

}  // namespace
}  // namespace tubeplan::calibration
