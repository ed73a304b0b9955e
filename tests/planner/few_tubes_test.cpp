// Plans for a few tubes: no other order of the tubes is quicker, by more than 1 %, than the order that the plan
// chooses.
#include "planner/few_tubes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/planner/plan_bytes.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using testing::bytesOf;
using testing::mockup;

/// Three tubes, each of which the arm reaches in many postures; most straight moves between these postures are blocked.
class ThreeTubes : public ::testing::Test {
 protected:
  const Workcell cell_ = mockup("tsm-cobra.yaml");
  std::vector<int> tubes_ = testing::tubesOf(cell_, "R6C111,R31C41,R40C50");
};

TEST_F(ThreeTubes, AreOrderedAsWellAsByAnyGivenOrder) {
  ASSERT_EQ(tubes_.size(), 3u);
  PlanCache cache;
  const VisitPlan chosen = planVisits(cell_, tubes_, {}, {}, cache);
  ASSERT_EQ(chosen.status, VisitPlanStatus::kPlanned) << chosen.reason;
  EXPECT_GE(chosen.travel_time, chosen.lower_bound - 1e-9);
  cache.orders.clear();
  std::vector<int> given = tubes_;
  do {
    if (given.front() > given.back()) continue;  // a reversed order takes the same time
    VisitPlanOptions options;
    for (const int tube : given) options.conditions.zones.push_back({tube});
    PlanCache known = cache;
    const VisitPlan forced = planVisits(cell_, tubes_, options, {}, known);
    ASSERT_EQ(forced.status, VisitPlanStatus::kPlanned) << forced.reason;
    for (std::size_t k = 0; k < given.size(); ++k) EXPECT_EQ(forced.visits[k].tube, given[k]);
    EXPECT_LE(chosen.travel_time, 1.01 * forced.travel_time);
    EXPECT_LE(chosen.lower_bound, forced.lower_bound + 1e-9);
  } while (std::next_permutation(given.begin(), given.end()));
}

TEST_F(ThreeTubes, AreOrderedAsWellAsByALongSearch) {
  PlanCache cache;
  const VisitPlan chosen = planVisits(cell_, tubes_, {}, {}, cache);
  cache.orders.clear();
  VisitPlanOptions options;
  options.order.most_exact_work = 0;  // uses the local search instead of the exact search
  options.reprice_rounds = 1000;
  const VisitPlan searched = planVisits(cell_, tubes_, options, {}, cache);
  EXPECT_LE(chosen.travel_time, 1.01 * searched.travel_time);
}

TEST_F(ThreeTubes, HaveTheSamePlanWhateverTravelsAreRemembered) {
  PlanCache cache;
  const std::string plan = bytesOf(planVisits(cell_, tubes_, {}, {}, cache));
  PlanCache travels;
  travels.travels = cache.travels;
  EXPECT_EQ(bytesOf(planVisits(cell_, tubes_, {}, {}, travels)), plan);
}

}  // namespace
}  // namespace tubeplan::planner
