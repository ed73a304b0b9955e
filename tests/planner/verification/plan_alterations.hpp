// Alterations of a plan, or of its cell, that invalidate the plan.
#pragma once

#include <cmath>
#include <functional>
#include <random>

#include "planner/collision/arm_clearance.hpp"
#include "planner/verification/plan_checks.hpp"
#include "tests/planner/workcell.hpp"

namespace tubeplan::planner::testing {

using Eigen::Vector3d, Eigen::VectorXd;
using Generator = std::mt19937_64;

/// A cell and its plan, both to be altered.
struct Work {
  Workcell cell;
  StatedPlan plan;
};

inline int pick(Generator& generator, std::size_t count) { return static_cast<int>(generator() % count); }
inline double sign(Generator& generator) { return generator() % 2 ? 1 : -1; }

/// Returns the indices of the rows of the path for which `wanted` is true.
inline std::vector<std::size_t> rowsWhere(const StatedPlan& plan, const std::function<bool(std::size_t)>& wanted) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < plan.path.size(); ++k)
    if (wanted(k)) rows.push_back(k);
  return rows;
}

inline std::size_t anyRow(const StatedPlan& plan, SegmentKind kind, Generator& generator) {
  const auto rows = rowsWhere(plan, [&](std::size_t k) { return plan.path[k].kind == kind; });
  return rows[static_cast<std::size_t>(pick(generator, rows.size()))];
}

/// Removes rows first..last - 1, and adjusts the times and segment numbers of the later rows.
inline void cutOut(StatedPlan& plan, std::size_t first, std::size_t last, int segments) {
  const double time = plan.path[last - 1].time - (first > 0 ? plan.path[first - 1].time : 0);
  for (std::size_t k = last; k < plan.path.size(); ++k) {
    plan.path[k].time -= time;
    plan.path[k].segment -= segments;
  }
  plan.path.erase(plan.path.begin() + static_cast<std::ptrdiff_t>(first),
                  plan.path.begin() + static_cast<std::ptrdiff_t>(last));
}

inline std::size_t firstRowOf(const StatedPlan& plan, int segment) {
  return rowsWhere(plan, [&](std::size_t k) { return plan.path[k].segment >= segment; }).front();
}

inline Vector3d direction(Generator& generator) { return uniformPose(generator, 1).linear().col(0); }

/// Alteration that breaks a rule. `apply` returns false if no rule happens to be broken; the alteration is then
/// ignored.
struct Alteration {
  const char* name;
  bool (*apply)(Work& work, Generator& generator);
};

inline bool turnTubeJoint(Work& work, Generator& generator) {
  auto& tube = work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))];
  tube.q[pick(generator, 4)] += sign(generator) * 0.01 * kDegree;
  return true;
}

inline bool turnGoalRow(Work& work, Generator& generator) {
  const auto rows = rowsWhere(work.plan, [&](std::size_t k) {
    return work.plan.path[k].kind == SegmentKind::kApproach && work.plan.path[k + 1].kind == SegmentKind::kRetreat;
  });
  work.plan.path[rows[static_cast<std::size_t>(pick(generator, rows.size()))]].q[pick(generator, 4)] +=
      sign(generator) * 0.01 * kDegree;
  return true;
}

/// Changes a joint in a row of an approach or retreat. Returns false if the tip stays within the tolerance of the
/// hole's axis.
inline bool turnUpOrDownRow(Work& work, Generator& generator) {
  const auto kind = generator() % 2 ? SegmentKind::kApproach : SegmentKind::kRetreat;
  VectorXd& q = work.plan.path[anyRow(work.plan, kind, generator)].q;
  const Vector3d before = deflectedTip(work.cell, q);
  q[pick(generator, 4)] += sign(generator) * 0.01 * kDegree;
  return sideways(deflectedTip(work.cell, q), before) > 0.0022 * kInch;
}

/// Changes a random joint in a row of a travel. Returns false unless this joint moves at its speed limit before and
/// after the row, so that one of the two moves becomes too fast; otherwise the change may break no rule.
inline bool turnTheFastestJoint(Work& work, Generator& generator) {
  const JointSpeeds limits = jointSpeedsOf(work.cell.arm);
  auto& path = work.plan.path;
  const auto k = anyRow(work.plan, SegmentKind::kTravel, generator);
  if (path[k + 1].segment != path[k].segment || path[k - 1].segment != path[k].segment) return false;
  const auto joint = pick(generator, 4);
  const double share =
      std::abs(path[k].q[joint] - path[k - 1].q[joint]) / (path[k].time - path[k - 1].time) / limits.max_speed[joint];
  const double share_after =
      std::abs(path[k + 1].q[joint] - path[k].q[joint]) / (path[k + 1].time - path[k].time) / limits.max_speed[joint];
  path[k].q[joint] += sign(generator) * 0.01 * kDegree;
  return std::min(share, share_after) > 0.9999;
}

