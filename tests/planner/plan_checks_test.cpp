#include "planner/plan_checks.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "planner/arm_clearance.hpp"
#include "workcell.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d, Eigen::VectorXd;
using testing::deflectedTip;
using testing::kDegree;
using testing::kInch;
using testing::mockup;
using testing::sideways;
using testing::uniform;

using Generator = std::mt19937_64;

StatedPlan statedPlan(const Workcell& cell, const VisitPlan& plan) {
  StatedPlan stated;
  for (const auto& visit : plan.visits) {
    const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(visit.tube)];
    stated.tubes.push_back({tube.row, tube.column, holeCentre(tube), visit.branch.q, visit.branch.predicted_tip_W});
  }
  for (const auto& missed : plan.unreachable) {
    const auto& tube = cell.sheet.tubes[static_cast<std::size_t>(missed.tube)];
    stated.unreachable.emplace_back(tube.row, tube.column);
  }
  stated.path = samplePath(plan, jointSpeedsOf(cell.arm));
  return stated;
}

VisitPlan planFor(const Workcell& cell, Compensation mode) {
  VisitPlanOptions options;
  options.reach.compensation.mode = mode;
  return planVisits(cell, testing::tubesOf(cell, "R39C58,R3C10,R10C95,R20C40,R30C70,R45C50"), options);
}

/// A cell and a plan for it, to be altered.
struct Work {
  Workcell cell;
  StatedPlan plan;
};

int pick(Generator& generator, std::size_t count) { return static_cast<int>(generator() % count); }
double sign(Generator& generator) { return generator() % 2 ? 1 : -1; }

/// Places in the path of all rows for which `wanted` holds.
std::vector<std::size_t> rowsWhere(const StatedPlan& plan, const std::function<bool(std::size_t)>& wanted) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < plan.path.size(); ++k)
    if (wanted(k)) rows.push_back(k);
  return rows;
}

std::size_t anyRow(const StatedPlan& plan, SegmentKind kind, Generator& generator) {
  const auto rows = rowsWhere(plan, [&](std::size_t k) { return plan.path[k].kind == kind; });
  return rows[static_cast<std::size_t>(pick(generator, rows.size()))];
}

/// Removes rows first..last - 1; time and segment numbers close up, as if they had never been.
void cutOut(StatedPlan& plan, std::size_t first, std::size_t last, int segments) {
  const double time = plan.path[last - 1].time - (first > 0 ? plan.path[first - 1].time : 0);
  for (std::size_t k = last; k < plan.path.size(); ++k) {
    plan.path[k].time -= time;
    plan.path[k].segment -= segments;
  }
  plan.path.erase(plan.path.begin() + static_cast<std::ptrdiff_t>(first), plan.path.begin() + static_cast<std::ptrdiff_t>(last));
}

std::size_t firstRowOf(const StatedPlan& plan, int segment) {
  return rowsWhere(plan, [&](std::size_t k) { return plan.path[k].segment >= segment; }).front();
}

Vector3d direction(Generator& generator) { return testing::uniformPose(generator, 1).linear().col(0); }

/// An alteration that breaks a rule. False: this time it would not have, so it does not count.
struct Alteration {
  const char* name;
  bool (*apply)(Work& work, Generator& generator);
};

bool turnTubeJoint(Work& work, Generator& generator) {
  auto& tube = work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))];
  tube.q[pick(generator, 4)] += sign(generator) * 0.01 * kDegree;
  return true;
}

bool turnGoalRow(Work& work, Generator& generator) {
  const auto rows = rowsWhere(work.plan, [&](std::size_t k) {
    return work.plan.path[k].kind == SegmentKind::kApproach && work.plan.path[k + 1].kind == SegmentKind::kRetreat;
  });
  work.plan.path[rows[static_cast<std::size_t>(pick(generator, rows.size()))]].q[pick(generator, 4)] += sign(generator) * 0.01 * kDegree;
  return true;
}

/// Harmless where the tip moves so little, or so upright, that it may still be within the tolerance of the axis.
bool turnUpOrDownRow(Work& work, Generator& generator) {
  const auto kind = generator() % 2 ? SegmentKind::kApproach : SegmentKind::kRetreat;
  VectorXd& q = work.plan.path[anyRow(work.plan, kind, generator)].q;
  const Vector3d before = deflectedTip(work.cell, q);
  q[pick(generator, 4)] += sign(generator) * 0.01 * kDegree;
  return sideways(deflectedTip(work.cell, q), before) > 0.0022 * kInch;
}

