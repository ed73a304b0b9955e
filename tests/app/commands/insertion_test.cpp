// With `tubeplan plan --insertion`, the tip enters the tubes along their axes with the stated play, and `verify`
// refutes plans whose stated depth or tool was altered.
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/formats/cell/workcell.hpp"
#include "app/formats/plan/plan_reader.hpp"
#include "planner/reach/compensation.hpp"
#include "tests/app/program.hpp"
#include "tests/units.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class InsertionCommand : public ProgramTest {
 protected:
  InsertionCommand() {
    for (const char* name : {"mockup.yaml", "cobra-arm.yaml"}) write(name, contentOf(shippedCells() / name));
  }

  [[nodiscard]] json planned() const { return json::parse(contentOf(folder / "out/plan.json")); }
};

TEST_F(InsertionCommand, BringsTheTipIntoTheTubesAlongTheirAxes) {
  ASSERT_EQ(run("plan mockup.yaml --tubes R20C30-39 --insertion 0.8 --out out").exit_code, 0);
  const json plan = planned();
  EXPECT_DOUBLE_EQ(plan["insertion"].get<double>(), 0.8);
  ASSERT_GE(plan["tubes"].size(), 5u);
  for (const auto& tube : plan["tubes"]) {
    EXPECT_NEAR(tube["predicted_tip"][2].get<double>(), 0.8, 1e-6);
    EXPECT_NEAR(tube["hole"][2].get<double>(), 0, 1e-12);
    EXPECT_LE(tube["centring_error"].get<double>(), 1e-6);
    EXPECT_GT(tube["play_in_tube"].get<double>(), 0);
    EXPECT_LE(tube["play_in_tube"].get<double>(), 0.058);  // the play of the second step, which is in the tube
  }
  const Cell cell = readCell((folder / "out/cell.yaml").string());
  const auto work = workcellOf(cell, "look at its tip");
  const auto files = readPlanFiles(folder / "out", cell);
  EXPECT_NEAR(files.insertion, 0.8 * kInch, 1e-12);
  double highest = -1, lowest = 1;
  for (const auto& row : files.plan.path) {
    if (row.kind == planner::SegmentKind::kTravel) continue;
    const double z = planner::predictTip(work, row.q).p_WT.z();
    highest = std::max(highest, z), lowest = std::min(lowest, z);
  }
  EXPECT_NEAR(highest, 0.8 * kInch, 1e-6);
  EXPECT_NEAR(lowest, -1 * kInch, 1e-6);  // the standoff point is 1 in below the face of the sheet
  const Outcome verified = run("verify mockup.yaml out --json checked.json");
  EXPECT_EQ(verified.exit_code, 0) << verified.out;
  double least = 1;
  for (const auto& tube : plan["tubes"]) least = std::min(least, tube["play_in_tube"].get<double>());
  EXPECT_NEAR(json::parse(contentOf(folder / "checked.json"))["least_play_in_tube"].get<double>(), least, 1e-4);
}

TEST_F(InsertionCommand, AnotherDepthThanThePathsIsRefuted) {
  ASSERT_EQ(run("plan mockup.yaml --tubes R20C30-35 --insertion 0.5 --out out").exit_code, 0);
  for (const double stated : {0., 0.4, 0.5001, 2.}) {
    json plan = planned();
    plan["insertion"] = stated;
    write("out/plan.json", plan.dump());
    const Outcome verified = run("verify mockup.yaml out");
    EXPECT_EQ(verified.exit_code, 1) << stated << verified.out;
    EXPECT_NE(verified.out.find("off "), std::string::npos) << verified.out;
  }
}

TEST_F(InsertionCommand, ATubeThatATiltedToolWouldTouchIsNotEntered) {
  ASSERT_EQ(run("plan mockup.yaml --tubes spread:30 --insertion 1.5 --out out").exit_code, 0);
  const json plan = planned();
  int touching = 0;
  for (const auto& tube : plan["unreachable"])
    touching += tube["reason"].get<std::string>().find("touch the tube") != std::string::npos;
  EXPECT_GT(touching, 5);
  EXPECT_EQ(run("verify mockup.yaml out").exit_code, 0);
  // With a thicker tool, the same path would touch the tube.
  std::string cell = contentOf(folder / "mockup.yaml");
  const auto at = cell.find("tolerance: 0.010");
  ASSERT_NE(at, std::string::npos);
  write("thick.yaml", cell.replace(at, 16, "tolerance: 0.0001"));
  const Outcome thick = run("verify thick.yaml out");
  EXPECT_EQ(thick.exit_code, 1);
  EXPECT_NE(thick.out.find("touches the tube"), std::string::npos) << thick.out;
}

TEST_F(InsertionCommand, RefusesDepthsThatAreNone) {
  for (const char* depth : {"-0.5", "nan", "inf", "1000"}) {
    const Outcome outcome = run(std::string("plan mockup.yaml --tubes R20C30-33 --out out --insertion=") + depth);
    EXPECT_EQ(outcome.exit_code, 2) << depth;
    EXPECT_NE(outcome.err.find("--insertion"), std::string::npos) << outcome.err;
  }
}

TEST_F(InsertionCommand, APlanOfAnotherDepthIsNotKept) {
  ASSERT_EQ(run("plan mockup.yaml --tubes R20C30-35 --out out").exit_code, 0);
  const Outcome again = run("plan mockup.yaml --tubes R20C30-35 --insertion 0.5 --from out --out deeper");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.out.find("the reach of 0 of 6"), std::string::npos) << again.out;
  EXPECT_EQ(run("verify mockup.yaml deeper").exit_code, 0);
  // With an insertion, the reach found by an earlier plan for a tool of another length is not reused either.
  std::string cell = contentOf(folder / "mockup.yaml");
  write("longer.yaml", cell.replace(cell.find("lengths: [0.5"), 13, "lengths: [0.3"));
  const Outcome longer = run("plan longer.yaml --tubes R20C30-35 --insertion 0.5 --from deeper --out longer");
  ASSERT_EQ(longer.exit_code, 0) << longer.err;
  EXPECT_NE(longer.out.find("the reach of 0 of 6"), std::string::npos) << longer.out;
  EXPECT_NE(longer.err.find("another insertion"), std::string::npos) << longer.err;
  EXPECT_EQ(run("verify longer.yaml longer").exit_code, 0);
}

}  // namespace
}  // namespace tubeplan::app
