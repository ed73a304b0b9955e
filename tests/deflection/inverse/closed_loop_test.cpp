// The closure equations of rigid chains must be linear in functions of each reading, such as cos q and sin q, and every
// posture must be among their roots.
#include "deflection/inverse/closed_loop.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "deflection/inverse/goal_newton.hpp"
#include "tests/deflection/inverse/drawn_chain.hpp"

namespace tubeplan::deflection {
namespace {

using Eigen::Vector3d, Eigen::VectorXd;
using testing::postureDifference, testing::kQuarter, testing::DrawnChain, testing::chainOf, testing::Draw,
    testing::drawnChain, testing::drawnReadings;
/// Returns true if posture `q` is among the postures to which the roots of the closure equations lead.
template <int Size>
bool isAmongRoots(const DrawnChain& chain, const VectorXd& q) {
  TipMotion tip;
  placeRigidTip(chain.axes, q, tip);
  std::vector<VectorXd> roots;
  const double reach = reachOf(chain.arm);
  ClosedLoop<Size>(closureChain<Size>(chain.axes, reach)).addRoots(tip.p, tip.axis, 0.2, roots);
  EXPECT_LE(roots.size(), Size == kLineSize ? 32U : 8U);
  InverseKinematicsOptions options;
  options.singular_floor = 1e-6;
  GoalProblem problem(chain.arm, false, rigidTips(chain.axes), options);
  const auto led = leadToGoals(problem, std::vector(roots.size(), ToolGoal{tip.p, tip.axis}), roots);
  return std::ranges::any_of(led, [&](const Branch& branch) { return postureDifference(chain, branch.q, q) < 1e-4; });
}

TEST(LoopClosure, AJointChangesItLinearly) {
  Draw draw(41);
  for (int n = 0; n < 50; ++n) {
    const DrawnChain chain = drawnChain(1, n % 2 ? 0 : -1, draw);
    const VectorXd q = drawnReadings(chain, draw);
    const bool slides = chain.axes.slides[0];
    const Vector3d terms{1, slides ? q[0] : std::cos(q[0]), slides ? q[0] * q[0] : std::sin(q[0])};
    TipMotion tip;
    placeRigidTip(chain.axes, q, tip);
    const auto joint = jointClosure<kLineSize>(chain.axes, 0);
    const auto at_zero = lineClosure(chain.axes.tip, chain.axes.tool_axis), moved = lineClosure(tip.p, tip.axis);
    Closure<kLineSize> forward = Closure<kLineSize>::Zero(), backward = forward;
    for (int t = 0; t < 3; ++t) {
      forward += terms[t] * (joint.forward[static_cast<std::size_t>(t)] * at_zero);
      backward += terms[t] * (joint.backward[static_cast<std::size_t>(t)] * moved);
    }
    EXPECT_LE((forward - moved).norm(), 1e-13 * moved.norm());
    EXPECT_LE((backward - at_zero).norm(), 1e-13 * moved.norm());
  }
}

TEST(ClosedLoop, HasEveryPostureOfChainsOfAnyGeometry) {
  Draw draw(42);
  for (int n = 0; n < 60; ++n) {
    const DrawnChain three = drawnChain(3, n % 4 - 1, draw), five = drawnChain(5, n % 6 - 1, draw);
    EXPECT_TRUE(isAmongRoots<kPlaceSize>(three, drawnReadings(three, draw))) << n;
    EXPECT_TRUE(isAmongRoots<kLineSize>(five, drawnReadings(five, draw))) << n;
  }
}

TEST(ClosedLoop, HasThemWhereAxesMeetOrAreParallel) {
  const DrawnChain puma = chainOf({{0, 0, 0, 0},
                                   {-kQuarter, 0, 0.2435, 0},
                                   {0, 0.4318, -0.0934, 0},
                                   {kQuarter, -0.0203, 0.4331, 0},
                                   {-kQuarter, 0, 0, 0}},
                                  -1, {0.04, 0.01, 0.22});
  const DrawnChain ur5 = chainOf(
      {{0, 0, 0.089, 0}, {kQuarter, 0, 0, 0}, {0, -0.425, 0, 0}, {0, -0.39225, 0.109, 0}, {kQuarter, 0, 0.0947, 0}}, -1,
      {0.04, 0.01, 0.22});
  Draw draw(43);
  for (int n = 0; n < 60; ++n) {
    EXPECT_TRUE(isAmongRoots<kLineSize>(puma, drawnReadings(puma, draw))) << n;
    EXPECT_TRUE(isAmongRoots<kLineSize>(ur5, drawnReadings(ur5, draw))) << n;
  }
}

TEST(ClosedLoop, AHeldJointIsAPartOfTheChain) {
  Draw draw(44);
  for (int n = 0; n < 24; ++n) {
    const DrawnChain six = drawnChain(6, n % 7 - 1, draw);
    const VectorXd q = drawnReadings(six, draw);
    const double reach = reachOf(six.arm);
    const auto six_joint_chain = closureChain<kLineSize>(six.axes, reach);
    const auto held = static_cast<std::size_t>(n % 6);
    TipMotion tip;
    placeRigidTip(six.axes, q, tip);
    std::vector<VectorXd> roots;
    LineLoop(withJointHeld(six_joint_chain, held, q[static_cast<Eigen::Index>(held)]))
        .addRoots(tip.p, tip.axis, 0.2, roots);
    VectorXd free_readings(5);
    for (Eigen::Index k = 0, at = 0; k < 6; ++k)
      if (k != static_cast<Eigen::Index>(held)) free_readings[at++] = q[k];
    double nearest = 9;
    for (const VectorXd& root : roots)
      nearest = std::min(
          nearest,
          (root - free_readings).unaryExpr([](double d) { return std::remainder(d, 2 * std::numbers::pi); }).norm());
    EXPECT_LE(nearest, 0.05) << n;
  }
}

}  // namespace
}  // namespace tubeplan::deflection