/// The joint that sets the pace on a stretch at full speed: one of its neighbours is now too far in the time. Of the other joints and
/// stretches a hundredth of a degree asks nothing beyond the limits: the clearance there is proved for the altered path.
bool turnTheFastestJoint(Work& work, Generator& generator) {
  const JointSpeeds limits = jointSpeedsOf(work.cell.arm);
  auto& path = work.plan.path;
  const auto k = anyRow(work.plan, SegmentKind::kTravel, generator);
  if (path[k + 1].segment != path[k].segment || path[k - 1].segment != path[k].segment) return false;
  const auto joint = pick(generator, 4);
  const double share = std::abs(path[k].q[joint] - path[k - 1].q[joint]) / (path[k].time - path[k - 1].time) / limits.max_speed[joint];
  const double share_after = std::abs(path[k + 1].q[joint] - path[k].q[joint]) / (path[k + 1].time - path[k].time) / limits.max_speed[joint];
  path[k].q[joint] += sign(generator) * 0.01 * kDegree;
  return std::min(share, share_after) > 0.9999;
}

bool turnTravelRowFar(Work& work, Generator& generator) {
  work.plan.path[anyRow(work.plan, SegmentKind::kTravel, generator)].q[pick(generator, 4)] += sign(generator) * 3 * kDegree;
  return true;
}

bool turnOneWholeTurn(Work& work, Generator& generator) {
  work.plan.path[static_cast<std::size_t>(pick(generator, work.plan.path.size()))].q[pick(generator, 4)] += sign(generator) * 360 * kDegree;
  return true;
}

bool skipTubeInList(Work& work, Generator& generator) {
  work.plan.tubes.erase(work.plan.tubes.begin() + pick(generator, work.plan.tubes.size()));
  return true;
}

bool skipTubeInPath(Work& work, Generator& generator) {
  const int tube = pick(generator, work.plan.tubes.size() - 1);
  cutOut(work.plan, firstRowOf(work.plan, 3 * tube), firstRowOf(work.plan, 3 * tube + 3), 3);
  return true;
}

bool skipLastTubeInPath(Work& work, Generator&) {
  const int segment = 3 * static_cast<int>(work.plan.tubes.size() - 1) - 1;
  work.plan.path.resize(firstRowOf(work.plan, segment));
  return true;
}

bool skipRetreat(Work& work, Generator& generator) {
  const int segment = 3 * pick(generator, work.plan.tubes.size() - 1) + 1;
  cutOut(work.plan, firstRowOf(work.plan, segment), firstRowOf(work.plan, segment + 1), 1);
  return true;
}

bool repeatTube(Work& work, Generator& generator) {
  const auto tube = work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))];
  work.plan.tubes.insert(work.plan.tubes.begin() + pick(generator, work.plan.tubes.size() + 1), tube);
  return true;
}

bool swapTubes(Work& work, Generator& generator) {
  const auto count = work.plan.tubes.size();
  const auto a = static_cast<std::size_t>(pick(generator, count)), b = (a + 1 + static_cast<std::size_t>(pick(generator, count - 1))) % count;
  std::swap(work.plan.tubes[a], work.plan.tubes[b]);
  return true;
}

bool nameAnotherTube(Work& work, Generator& generator) {
  auto& tube = work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))];
  (generator() % 2 ? tube.row : tube.column) += generator() % 2 ? 1 : -1;
  return true;
}

bool moveStatedHole(Work& work, Generator& generator) {
  work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))].hole_W += 0.001 * kInch * direction(generator);
  return true;
}

bool moveStatedTip(Work& work, Generator& generator) {
  work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))].predicted_tip_W += 0.001 * kInch * direction(generator);
  return true;
}

bool losePlaceOfHole(Work& work, Generator& generator) {
  work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))].hole_W[pick(generator, 3)] = std::nan("");
  return true;
}

bool loseJointValue(Work& work, Generator& generator) {
  VectorXd& q = work.plan.path[static_cast<std::size_t>(pick(generator, work.plan.path.size()))].q;
  if (generator() % 2)
    q[pick(generator, 4)] = std::nan("");
  else
    q.conservativeResize(3);
  return true;
}

