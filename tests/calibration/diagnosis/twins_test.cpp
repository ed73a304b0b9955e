// What the readings can hardly tell apart is found, and only that.
#include "calibration/diagnosis/twins.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/calibration/bench_readings.hpp"

namespace tubeplan::calibration {
namespace {

const CauseTwins& causeAt(const std::vector<CauseTwins>& causes, const std::string& effect, const std::string& at) {
  const auto found =
      std::find_if(causes.begin(), causes.end(), [&](const auto& c) { return c.effect == effect && c.at == at; });
  EXPECT_NE(found, causes.end()) << effect << "@" << at;
  static const CauseTwins kNone;
  return found == causes.end() ? kNone : *found;
}

bool hasTwin(const CauseTwins& cause, const std::string& effect, const std::string& at) {
  return std::any_of(cause.twins.begin(), cause.twins.end(),
                     [&](const Twin& twin) { return twin.effect == effect && twin.at == at; });
}

std::vector<CauseTwins> twinsOf(const std::vector<std::string>& free) {
  const app::Cell cell = shippedBench();
  const auto readings = benchReadings(cell, "", "", {}, 90, 4);
  PlacedArm placed = placeForReadings(cell.arm, cell.X_WB, true, readings);
  const auto fitted = chooseUnknowns(placed, {free, false}).list;
  return findTwins(placed, readings, fitted);
}

TEST(Twins, AWeightAndAPullStraightDownAreOneButNotTheOtherWay) {
  const auto causes = twinsOf({});
  ASSERT_FALSE(causes.empty());
  EXPECT_TRUE(hasTwin(causeAt(causes, "link-weight", "forearm"), "hose-pull", "forearm"));
  EXPECT_FALSE(hasTwin(causeAt(causes, "hose-pull", "forearm"), "link-weight", "forearm")) << "a pull may be level";
  EXPECT_TRUE(hasTwin(causeAt(causes, "joint-offset", "theta4"), "tool-offset", "tool"));
  EXPECT_TRUE(causeAt(causes, "hysteresis", "theta2").twins.empty());
  for (const auto& cause : causes)
    for (const auto& twin : cause.twins) {
      EXPECT_GE(twin.share, kTwinShare);
      EXPECT_LE(twin.share, 1 + 1e-9);
    }
}

TEST(Twins, WhatAFittedNumberCanDoIsNotKept) {
  EXPECT_GT(causeAt(twinsOf({}), "joint-offset", "theta4").kept, 0.9);
  const auto causes = twinsOf({"tool.tip"});
  EXPECT_LT(causeAt(causes, "joint-offset", "theta4").kept, 0.05) << "a turn of the tool shifts its tip";
}

}  // namespace
}  // namespace tubeplan::calibration
