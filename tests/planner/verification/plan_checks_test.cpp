#include "planner/verification/plan_checks.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "deflection/effects/effect.hpp"
#include "tests/planner/verification/plan_alterations.hpp"
#include "tests/planner/verification/stated_plan.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d, Eigen::VectorXd;
using testing::deflectedTip;
using testing::Generator;
using testing::kAlterations;
using testing::mockup;
using testing::pick;
using testing::sideways;
using testing::sign;
using testing::statedPlan;
using testing::Work;

VisitPlan planFor(const Workcell& cell, Compensation mode) {
  VisitPlanOptions options;
  options.reach.compensation.mode = mode;
  return planVisits(cell, testing::tubesOf(cell, "R39C58,R3C10,R10C95,R20C40,R30C70,R45C50"), options);
}

class Checked : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    work_ = std::make_unique<Work>();
    work_->cell = mockup();
    plan_ = std::make_unique<VisitPlan>(planFor(work_->cell, Compensation::kViaPoint));
    work_->plan = statedPlan(work_->cell, *plan_);
  }
  static void TearDownTestSuite() {
    work_.reset();
    plan_.reset();
  }
  static inline std::unique_ptr<Work> work_;
  static inline std::unique_ptr<VisitPlan> plan_;
};

TEST_F(Checked, AnUntouchedPlanIsProvedWithThePlannersOwnFigures) {
  const PlanCheck check = checkPlan(work_->cell, work_->plan);
  EXPECT_EQ(check.status, PlanCheckStatus::kProved) << check.findings.front();
  EXPECT_EQ(check.tubes, 5);
  EXPECT_EQ(check.rows, static_cast<int>(work_->plan.path.size()));
  EXPECT_LT(check.worst_centring, 1e-6 * kInch);
  EXPECT_LE(check.worst_approach, 0.0011 * kInch);
  EXPECT_GT(check.worst_approach, 0);
  EXPECT_NEAR(check.worst_speed_share, 1, 1e-9);
  EXPECT_NEAR(check.worst_acceleration_share, 1, 1e-6);
  // Both proofs give lower bounds of the same smallest margin, each within 0.010 in.
  EXPECT_NEAR(check.least_margin, plan_->min_margin, 0.011 * kInch);
  EXPECT_GE(check.least_margin, 0);
  EXPECT_FALSE(check.tightest.empty());
}

TEST_F(Checked, EveryAlterationThatBreaksARuleIsCaught) {
  constexpr int kRounds = 4;
  int altered = 0;
  for (const auto& alteration : kAlterations) {
    int counted = 0;
    // Alterations that break no rule are drawn again; 40 draws suffice for each kind.
    for (std::uint64_t seed = 1; seed <= 40 && counted < kRounds; ++seed) {
      Generator generator(seed);
      Work work = *work_;
      if (!alteration.apply(work, generator)) continue;
      ++counted;
      const PlanCheck check = checkPlan(work.cell, work.plan);
      EXPECT_EQ(check.status, PlanCheckStatus::kRefuted) << alteration.name << ", seed " << seed;
      EXPECT_EQ(check.findings.empty(), check.status == PlanCheckStatus::kProved);
    }
    EXPECT_GT(counted, 0) << alteration.name << " never breaks anything";
    altered += counted;
  }
  EXPECT_GE(altered, 100);
}