/// A ball as thick as a thumb where the tool or the forearm is at some time of the path.
bool standInTheWay(Work& work, Generator& generator) {
  const auto& row = work.plan.path[static_cast<std::size_t>(pick(generator, work.plan.path.size()))];
  const auto frames = bodyFrames(work.cell, row.q, nullptr);
  const Vector3d p = frames[generator() % 2 ? 5 : 4] * Vector3d(uniform(generator, 0.2, 0.4), 0, 0);
  work.cell = testing::withObstacle(work.cell, {"visitor", testing::shape("sphere", {p.x(), p.y(), p.z(), 0.01}), {}});
  return true;
}

/// A needle where the thin tool-tip passes midway between two rows, far enough apart for neither to touch it.
bool standBetweenRows(Work& work, Generator& generator) {
  const auto k = anyRow(work.plan, SegmentKind::kTravel, generator);
  const auto needleAt = [&](const VectorXd& q) -> Vector3d {
    return bodyFrames(work.cell, q, nullptr)[5] * Vector3d(16.25 * kInch, 4 * kInch, 0);
  };
  const VectorXd &before = work.plan.path[k - 1].q, &after = work.plan.path[k].q;
  const Vector3d p = needleAt((before + after) / 2);
  work.cell = testing::withObstacle(work.cell, {"needle", testing::shape("sphere", {p.x(), p.y(), p.z(), 1e-4}), {}});
  work.cell.scene.clearance = 0;
  return std::min(sideways(needleAt(before), p), sideways(needleAt(after), p)) > 0.35 * kInch;
}

bool askForMoreClearance(Work& work, Generator& generator) {
  work.cell.scene.clearance += uniform(generator, 0.05, 0.5) * kInch;
  return true;
}

bool moveBase(Work& work, Generator& generator) {
  work.cell.X_WB.translation() += 0.001 * kInch * direction(generator);
  return true;
}

bool turnBase(Work& work, Generator& generator) {
  work.cell.X_WB.linear() = Eigen::AngleAxisd(0.001 * kDegree, direction(generator)).toRotationMatrix() * work.cell.X_WB.linear();
  return true;
}

bool softenJoint(Work& work, Generator& generator) {
  auto& stiffness = work.cell.arm.rows[generator() % 2 ? 4 : 5].joint_stiffness.z();
  stiffness *= 1 + sign(generator) * 0.01;
  return true;
}

bool hangLoad(Work& work, Generator& generator) {
  work.cell.load = uniform(generator, 0.1, 10);
  return true;
}

bool playFaster(Work& work, Generator&) {
  for (auto& row : work.plan.path) row.time *= 0.99;
  return true;
}

bool stopTheClock(Work& work, Generator& generator) {
  const auto k = static_cast<std::size_t>(1 + pick(generator, work.plan.path.size() - 1));
  work.plan.path[k].time = work.plan.path[k - 1].time - (generator() % 2 ? 0 : 0.1);
  return true;
}

/// All rows between standoff and hole: what is left is one straight joint move. Harmless where that keeps to the axis.
bool leaveOutViaPoints(Work& work, Generator& generator) {
  const int tube = pick(generator, work.plan.tubes.size());
  const int segment = 3 * tube + (generator() % 2);
  auto& path = work.plan.path;
  const std::size_t first = firstRowOf(work.plan, segment);
  std::size_t last = first;
  while (last + 1 < path.size() && path[last + 1].segment == segment) ++last;
  const std::size_t before = first > 0 ? first - 1 : 0;
  const double off = sideways(deflectedTip(work.cell, (path[before].q + path[last].q) / 2), work.plan.tubes[static_cast<std::size_t>(tube)].hole_W);
  path.erase(path.begin() + static_cast<std::ptrdiff_t>(before + 1), path.begin() + static_cast<std::ptrdiff_t>(last));
  return off > 0.00112 * kInch;
}

bool loseGoalRow(Work& work, Generator& generator) {
  const std::size_t k = firstRowOf(work.plan, 3 * pick(generator, work.plan.tubes.size()) + 1) - 1;
  work.plan.path.erase(work.plan.path.begin() + static_cast<std::ptrdiff_t>(k));
  return true;
}

