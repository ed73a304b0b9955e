// The plan of a job: every leg planned, the visiting order recorded, and times that add up.
#include "app/outage/job_plan.hpp"

#include <nlohmann/json.hpp>

#include "app/outage/job_desk.hpp"
#include "app/outage/job_plan_json.hpp"
#include "tests/app/outage/job_fixture.hpp"

namespace tubeplan::app {
namespace {

using tubesheets::Leg;

constexpr const char* kPackages =
    "  - {name: few, tubes: 'R9-11C18-20', steam_generators: [A], tool: bobbin, length: 720, dwell_s: 2, confirm: "
    "none}\n"
    "  - {name: edge, tubes: 'spread:5', steam_generators: [A], tool: bobbin, confirm: none}\n";

class PlannedJob : public JobTest {};

TEST_F(PlannedJob, EveryOpenItemIsPlannedOrSaidToBeOutOfReach) {
  JobStore store(made(kPackages));
  int kept = 0;
  const JobPlan plan = planJob(store, 1, {}, [&](const std::string&, const PlanRequest&, const PlanOutcome& outcome) {
    ++kept;
    EXPECT_EQ(outcome.plan.status, planner::VisitPlanStatus::kPlanned);
    EXPECT_GE(outcome.plan.min_margin, 0);
  });
  EXPECT_EQ(kept, 4);
  ASSERT_EQ(plan.legs.size(), 2u);
  int planned = 0, unreachable = 0;
  for (const LegPlan& leg : plan.legs)
    for (const PackagePlan& package : leg.packages) {
      planned += package.visits;
      unreachable += static_cast<int>(package.unreachable.size());
      EXPECT_GT(package.travel, 0);
      EXPECT_GT(package.approaches, 0);
      const bool is_few = package.package == "few";
      EXPECT_NEAR(package.in_tubes, is_few ? package.visits * 2 * 720. / 40 : 0, 1e-6);
      EXPECT_NEAR(package.dwell, is_few ? package.visits * 2 : 0, 1e-6);
    }
  EXPECT_EQ(planned + unreachable, 2 * 8 + 2 * 5);  // R10C20 is plugged
  int placed = 0;
  for (const JobItem& item : store.items()) placed += item.place.has_value();
  EXPECT_EQ(placed, planned);
}

TEST_F(PlannedJob, NextFollowsThePlannedOrder) {
  JobStore store(made(kPackages));
  std::vector<std::string> order;
  (void)planJob(store, 1, {}, [&](const std::string& folder, const PlanRequest&, const PlanOutcome& outcome) {
    if (folder != "A-cold-few") return;
    for (const auto& visit : outcome.plan.visits) {
      const auto& tube = outcome.model.sheet.tubes[static_cast<std::size_t>(visit.tube)];
      order.push_back(addressText({"A", Leg::kCold, tube.row, tube.column}));
    }
  });
  const JobPart part{"few", "A", Leg::kCold};
  for (const std::string& tube : order) {
    const auto next = findNext(store, part);
    ASSERT_TRUE(next);
    EXPECT_EQ(addressText(next->tube), tube);
    (void)markTube(store, {next->tube, "few", "done", {"Tom", "", ""}, std::nullopt});
  }
  EXPECT_FALSE(findNext(store, part));
}

TEST_F(PlannedJob, PlannedAgainAfterMarksHoldsOnlyWhatIsLeft) {
  JobStore store(made(kPackages));
  const auto ignore = [](const std::string&, const PlanRequest&, const PlanOutcome&) {};
  (void)planJob(store, 1, {}, ignore);
  (void)markTube(store, {{"A", Leg::kHot, 9, 18}, "few", "done", {"Tom", "", ""}, std::nullopt});
  (void)markTube(store, {{"A", Leg::kHot, 9, 19}, "few", "retest", {"Tom", "", ""}, std::nullopt});
  const JobPlan again = planJob(store, 1, {}, ignore);
  for (const LegPlan& leg : again.legs)
    if (leg.leg == Leg::kHot) EXPECT_EQ(leg.packages.front().visits, 7);
}

TEST_F(PlannedJob, TheScheduleCoversAllLegs) {
  JobStore store(made(kPackages));
  const JobPlan plan = planJob(store, 1, {}, [](const std::string&, const PlanRequest&, const PlanOutcome&) {});
  const nlohmann::json json = jobPlanJson(plan, store.job());
  double sum = 0;
  for (const auto& leg : json["legs"]) sum += leg["total_s"].get<double>();
  EXPECT_NEAR(json["end_s"].get<double>(), sum, 1e-6);  // one arm does one leg after the other
  EXPECT_EQ(json["schedule"], "optimal");
  double parts = 0, shares = 0;
  for (const auto& part : json["times"]) {
    parts += part["time_s"].get<double>();
    shares += part["share"].get<double>();
  }
  EXPECT_NEAR(parts, sum, 1e-6);
  EXPECT_NEAR(shares, 1, 1e-12);
}

TEST_F(PlannedJob, LegsThatAreApartHaveNoTwoArmsAtOnce) {
  (void)write("states.csv", "row,column,state\n10,20,plugged\n");
  const std::string file =
      write("apart.yaml", changed(jobText(kPackages), "job: test\n", "job: test\narms: 2\napart: [[A/hot, A/cold]]\n"));
  const std::string path = (folder / "apart.record").string();
  JobStore::create(readJobFile(file), path);
  JobStore store(path);
  const JobPlan plan = planJob(store, 1, {}, [](const std::string&, const PlanRequest&, const PlanOutcome&) {});
  ASSERT_EQ(plan.legs.size(), 2u);
  EXPECT_EQ(plan.schedule.status, ScheduleStatus::kOptimal);
  EXPECT_NEAR(plan.schedule.end, plan.legs[0].total() + plan.legs[1].total(), 1e-6);
  const nlohmann::json json = jobPlanJson(plan, store.job());
  const auto& later = json["legs"][json["legs"][0]["wait"].is_null() ? 1 : 0];
  const auto& first = json["legs"][json["legs"][0]["wait"].is_null() ? 0 : 1];
  EXPECT_EQ(later["wait"]["for"], "A/" + first["leg"].get<std::string>());
  EXPECT_EQ(later["start_s"], first["end_s"]);
}

}  // namespace
}  // namespace tubeplan::app