inline bool turnTravelRowFar(Work& work, Generator& generator) {
  work.plan.path[anyRow(work.plan, SegmentKind::kTravel, generator)].q[pick(generator, 4)] +=
      sign(generator) * 3 * kDegree;
  return true;
}

inline bool turnOneWholeTurn(Work& work, Generator& generator) {
  work.plan.path[static_cast<std::size_t>(pick(generator, work.plan.path.size()))].q[pick(generator, 4)] +=
      sign(generator) * 360 * kDegree;
  return true;
}

inline bool skipTubeInList(Work& work, Generator& generator) {
  work.plan.tubes.erase(work.plan.tubes.begin() + pick(generator, work.plan.tubes.size()));
  return true;
}

inline bool skipTubeInPath(Work& work, Generator& generator) {
  const int tube = pick(generator, work.plan.tubes.size() - 1);
  cutOut(work.plan, firstRowOf(work.plan, 3 * tube), firstRowOf(work.plan, 3 * tube + 3), 3);
  return true;
}

inline bool skipLastTubeInPath(Work& work, Generator&) {
  const int segment = 3 * static_cast<int>(work.plan.tubes.size() - 1) - 1;
  work.plan.path.resize(firstRowOf(work.plan, segment));
  return true;
}

inline bool skipRetreat(Work& work, Generator& generator) {
  const int segment = 3 * pick(generator, work.plan.tubes.size() - 1) + 1;
  cutOut(work.plan, firstRowOf(work.plan, segment), firstRowOf(work.plan, segment + 1), 1);
  return true;
}

inline bool repeatTube(Work& work, Generator& generator) {
  const auto tube = work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))];
  work.plan.tubes.insert(work.plan.tubes.begin() + pick(generator, work.plan.tubes.size() + 1), tube);
  return true;
}

inline bool swapTubes(Work& work, Generator& generator) {
  const auto count = work.plan.tubes.size();
  const auto a = static_cast<std::size_t>(pick(generator, count)),
             b = (a + 1 + static_cast<std::size_t>(pick(generator, count - 1))) % count;
  std::swap(work.plan.tubes[a], work.plan.tubes[b]);
  return true;
}

inline bool nameAnotherTube(Work& work, Generator& generator) {
  auto& tube = work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))];
  (generator() % 2 ? tube.row : tube.column) += generator() % 2 ? 1 : -1;
  return true;
}

inline bool moveStatedHole(Work& work, Generator& generator) {
  work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))].hole_W +=
      0.001 * kInch * direction(generator);
  return true;
}

inline bool moveStatedTip(Work& work, Generator& generator) {
  work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))].predicted_tip_W +=
      0.001 * kInch * direction(generator);
  return true;
}

inline bool losePlaceOfHole(Work& work, Generator& generator) {
  work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))].hole_W[pick(generator, 3)] =
      std::nan("");
  return true;
}

inline bool loseJointValue(Work& work, Generator& generator) {
  VectorXd& q = work.plan.path[static_cast<std::size_t>(pick(generator, work.plan.path.size()))].q;
  if (generator() % 2)
    q[pick(generator, 4)] = std::nan("");
  else
    q.conservativeResize(3);
  return true;
}

/// Puts a ball of 1 cm radius at the tool or the forearm in a random row of the path.
inline bool standInTheWay(Work& work, Generator& generator) {
  const auto& row = work.plan.path[static_cast<std::size_t>(pick(generator, work.plan.path.size()))];
  const auto frames = bodyFrames(work.cell, row.q, nullptr);
  const Vector3d p = frames[generator() % 2 ? 5 : 4] * Vector3d(uniform(generator, 0.2, 0.4), 0, 0);
  work.cell = withObstacle(work.cell, {"visitor", shape("sphere", {p.x(), p.y(), p.z(), 0.01}), {}});
  return true;
}

/// Puts a needle where the thin tool tip passes midway between two rows, in both of which the tip is too far away to
/// touch it.
inline bool standBetweenRows(Work& work, Generator& generator) {
  const auto k = anyRow(work.plan, SegmentKind::kTravel, generator);
  const auto needleAt = [&](const VectorXd& q) -> Vector3d {
    return bodyFrames(work.cell, q, nullptr)[5] * Vector3d(16.25 * kInch, 4 * kInch, 0);
  };
  const VectorXd &before = work.plan.path[k - 1].q, &after = work.plan.path[k].q;
  const Vector3d p = needleAt((before + after) / 2);
  work.cell = withObstacle(work.cell, {"needle", shape("sphere", {p.x(), p.y(), p.z(), 1e-4}), {}});
  work.cell.scene.clearance = 0;
  return std::min(sideways(needleAt(before), p), sideways(needleAt(after), p)) > 0.35 * kInch;
}

inline bool requireMoreClearance(Work& work, Generator& generator) {
  const ArmClearance before(work.cell);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& row : work.plan.path)
    least = std::min(
        least,
        before.at(row.q, row.kind == SegmentKind::kTravel ? ContactRule::kTravel : ContactRule::kApproach).margin);
  const double more = uniform(generator, 0.05, 0.5) * kInch;
  work.cell.scene.clearance += more;
  return more > least;
}