bool callTravelAnApproach(Work& work, Generator& generator) {
  const int segment = work.plan.path[anyRow(work.plan, SegmentKind::kTravel, generator)].segment;
  for (auto& row : work.plan.path)
    if (row.segment == segment) row.kind = generator() % 2 ? SegmentKind::kApproach : SegmentKind::kRetreat;
  return true;
}

bool renumberSegment(Work& work, Generator& generator) {
  work.plan.path[static_cast<std::size_t>(pick(generator, work.plan.path.size()))].segment += generator() % 2 ? 3 : -3;
  return true;
}

bool callVisitedUnreachable(Work& work, Generator& generator) {
  const auto& tube = work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))];
  work.plan.unreachable.emplace_back(tube.row, tube.column);
  return true;
}

bool callNoTubeUnreachable(Work& work, Generator& generator) {
  work.plan.unreachable.emplace_back(1 + pick(generator, 49), 1000);
  return true;
}

/// The path stays whole and slow enough, but the tip is dragged through the sheet between two holes.
bool driveThroughTheSheet(Work& work, Generator& generator) {
  const int segment = work.plan.path[anyRow(work.plan, SegmentKind::kTravel, generator)].segment;
  for (auto& row : work.plan.path) {
    row.time *= 20;
    if (row.segment != segment) continue;
    const Vector3d tip = deflectedTip(work.cell, row.q);
    CompensationOptions options;
    options.with_approach = false;
    const TubeBranch raised = compensateFrom(work.cell, {tip.x(), tip.y(), 0.002}, row.q, options);
    if (raised.status == deflection::BranchStatus::kConverged) row.q = raised.q;
  }
  return true;
}

constexpr Alteration kAlterations[] = {
    {"a tube's joint by 0.01 deg", turnTubeJoint},
    {"a joint of the row at the hole by 0.01 deg", turnGoalRow},
    {"a joint of a row up or down by 0.01 deg", turnUpOrDownRow},
    {"the fastest joint of a row by 0.01 deg", turnTheFastestJoint},
    {"a joint of a travel row by 3 deg", turnTravelRowFar},
    {"a joint of a row by a whole turn", turnOneWholeTurn},
    {"a tube missing in the list", skipTubeInList},
    {"a tube missing in the path", skipTubeInPath},
    {"the last tube missing in the path", skipLastTubeInPath},
    {"a retreat missing", skipRetreat},
    {"a tube twice", repeatTube},
    {"two tubes swapped", swapTubes},
    {"another tube's name", nameAnotherTube},
    {"a stated hole by 0.001 in", moveStatedHole},
    {"a stated tip by 0.001 in", moveStatedTip},
    {"a stated hole that is no number", losePlaceOfHole},
    {"a joint value missing", loseJointValue},
    {"an obstacle in the way", standInTheWay},
    {"a needle between two rows", standBetweenRows},
    {"more clearance asked for", askForMoreClearance},
    {"the base by 0.001 in", moveBase},
    {"the base by 0.001 deg", turnBase},
    {"a joint stiffness by 1 %", softenJoint},
    {"a load on the tip", hangLoad},
    {"time 1 % faster", playFaster},
    {"time standing still", stopTheClock},
    {"via points missing", leaveOutViaPoints},
    {"the row at the hole missing", loseGoalRow},
    {"a travel called an approach", callTravelAnApproach},
    {"a row in another segment", renumberSegment},
    {"a visited tube called unreachable", callVisitedUnreachable},
    {"no tube called unreachable", callNoTubeUnreachable},
    {"the tip dragged through the sheet", driveThroughTheSheet},
};

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
  // Both proofs are lower bounds of one and the same least margin, each good to 0.010 in.
  EXPECT_NEAR(check.least_margin, plan_->min_margin, 0.011 * kInch);
  EXPECT_GE(check.least_margin, 0);
  EXPECT_FALSE(check.tightest.empty());
}

