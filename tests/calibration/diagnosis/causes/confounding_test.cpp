// Exactly those causes that the measurements can hardly distinguish must be reported as confounded.
#include "calibration/diagnosis/causes/confounding.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "calibration/measurements/measurement_placement.hpp"
#include "tests/calibration/bench_measurements.hpp"

namespace tubeplan::calibration {
namespace {

const Confounding& causeAt(const std::vector<Confounding>& causes, const std::string& effect, const std::string& at) {
  const auto found =
      std::find_if(causes.begin(), causes.end(), [&](const auto& c) { return c.effect == effect && c.at == at; });
  EXPECT_NE(found, causes.end()) << effect << "@" << at;
  static const Confounding kNone;
  return found == causes.end() ? kNone : *found;
}

bool isConfoundedWith(const Confounding& cause, const std::string& effect, const std::string& at) {
  return std::any_of(cause.confounded.begin(), cause.confounded.end(),
                     [&](const ConfoundedCause& other) { return other.effect == effect && other.at == at; });
}

std::vector<Confounding> confoundingOf(const std::vector<std::string>& free) {
  const app::Cell cell = shippedBench();
  const auto measurements = benchMeasurements(cell, "", "", {}, 90, 4);
  PlacedArm placed = placeForMeasurements(cell.arm, cell.X_WB, true, measurements);
  const auto fitted = chooseUnknowns(placed, {free, false}).list;
  return findConfounding(placed, measurements, fitted);
}

TEST(Confounding, AWeightAndAPullStraightDownAreOneButNotTheOtherWay) {
  const auto causes = confoundingOf({});
  ASSERT_FALSE(causes.empty());
  EXPECT_TRUE(isConfoundedWith(causeAt(causes, "link-weight", "forearm"), "hose-pull", "forearm"));
  EXPECT_FALSE(isConfoundedWith(causeAt(causes, "hose-pull", "forearm"), "link-weight", "forearm"))
      << "a pull may be level";
  EXPECT_TRUE(isConfoundedWith(causeAt(causes, "joint-offset", "theta4"), "tool-offset", "tool"));
  EXPECT_TRUE(causeAt(causes, "hysteresis", "theta2").confounded.empty());
  for (const auto& cause : causes)
    for (const auto& other : cause.confounded) {
      EXPECT_GE(other.share, kConfoundedShare);
      EXPECT_LE(other.share, 1 + 1e-9);
    }
}

TEST(Confounding, WhatAFittedNumberCanDoIsNotKept) {
  EXPECT_GT(causeAt(confoundingOf({}), "joint-offset", "theta4").kept, 0.9);
  const auto causes = confoundingOf({"tool.tip"});
  EXPECT_LT(causeAt(causes, "joint-offset", "theta4").kept, 0.05) << "a turn of the tool shifts its tip";
}

}  // namespace
}  // namespace tubeplan::calibration