TEST_F(Checked, WhatIsLetPassBreaksNoRule) {
  // If a random row is changed by a hundredth of a degree and the check still proves the plan, the tip is on the axis
  // and no joint is too fast.
  const JointSpeeds limits = jointSpeedsOf(work_->cell.arm);
  int passed = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Generator generator(seed);
    StatedPlan plan = work_->plan;
    const auto k = static_cast<std::size_t>(1 + pick(generator, plan.path.size() - 2));
    plan.path[k].q[pick(generator, 4)] += sign(generator) * 0.01 * kDegree;
    if (checkPlan(work_->cell, plan).status != PlanCheckStatus::kProved) continue;
    ++passed;
    const PathRow &before = plan.path[k - 1], &row = plan.path[k], &after = plan.path[k + 1];
    const auto tooFast = [&](const PathRow& a, const PathRow& b) {
      return ((b.q - a.q).cwiseAbs().array() / limits.max_speed.array() > (b.time - a.time) * (1 + 1e-8)).any();
    };
    EXPECT_FALSE(tooFast(before, row) || tooFast(row, after));
    if (row.kind != SegmentKind::kTravel) {
      const Vector3d& hole = plan.tubes[static_cast<std::size_t>(row.segment) / 3].hole_W;
      EXPECT_LE(sideways(deflectedTip(work_->cell, row.q), hole), 0.0011 * kInch);
    }
  }
  EXPECT_GT(passed, 0);
}

TEST_F(Checked, FindingsSayWhere) {
  const auto firstFinding = [&](const std::function<void(Work&)>& alter) {
    Work work = *work_;
    alter(work);
    const PlanCheck check = checkPlan(work.cell, work.plan);
    return check.findings.empty() ? std::string() : check.findings.front();
  };
  const auto& first = work_->plan.tubes.front();
  const std::string name = tubesheets::tubeName(first.row, first.column);
  EXPECT_EQ(firstFinding([](Work& work) { work.plan.tubes[0].hole_W.x() += 1e-5; }),
            name + ": the stated hole is not at the sheet's position");
  EXPECT_EQ(firstFinding([](Work& work) { work.plan.tubes[0].column = 500; }),
            "R" + std::to_string(first.row) + "C500 is not on this sheet");
  EXPECT_EQ(firstFinding([](Work& work) { work.plan.path[7].time = 0; }), "path row 8: time does not rise");
  EXPECT_EQ(firstFinding([](Work& work) { work.plan.path.clear(); }), "the path approaches 0 of 5 tubes");
  EXPECT_EQ(firstFinding([](Work& work) { work.plan.path.front().segment = 3; }), "path row 1: segments out of order");
}

TEST_F(Checked, JointLimitsHoldInEveryRow) {
  Work work = *work_;
  double highest = -10, lowest = 10;
  for (const auto& row : work.plan.path) highest = std::max(highest, row.q[0]), lowest = std::min(lowest, row.q[0]);
  auto& joint = work.cell.arm.rows[2].joint;
  joint.lower = lowest;
  joint.upper = highest;
  ASSERT_LT(lowest, 0);
  ASSERT_GT(highest, 0);
  EXPECT_EQ(checkPlan(work.cell, work.plan).status, PlanCheckStatus::kProved);
  for (auto* limit : {&joint.lower, &joint.upper}) {
    const double before = *limit;
    *limit *= 1 - 1e-6;
    const PlanCheck check = checkPlan(work.cell, work.plan);
    *limit = before;
    ASSERT_EQ(check.status, PlanCheckStatus::kRefuted);
    EXPECT_NE(check.findings.front().find("theta1 is past its limit"), std::string::npos) << check.findings.front();
  }
}

TEST_F(Checked, OnlyAnApproachAndARetreatHaveLeaveToTouch) {
  Work work = *work_;
  for (auto& row : work.plan.path)
    if (row.segment == 2) row.kind = SegmentKind::kRetreat;
  PlanCheckOptions options;
  options.via_points = false;
  const PlanCheck check = checkPlan(work.cell, work.plan, options);
  ASSERT_EQ(check.status, PlanCheckStatus::kRefuted);
  EXPECT_NE(check.findings.front().find("segment 3 cannot be a retreat"), std::string::npos) << check.findings.front();
}

/// Returns an arm of two thin links, each 1 m long, that rotate in a plane, and an otherwise empty cell.
Workcell twoLinks() {
  Workcell cell;
  for (const char* name : {"link1", "link2"}) {
    deflection::Row<double> row;
    row.name = name;
    row.placement = deflection::DenavitHartenberg<double>{.a = cell.arm.rows.empty() ? 0. : 1.};
    row.joint = {.name = name, .type = deflection::JointType::kRevolute, .max_speed = 1};
    cell.arm.rows.push_back(row);
    cell.scene.links.push_back({name, true});
    cell.scene.bodies.push_back({name,
                                 static_cast<int>(cell.arm.rows.size()) - 1,
                                 "",
                                 testing::shape("capsule", {0, 0, 0, 1, 0, 0, 0.01}),
                                 {}});
  }
  cell.arm.p_LT = Vector3d::UnitX();
  return cell;
}