TEST_F(Checked, EveryAlterationThatBreaksARuleIsCaught) {
  constexpr int kRounds = 4;
  int altered = 0;
  for (const auto& alteration : kAlterations) {
    int counted = 0;
    // Those that happen to break nothing are drawn again; 40 draws are plenty for each.
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
  // A hundredth of a degree in any row: where the check says proved, the tip is still on the axis and no joint is too fast.
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
  EXPECT_EQ(firstFinding([](Work& work) { work.plan.tubes[0].hole_W.x() += 1e-5; }), name + ": the stated hole is not where the sheet has it");
  EXPECT_EQ(firstFinding([](Work& work) { work.plan.tubes[0].column = 500; }), "R" + std::to_string(first.row) + "C500 is not on this sheet");
  EXPECT_EQ(firstFinding([](Work& work) { work.plan.path[7].time = 0; }), "path row 8: time does not rise");
  EXPECT_EQ(firstFinding([](Work& work) { work.plan.path.clear(); }), "the path approaches 0 of 5 tubes");
  EXPECT_EQ(firstFinding([](Work& work) { work.plan.path.front().segment = 3; }), "path row 1: segments out of order");
}

TEST_F(Checked, JointLimitsHoldInEveryRow) {
  Work work = *work_;
  double widest = 0;
  for (const auto& row : work.plan.path) widest = std::max(widest, row.q[0]);
  auto& joint = work.cell.arm.rows[2].joint;
  joint.upper = widest;
  EXPECT_EQ(checkPlan(work.cell, work.plan).status, PlanCheckStatus::kProved);
  joint.upper = widest - 1e-6;
  const PlanCheck check = checkPlan(work.cell, work.plan);
  ASSERT_EQ(check.status, PlanCheckStatus::kRefuted);
  EXPECT_NE(check.findings.front().find("theta1 is past its limit"), std::string::npos) << check.findings.front();
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

/// Two thin links of one metre that turn in a plane, and nothing else.
Workcell twoLinks() {
  Workcell cell;
  for (const char* name : {"link1", "link2"}) {
    deflection::Row<double> row;
    row.name = name;
    row.placement = deflection::DenavitHartenberg<double>{.a = cell.arm.rows.empty() ? 0. : 1.};
    row.joint = {.name = name, .type = deflection::JointType::kRevolute, .max_speed = 1};
    cell.arm.rows.push_back(row);
    cell.scene.links.push_back({name, true});
    cell.scene.bodies.push_back({name, static_cast<int>(cell.arm.rows.size()) - 1, "", testing::shape("capsule", {0, 0, 0, 1, 0, 0, 0.01}), {}});
  }
  cell.arm.p_LT = Vector3d::UnitX();
  return cell;
}

TEST(CheckPlan, NothingThinIsSteppedOverHoweverFarApartTheRowsAre) {
  // The arm stretched out sweeps by its first joint alone, or its last link by the second: over a needle at the very end, or beside it.
  for (int joint : {0, 1})
    for (double step : {0.02, 0.1, 0.5, 1.5})
      for (double where : {0.3, 0.5, 0.8}) {
        StatedPlan plan;
        plan.path = {{0, 0, SegmentKind::kApproach, Eigen::Vector2d::Zero()}, {10, 0, SegmentKind::kApproach, step * Eigen::Vector2d::Unit(joint)}};
        const double length = joint == 0 ? 2 : 1;
        for (const double beyond : {0.005, 0.015}) {
          const double reach = length + beyond, angle = where * step;
          const Vector3d p(reach * std::cos(angle) + 2 - length, reach * std::sin(angle), 0);
          const Workcell cell = testing::withObstacle(twoLinks(), {"needle", testing::shape("sphere", {p.x(), p.y(), p.z(), 1e-3}), {}});
          const PlanCheck check = checkPlan(cell, plan);
          const bool found = std::ranges::any_of(check.findings, [](const std::string& f) { return f.find("too near: link2, needle") != std::string::npos; });
          EXPECT_EQ(found, beyond < 0.011) << joint << " " << step << " " << where;
        }
      }
}

TEST_F(Checked, ALeaveThatTheToolsBodyStatesEndsOnTravelAsInThePlan) {
  Work work = *work_;
  for (auto& obstacle : work.cell.scene.obstacles) std::erase(obstacle.allow, "tool-tip");
  for (auto& body : work.cell.scene.bodies)
    if (body.name == "tool-tip") body.allow = {"tubesheet"};
  EXPECT_EQ(checkPlan(work.cell, work.plan).status, PlanCheckStatus::kProved);
  Generator generator(1);
  driveThroughTheSheet(work, generator);
  const PlanCheck check = checkPlan(work.cell, work.plan);
  const bool named = std::ranges::any_of(check.findings, [](const std::string& finding) { return finding.find("too near: tool-tip, tubesheet") != std::string::npos; });
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

}  // namespace
}  // namespace tubeplan::planner