inline bool moveBase(Work& work, Generator& generator) {
  work.cell.X_WB.translation() += 0.001 * kInch * direction(generator);
  return true;
}

inline bool turnBase(Work& work, Generator& generator) {
  work.cell.X_WB.linear() =
      Eigen::AngleAxisd(0.001 * kDegree, direction(generator)).toRotationMatrix() * work.cell.X_WB.linear();
  return true;
}

inline bool softenJoint(Work& work, Generator& generator) {
  auto& stiffness = work.cell.arm.rows[generator() % 2 ? 4 : 5].joint_stiffness.z();
  stiffness *= 1 + sign(generator) * 0.01;
  return true;
}

inline bool hangLoad(Work& work, Generator& generator) {
  work.cell.load = uniform(generator, 0.1, 10);
  return true;
}

inline bool playFaster(Work& work, Generator&) {
  for (auto& row : work.plan.path) row.time *= 0.99;
  return true;
}

inline bool stopTheClock(Work& work, Generator& generator) {
  const auto k = static_cast<std::size_t>(1 + pick(generator, work.plan.path.size() - 1));
  work.plan.path[k].time = work.plan.path[k - 1].time - (generator() % 2 ? 0 : 0.1);
  return true;
}

/// Removes all rows between standoff and hole, which leaves one straight joint move. Returns false if this move keeps
/// to the hole's axis.
inline bool leaveOutViaPoints(Work& work, Generator& generator) {
  const int tube = pick(generator, work.plan.tubes.size());
  const int segment = 3 * tube + (generator() % 2);
  auto& path = work.plan.path;
  const std::size_t first = firstRowOf(work.plan, segment);
  std::size_t last = first;
  while (last + 1 < path.size() && path[last + 1].segment == segment) ++last;
  const std::size_t before = first > 0 ? first - 1 : 0;
  const double off = sideways(deflectedTip(work.cell, (path[before].q + path[last].q) / 2),
                              work.plan.tubes[static_cast<std::size_t>(tube)].hole_W);
  path.erase(path.begin() + static_cast<std::ptrdiff_t>(before + 1), path.begin() + static_cast<std::ptrdiff_t>(last));
  return off > 0.00112 * kInch;
}

inline bool loseGoalRow(Work& work, Generator& generator) {
  const std::size_t k = firstRowOf(work.plan, 3 * pick(generator, work.plan.tubes.size()) + 1) - 1;
  work.plan.path.erase(work.plan.path.begin() + static_cast<std::ptrdiff_t>(k));
  return true;
}

inline bool callTravelAnApproach(Work& work, Generator& generator) {
  const int segment = work.plan.path[anyRow(work.plan, SegmentKind::kTravel, generator)].segment;
  for (auto& row : work.plan.path)
    if (row.segment == segment) row.kind = generator() % 2 ? SegmentKind::kApproach : SegmentKind::kRetreat;
  return true;
}

inline bool renumberSegment(Work& work, Generator& generator) {
  work.plan.path[static_cast<std::size_t>(pick(generator, work.plan.path.size()))].segment += generator() % 2 ? 3 : -3;
  return true;
}

inline bool callVisitedUnreachable(Work& work, Generator& generator) {
  const auto& tube = work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))];
  work.plan.unreachable.emplace_back(tube.row, tube.column);
  return true;
}

inline bool callNoTubeUnreachable(Work& work, Generator& generator) {
  work.plan.unreachable.emplace_back(1 + pick(generator, 49), 1000);
  return true;
}

/// Moves the tip through the sheet between two holes, on a path that is complete and slow enough.
inline bool driveThroughTheSheet(Work& work, Generator& generator) {
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

inline bool stateLessTravel(Work& work, Generator&) {
  *work.plan.travel_time -= 0.01;
  return true;
}

inline bool stateMoreTime(Work& work, Generator&) {
  *work.plan.total_time += 0.01;
  return true;
}

/// Raises the stated smallest clearance by 0.1 in. The original value may be too small by at most 0.05 in, so that the
/// new value is too large.
inline bool stateMoreClearance(Work& work, Generator&) {
  *work.plan.least_clearance += 0.1 * kInch;
  return true;
}

inline bool stateACentringError(Work& work, Generator& generator) {
  *work.plan.tubes[static_cast<std::size_t>(pick(generator, work.plan.tubes.size()))].centring_error += 1e-6;
  return true;
}

inline constexpr Alteration kAlterations[] = {
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
    {"more clearance asked for", requireMoreClearance},
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
    {"less travel stated", stateLessTravel},
    {"more time stated", stateMoreTime},
    {"more clearance stated", stateMoreClearance},
    {"a centring error stated", stateACentringError},
};

}  // namespace tubeplan::planner::testing