TEST(CheckPlan, NothingThinIsSteppedOverHoweverFarApartTheRowsAre) {
  // The first joint sweeps the stretched arm, or the second joint the last link, past a needle. The check must find the
  // needle if the arm's end touches it, and must not if it is just out of reach.
  for (int joint : {0, 1})
    for (double step : {0.02, 0.1, 0.5, 1.5})
      for (double where : {0.3, 0.5, 0.8}) {
        StatedPlan plan;
        plan.path = {{0, 0, SegmentKind::kApproach, Eigen::Vector2d::Zero()},
                     {10, 0, SegmentKind::kApproach, step * Eigen::Vector2d::Unit(joint)}};
        const double length = joint == 0 ? 2 : 1;
        for (const double beyond : {0.005, 0.015}) {
          const double reach = length + beyond, angle = where * step;
          const Vector3d p(reach * std::cos(angle) + 2 - length, reach * std::sin(angle), 0);
          const Workcell cell =
              testing::withObstacle(twoLinks(), {"needle", testing::shape("sphere", {p.x(), p.y(), p.z(), 1e-3}), {}});
          const PlanCheck check = checkPlan(cell, plan);
          const bool found = std::ranges::any_of(check.findings, [](const std::string& f) {
            return f.find("too near: link2, needle") != std::string::npos;
          });
          EXPECT_EQ(found, beyond < 0.011) << joint << " " << step << " " << where;
        }
      }
}

/// Returns the arm with a linkage that rotates the second link by `ratio` times the first joint's angle.
Workcell linked(double ratio) {
  Workcell cell = twoLinks();
  cell.arm.rows[1].joint = {.name = "linkage", .type = deflection::JointType::kPassive, .follows = {{0, ratio}}};
  return cell;
}

TEST(CheckPlan, NothingThinIsSteppedOverByALinkTurnedWithAnother) {
  for (double ratio : {-6., 1., 5.})
    for (double step : {0.1, 0.3, 0.6})
      for (double where : {0.3, 0.5, 0.8}) {
        StatedPlan plan;
        plan.path = {{0, 0, SegmentKind::kApproach, VectorXd::Constant(1, 0)},
                     {10, 0, SegmentKind::kApproach, VectorXd::Constant(1, step)}};
        const double first = where * step, second = (1 + ratio) * first;
        const Vector3d p(std::cos(first) + 1.005 * std::cos(second), std::sin(first) + 1.005 * std::sin(second), 0);
        const auto cell =
            testing::withObstacle(linked(ratio), {"needle", testing::shape("sphere", {p.x(), p.y(), p.z(), 1e-3}), {}});
        const PlanCheck check = checkPlan(cell, plan);
        const bool found = std::ranges::any_of(check.findings, [](const std::string& f) {
          return f.find("too near: link2, needle") != std::string::npos;
        });
        EXPECT_TRUE(found) << ratio << " " << step << " " << where;
      }
}

TEST(CheckPlan, SaysWhereTheTravelThatDeflectionAddsIsSampled) {
  Workcell cell = twoLinks();
  StatedPlan plan;
  plan.path = {{0, 0, SegmentKind::kApproach, VectorXd::Zero(2)}};
  EXPECT_EQ(checkPlan(cell, plan).deflection_travel_sampled, "");
  auto effect = deflection::makeEffect(cell.arm, "joint-offset", "link2").effect;
  effect.values = {0.001};
  cell.arm.effects.push_back(effect);
  EXPECT_EQ(checkPlan(cell, plan).deflection_travel_sampled, "the arm has effects beyond its elements");
}

