// Tests of `tubeplan bases`: the reach that it reports is consistent, and agrees with plans and with its bounds.
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class Bases : public ProgramTest {
 protected:
  [[nodiscard]] json answer(const std::string& more, int code = 0) const {
    const Outcome outcome = run("bases " + shipped("mockup.yaml") + " --tubes spread:40 --json - " + more);
    EXPECT_EQ(outcome.exit_code, code) << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }
};

TEST_F(Bases, TheCellsOwnBaseReachesWhatAPlanReaches) {
  const json found = answer("");
  ASSERT_EQ(found["candidates"].size(), 1u);
  ASSERT_EQ(run("plan " + shipped("mockup.yaml") + " --tubes spread:40 --out p").exit_code, 0);
  const json plan = json::parse(contentOf(folder / "p/plan.json"));
  EXPECT_EQ(found["candidates"][0]["reached"], plan["tubes"].size());
  EXPECT_EQ(found["reached"], plan["tubes"].size());
}

TEST_F(Bases, MorePositionsReachNoFewerAndBoundsHold) {
  const json one = answer("--along x=-15:15:3 --along turn=-10:10:2 --most 1 --moving mezzanine");
  const json two = answer("--along x=-15:15:3 --along turn=-10:10:2 --most 2 --moving mezzanine");
  EXPECT_EQ(one["candidates"].size(), 7u);
  EXPECT_GE(two["reached"], one["reached"]);
  EXPECT_EQ(two["proved"], true);
  EXPECT_GE(two["reached_at_most"], two["reached"]);
  EXPECT_GE(two["reachable"], two["reached"]);
  EXPECT_LE(two["best"].size(), 2u);
  int most = 0;
  for (const auto& candidate : one["candidates"]) most = std::max(most, candidate["reached"].get<int>());
  EXPECT_EQ(one["reached"], most);
  EXPECT_GE(two["fewest"].size(), two["fewest_at_least"]);
}

TEST_F(Bases, AMirroredBaseReachesTheMirroredTubes) {
  const json found = answer("--mirrored x");
  ASSERT_EQ(found["candidates"].size(), 2u);
  EXPECT_DOUBLE_EQ(found["candidates"][1]["position"][0].get<double>(),
                   -found["candidates"][0]["position"][0].get<double>());
}

TEST_F(Bases, TwoBasesOnEitherSideReachMoreOfAOnceThroughSheet) {
  const auto reached = [&](const std::string& more) {
    const Outcome outcome =
        run("bases " + shipped("sheets/once-through.yaml") + " --tubes spread:150 --json - " + more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out)["reached"].get<int>();
  };
  EXPECT_GE(reached("--mirrored y --most 2"), reached("") + 20);
}

TEST_F(Bases, WhatItCannotReadIsRefused) {
  for (const char* words : {"--along x=1:2", "--along w=1:2:3", "--along x=a:2:3", "--along x=1:2:0",
                            "--along x=0:1:3000", "--moving nothing", "--most 0", "--mirrored z"})
    EXPECT_EQ(run("bases " + shipped("mockup.yaml") + " " + words).exit_code, 2) << words;
}

}  // namespace
}  // namespace tubeplan::app
