// Tests of plans with conditions (park posture, zones, dwell times, padding), and of conditions that are refused.
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class PlanConditions : public ProgramTest {
 protected:
  [[nodiscard]] json planOf(const std::string& name) const {
    return json::parse(contentOf(folder / name / "plan.json"));
  }
  void expectRefused(const std::string& more, const std::string& what) const {
    const Outcome outcome = run("plan " + shipped("mockup.yaml") + " --tubes R20C40 --out refused " + more);
    EXPECT_EQ(outcome.exit_code, 2) << more;
    expectSays(outcome.err, what);
    EXPECT_FALSE(std::filesystem::exists(folder / "refused/plan.json"));
  }
};

TEST_F(PlanConditions, AWorkListWithStaysAndAZoneFromParkAndBackIsPlannedAndProved) {
  write("list.csv", "row,column,dwell_s\n20,40,\n30,70,12.5\n3,10,\n10,95,\n");
  const Outcome plan = run("plan " + shipped("mockup.yaml") +
                           " --tubes list.csv --first R10C95 --first R3C10,R30C70 --dwell 4 --start park --end park"
                           " --trajectory --out plan");
  ASSERT_EQ(plan.exit_code, 0) << plan.err;
  const json document = planOf("plan");
  EXPECT_EQ(document["tubes"][0]["name"], "R10C95");
  EXPECT_EQ(document["tubes"][3]["name"], "R20C40");
  EXPECT_EQ(document["tubes"][3]["zone"], 3);
  EXPECT_EQ(document["tubes"][3]["dwell_s"], 4);
  for (const auto& tube : document["tubes"])
    if (tube["name"] == "R30C70") {
      EXPECT_EQ(tube["dwell_s"], 12.5);
    }
  EXPECT_EQ(document["start"], document["end"]);
  const Outcome proof = run("verify " + shipped("mockup.yaml") + " plan");
  EXPECT_EQ(proof.exit_code, 0) << proof.out;

  // The verification must refute a plan that states a longer dwell time than its path has, and one that visits a zone
  // out of order.
  for (const auto& [key, value] : {std::pair<std::string, json>{"dwell_s", 40}, {"zone", 9}}) {
    json altered = document;
    altered["tubes"][1][key] = value;
    write("plan/plan.json", altered.dump());
    EXPECT_EQ(run("verify " + shipped("mockup.yaml") + " plan").exit_code, 1) << key;
  }
}

TEST_F(PlanConditions, AWrittenWorkListKeepsItsStays) {
  write("list.csv", "row,column,dwell_s\n20,40,\n30,70,12.5\n");
  ASSERT_EQ(run("plan " + shipped("mockup.yaml") + " --tubes list.csv --dwell 4 --out plan").exit_code, 0);
  ASSERT_EQ(run("plan " + shipped("mockup.yaml") + " --tubes plan/worklist.csv --out again").exit_code, 0);
  EXPECT_EQ(planOf("again")["total_time_s"], planOf("plan")["total_time_s"]);
}

TEST_F(PlanConditions, PaddingKeepsTheArmFurtherOff) {
  // The arm has no uncertainty here; with it, three touches would leave the base so uncertain that a hole is lost.
  write("cobra-arm.yaml", contentOf(shippedCells() / "cobra-arm.yaml"));
  write("exact.yaml", contentOf(shippedCells() / "mockup.yaml") + "uncertainty: none\n");
  const std::string question = "plan exact.yaml --tubes spread:6 --touches auto --truth exact.yaml";
  ASSERT_EQ(run(question + " --out bare").exit_code, 0);
  ASSERT_EQ(run(question + " --padding 3 --out padded").exit_code, 0);
  const json bare = planOf("bare"), padded = planOf("padded");
  const double added = padded["padding"]["added"];
  EXPECT_EQ(padded["padding"]["covers"], "base");
  EXPECT_GT(added, 0);
  EXPECT_FALSE(bare.contains("padding"));
  EXPECT_EQ(padded["clearance_required"], bare["clearance_required"]);
  EXPECT_EQ(padded["tubes"].size(), bare["tubes"].size()) << "the standoff is not eaten by the padding";
  EXPECT_GE(padded["min_clearance"].get<double>(), padded["clearance_required"].get<double>());
  EXPECT_EQ(run("verify exact.yaml padded").exit_code, 0);

  // Without a covariance of the base, the padding must be reported as not checkable.
  write("padded/cell.yaml", contentOf(shippedCells() / "mockup.yaml"));
  write("padded/cobra-arm.yaml", contentOf(shippedCells() / "cobra-arm.yaml"));
  const Outcome unknown = run("verify " + shipped("mockup.yaml") + " padded");
  EXPECT_EQ(unknown.exit_code, 2);
  expectSays(unknown.err, "the cell.yaml next to plan.json has no covariance of the base");
}

TEST_F(PlanConditions, PaddingCoversTheArmsUncertainParametersAsVerifyDoes) {
  // Known to 1 %, the arm leaves room for padding at every hole.
  write("cobra-arm.yaml", contentOf(shippedCells() / "cobra-arm.yaml"));
  write("known.yaml", contentOf(shippedCells() / "mockup.yaml") +
                          "uncertainty: {stiffness: 0.01, weight: 0, zero: 0, axis: 0, length: 0, tip: 0}\n");
  const std::string question = "plan known.yaml --tubes spread:6 --touches auto --truth known.yaml --padding 2";
  ASSERT_EQ(run(question + " --out padded").exit_code, 0);
  EXPECT_EQ(planOf("padded")["padding"]["covers"], "base and arm");
  EXPECT_EQ(run("verify known.yaml padded").exit_code, 0);
}

TEST_F(PlanConditions, AChangedParkKeepsEverythingButTheWaysToIt) {
  const std::string question = "plan " + shipped("mockup.yaml") + " --tubes spread:5 --start park";
  ASSERT_EQ(run(question + " --out first").exit_code, 0);
  ASSERT_EQ(run(question + " --end park --from first --out second").exit_code, 0);
  ASSERT_EQ(run(question + " --end park --out anew").exit_code, 0);
  EXPECT_EQ(run("verify " + shipped("mockup.yaml") + " second").exit_code, 0);
  EXPECT_EQ(planOf("second")["end"], planOf("anew")["end"]);
}

TEST_F(PlanConditions, BadOnesAreRefused) {
  expectRefused("--start=1,2", "--start: found 2 numbers");
  expectRefused("--end=0,0,0,9999", "--end (");
  expectRefused("--dwell -1", "--dwell");
  expectRefused("--dwell nan", "--dwell");
  expectRefused("--first R99C1", "--first");
  expectRefused("--padding 2", "the base pose has no covariance");
  expectRefused("--padding 99", "--padding");
  write("list.csv", "row,column,dwell_s\n20,40,soon\n");
  const Outcome list = run("plan " + shipped("mockup.yaml") + " --tubes list.csv --out refused");
  EXPECT_EQ(list.exit_code, 2);
  expectSays(list.err, "(dwell_s)");
}

}  // namespace
}  // namespace tubeplan::app
