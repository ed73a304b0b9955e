// The plan of a job: every leg planned, the visiting order recorded, and times that add up.
#include "app/outage/job_plan.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "app/outage/job_desk.hpp"
#include "app/outage/job_plan_json.hpp"
#include "app/storage/input_error.hpp"
#include "tests/app/outage/job_fixture.hpp"

namespace tubeplan::app {
namespace {

using tubesheets::Leg;

constexpr const char* kPackages =
    "  - {name: few, tubes: 'R9-11C18-20', steam_generators: [A], tool: bobbin, length: 720, dwell_s: 2, confirm: "
    "none}\n"
    "  - {name: edge, tubes: 'spread:5', steam_generators: [A], tool: bobbin, confirm: none}\n";

const KeepPackagePlan kIgnore = [](const std::string&, const PlanRequest&, const PlanOutcome&, const PlanCheckpoint&) {
};

class PlannedJob : public JobTest {
 protected:
  /// Keeps what the next plan of each package can reuse, as `job plan` does.
  [[nodiscard]] KeepPackagePlan keptIn(const std::string& plans) {
    return [this, plans](const std::string& name, const PlanRequest&, const PlanOutcome& outcome,
                         const PlanCheckpoint& checkpoint) {
      std::filesystem::create_directories(folder / plans / name);
      (void)write(plans + "/" + name + "/memory.json", checkpoint.text());
      outcomes_.insert_or_assign(name, outcome);
    };
  }

  std::map<std::string, PlanOutcome> outcomes_;  ///< outcome of each package planned last, by its folder
};

TEST_F(PlannedJob, EveryOpenItemIsPlannedOrSaidToBeOutOfReach) {
  JobStore store(made(kPackages));
  int kept = 0;
  const JobPlan plan = planJob(
      store, {}, {}, [&](const std::string&, const PlanRequest&, const PlanOutcome& outcome, const PlanCheckpoint&) {
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
  (void)planJob(store, {}, {},
                [&](const std::string& folder, const PlanRequest&, const PlanOutcome& outcome, const PlanCheckpoint&) {
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
  (void)planJob(store, {}, {}, kIgnore);
  (void)markTube(store, {{"A", Leg::kHot, 9, 18}, "few", "done", {"Tom", "", ""}, std::nullopt});
  (void)markTube(store, {{"A", Leg::kHot, 9, 19}, "few", "retest", {"Tom", "", ""}, std::nullopt});
  const JobPlan again = planJob(store, {}, {}, kIgnore);
  for (const LegPlan& leg : again.legs) {
    if (leg.leg == Leg::kHot) EXPECT_EQ(leg.packages.front().visits, 7);
  }
}

TEST_F(PlannedJob, PlannedAgainItReusesWhatIsStillValid) {
  JobStore store(made(kPackages));
  JobPlanRequest request;
  request.earlier = folder / "plans";
  for (const PackagePlan& package : planJob(store, request, {}, keptIn("plans")).legs.front().packages)
    EXPECT_EQ(package.reused, "");
  const auto done = findNext(store, {"few", "A", Leg::kHot});
  ASSERT_TRUE(done);
  (void)markTube(store, {done->tube, "few", "done", {"Tom", "", ""}, std::nullopt});
  const JobPlan again = planJob(store, request, {}, keptIn("plans"));
  int reused = 0;
  for (const LegPlan& leg : again.legs)
    for (const PackagePlan& package : leg.packages) {
      const PlanOutcome& outcome = outcomes_.at(package.folder);
      EXPECT_EQ(outcome.plan.kept.reach,
                static_cast<int>(outcome.plan.visits.size() + outcome.plan.unreachable.size()));
      reused += !package.reused.empty();
    }
  EXPECT_EQ(reused, 4);
}

TEST_F(PlannedJob, IsPlannedAgainFromTheTubeWhereTheArmStands) {
  JobStore store(made(kPackages));
  JobPlanRequest request;
  request.earlier = folder / "plans";
  (void)planJob(store, request, {}, keptIn("plans"));
  const JobPart part{"few", "A", Leg::kHot};
  const TubeAddress stands = findNext(store, part)->tube;
  (void)markTube(store, {stands, "few", "done", {"Tom", "", ""}, std::nullopt});
  request.part = part;
  request.start = tubesheets::tubeName(stands.row, stands.column);
  outcomes_.clear();
  const JobPlan again = planJob(store, request, {}, keptIn("plans"));
  ASSERT_EQ(outcomes_.size(), 1u);  // no other package is planned
  const PlanOutcome& outcome = outcomes_.begin()->second;
  EXPECT_EQ(again.legs.front().packages.front().visits, 7);
  EXPECT_EQ(outcome.model.sheet.indexOf(stands.row, stands.column), outcome.plan.departed);
  const auto next = findNext(store, part);
  const auto& first = outcome.model.sheet.tubes[static_cast<std::size_t>(outcome.plan.visits.front().tube)];
  EXPECT_EQ(next->tube.row, first.row);
  EXPECT_EQ(next->tube.column, first.column);
}

TEST_F(PlannedJob, AStartNeedsOneLegAndATubeOfTheEarlierPlan) {
  JobStore store(made(kPackages));
  JobPlanRequest request;
  request.start = "R9C18";
  EXPECT_THROW((void)planJob(store, request, {}, kIgnore), InputError);
  request.part = {"", "A", Leg::kHot};
  EXPECT_THROW((void)planJob(store, request, {}, kIgnore), InputError);  // it has not been planned yet
}

TEST_F(PlannedJob, WhereNothingIsLeftNothingIsPlanned) {
  JobStore store(
      made("  - {name: one, tubes: R9C18, steam_generators: [A], legs: [hot], tool: bobbin, confirm: none}\n"));
  (void)markTube(store, {{"A", Leg::kHot, 9, 18}, "one", "done", {"Tom", "", ""}, std::nullopt});
  EXPECT_TRUE(planJob(store, {}, {}, kIgnore).legs.empty());
}

TEST_F(PlannedJob, TheScheduleCoversAllLegs) {
  JobStore store(made(kPackages));
  const JobPlan plan = planJob(store, {}, {}, kIgnore);
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

TEST_F(PlannedJob, TwoPackagesWithOneToolMountItOnceInALeg) {
  JobStore store(made(kPackages));
  const JobPlan plan = planJob(store, {}, {}, kIgnore);
  for (const LegPlan& leg : plan.legs) {
    double changes = 0;
    for (const PackagePlan& package : leg.packages) changes += package.change;
    EXPECT_EQ(changes, 900);
  }
}

TEST_F(PlannedJob, LegsThatAreApartHaveNoTwoArmsAtOnce) {
  (void)write("states.csv", "row,column,state\n10,20,plugged\n");
  const std::string file =
      write("apart.yaml", changed(jobText(kPackages), "job: test\n", "job: test\narms: 2\napart: [[A/hot, A/cold]]\n"));
  const std::string path = (folder / "apart.record").string();
  JobStore::create(readJobFile(file), path);
  JobStore store(path);
  const JobPlan plan = planJob(store, {}, {}, kIgnore);
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
