// `tubeplan campaign --kind outage`: the same bytes for any number of workers, few false alarms, and slips that are
// found.
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/commands/campaign/campaign.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

const std::string kSmall = " --kind outage --tubes spread:60 --visits 40 ";

class OutageCampaign : public ProgramTest {
 protected:
  static std::string outages(const std::string& more) { return "campaign " + shipped("mockup.yaml") + kSmall + more; }

  [[nodiscard]] json figuresOf(const std::string& arguments) const {
    const Outcome outcome = run(arguments + " --json -");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
  }

  void expectRefusal(const std::string& arguments, const std::string& word) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    expectSays(outcome.err, word);
  }

  void expectSameFiles(const std::string& one, const std::string& other) const {
    for (const char* file : {"campaign.json", "changes.csv", "report.html", "tally.json"})
      EXPECT_EQ(contentOf(folder / one / file), contentOf(folder / other / file)) << file;
  }
};

TEST_F(OutageCampaign, WritesTheSameBytesForAnyNumberOfWorkersAndAfterMoreRuns) {
  ASSERT_EQ(run(outages("--runs 3 --touch-every 4 --jobs 1 --out one")).exit_code, 0);
  ASSERT_EQ(run(outages("--runs 3 --touch-every 4 --jobs 3 --out three")).exit_code, 0);
  expectSameFiles("one", "three");
  ASSERT_EQ(run(outages("--runs 4 --touch-every 4 --jobs 3 --resume --out one")).exit_code, 0);
  ASSERT_EQ(run(outages("--runs 4 --touch-every 4 --jobs 1 --out whole")).exit_code, 0);
  expectSameFiles("one", "whole");
  const json figures = json::parse(contentOf(folder / "one/campaign.json"));
  EXPECT_EQ(figures["status"], "done");
  int sum = figures["unchanged"]["runs"].get<int>();
  for (const auto& change : figures["changes"]) sum += change["runs"].get<int>();
  for (const auto& reason : figures["refused"]) sum += reason["runs"].get<int>();
  EXPECT_EQ(sum, 4);
  for (const auto& meaning : figures["meanings"])
    EXPECT_TRUE(figures["changed"].contains(meaning["name"].get<std::string>())) << meaning;
}

TEST_F(OutageCampaign, ARunDependsOnSeedAndIndexAlone) {
  CampaignRequest request;
  request.cell = TUBEPLAN_SOURCE_DIR "/app/cells/mockup.yaml";
  request.tubes = "spread:60";
  request.visits = 40;
  request.touch_every = 4;
  const Campaign campaign = makeOutageCampaign(request), again = makeOutageCampaign(request);
  const auto goes_on = [] { return false; };
  const Experiment &in_one_run = *campaign.experiment, &in_parts = *again.experiment;
  const TallyWords all = *in_one_run.run({0, 3}, goes_on);
  const TallyWords last = *in_parts.run({2, 3}, goes_on), first = *in_parts.run({0, 1}, goes_on);
  const TallyWords second = *in_parts.run({1, 2}, goes_on);
  EXPECT_EQ(*in_parts.sum(*in_parts.sum(last, first), second), all);
  EXPECT_EQ(*in_parts.sum(last, *in_parts.sum(first, second)), all);
  EXPECT_FALSE(campaign.experiment->run({3, 4}, [] { return true; }));
}

TEST_F(OutageCampaign, WithoutAChangeAlarmsAreFew) {
  const json figures = figuresOf(outages("--runs 40 --touch-every 10 --nothing 1"));
  EXPECT_EQ(figures["unchanged"]["false_alarms"]["of"], 40);
  EXPECT_LE(figures["unchanged"]["false_alarms"]["count"].get<int>(), 6);  // 7 of 40 have a probability below 0.004
  EXPECT_EQ(figures["changed"]["runs"], 0);
  EXPECT_TRUE(figures["changed"]["detected"]["value"].is_null());
}

TEST_F(OutageCampaign, FindsAndNamesAShiftOfTheBaseByTouches) {
  const json figures = figuresOf(outages("--runs 10 --nothing 0 --hide base-shift --touch-every 2"));
  ASSERT_EQ(figures["changes"].size(), 1u);
  const auto& found = figures["changes"][0];
  EXPECT_EQ(found["runs"], 10);
  EXPECT_EQ(found["at"], "base");
  EXPECT_EQ(found["detected"]["count"].get<int>() + found["too_early"].get<int>(), 10);
  EXPECT_GE(found["named"]["count"].get<int>(), 8);
  EXPECT_LE(found["delay"]["50"].get<double>(), 14);  // seven touches
  EXPECT_LT(found["all_steps_after"]["value"].get<double>(), found["all_steps_before"]["value"].get<double>());
}

TEST_F(OutageCampaign, RefusesBadInput) {
  expectRefusal(outages("--runs 2 --hide base-shft"), "did you mean");
  expectRefusal(outages("--runs 2 --nothing 2"), "--nothing");
  expectRefusal(outages("--runs 2 --touch-every 1"), "--touch-every");
  expectRefusal(outages("--runs 2 --touches 3,4"), "one setting");
  expectRefusal(outages("--runs 2 --holes 4"), "--kind centre");
  expectRefusal(outages("--runs 2 --design bench"), "--kind diagnose");
  expectRefusal("campaign " + shipped("mockup.yaml") + " --kind outage --tubes spread:30 --visits 100 --runs 2",
                "--visits");
  expectRefusal("campaign " + shipped("mockup.yaml") + " --runs 2 --visits 100", "--kind outage");
}

}  // namespace
}  // namespace tubeplan::app