TEST_F(Checked, ALeaveThatTheToolsBodyStatesEndsOnTravelAsInThePlan) {
  Work work = *work_;
  for (auto& obstacle : work.cell.scene.obstacles) std::erase(obstacle.allow, "tool-tip");
  for (auto& body : work.cell.scene.bodies)
    if (body.name == "tool-tip") body.allow = {"tubesheet"};
  EXPECT_EQ(checkPlan(work.cell, work.plan).status, PlanCheckStatus::kProved);
  Generator generator(1);
  testing::driveThroughTheSheet(work, generator);
  const PlanCheck check = checkPlan(work.cell, work.plan);
  const bool named = std::ranges::any_of(check.findings, [](const std::string& finding) {
    return finding.find("too near: tool-tip, tubesheet") != std::string::npos;
  });
  EXPECT_TRUE(named);
}

TEST_F(Checked, OtherModesAreHeldToWhatTheyPromise) {
  const Work goal{work_->cell, statedPlan(work_->cell, planFor(work_->cell, Compensation::kGoalPoint))};
  PlanCheckOptions options;
  EXPECT_EQ(checkPlan(goal.cell, goal.plan, options).status, PlanCheckStatus::kRefuted);
  options.via_points = false;
  const PlanCheck loose = checkPlan(goal.cell, goal.plan, options);
  EXPECT_EQ(loose.status, PlanCheckStatus::kProved);
  EXPECT_GT(loose.worst_approach, 0.003 * kInch);
  const Work none{work_->cell, statedPlan(work_->cell, planFor(work_->cell, Compensation::kNone))};
  EXPECT_EQ(checkPlan(none.cell, none.plan, options).status, PlanCheckStatus::kRefuted);
  options.centring_tolerance = 1;
  const PlanCheck missing = checkPlan(none.cell, none.plan, options);
  EXPECT_EQ(missing.status, PlanCheckStatus::kProved);
  EXPECT_GT(missing.worst_centring, 0.05 * kInch);
}

TEST_F(Checked, FindingsAreCountedOnlySoFar) {
  Work work = *work_;
  work.cell.X_WB.translation().z() += 1;
  EXPECT_EQ(checkPlan(work.cell, work.plan).findings.size(), 100u);
}

TEST_F(Checked, AStopIsNoProof) {
  PlanHooks hooks;
  hooks.stop = [] { return true; };
  const PlanCheck check = checkPlan(work_->cell, work_->plan, {}, hooks);
  EXPECT_EQ(check.status, PlanCheckStatus::kRefuted);
  EXPECT_EQ(check.findings.back(), "stopped before the clearance was proved");
}

// A row 1e6 rad away is refuted without bisecting the move to it, which once took six minutes (a plan found by
// fuzzing).
TEST_F(Checked, ARowFarPastItsLimitIsRefutedAtOnce) {
  Work work = *work_;
  work.plan.path[7].q[0] = 1e6;
  int calls = 0;
  PlanHooks hooks;
  hooks.stop = [&] { return ++calls > 100000; };
  const PlanCheck check = checkPlan(work.cell, work.plan, {}, hooks);
  EXPECT_EQ(check.findings.front(), "path row 8: theta1 is past its limit");
  EXPECT_LT(calls, 100000);
}

TEST(CheckPlan, IsStoppedBetweenTwoRowsThatAreFarApart) {
  const Workcell cell = testing::withObstacle(twoLinks(), {"needle", testing::shape("sphere", {2.1, 0, 0, 1e-3}), {}});
  StatedPlan plan;
  plan.path = {{0, 0, SegmentKind::kApproach, Eigen::Vector2d(0.1, 0)},
               {10, 0, SegmentKind::kApproach, Eigen::Vector2d(1e9, 0)}};
  int calls = 0;
  PlanHooks hooks;
  hooks.stop = [&] { return ++calls > 1000; };
  EXPECT_EQ(checkPlan(cell, plan, {}, hooks).findings.back(), "stopped before the clearance was proved");
  EXPECT_LT(calls, 1100);
}

}  // namespace
}  // namespace tubeplan::planner
