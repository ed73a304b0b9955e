// The closure of rigid chains: every joint changes it linearly, and its roots are all the postures there are.
#include "deflection/inverse/closed_loop.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "deflection/inverse/goal_newton.hpp"

namespace tubeplan::deflection {
namespace {

using Eigen::Vector3d, Eigen::VectorXd;
constexpr double kQuarter = std::numbers::pi / 2;

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double operator()(double most) { return std::uniform_real_distribution<>(-most, most)(random_); }
  Vector3d vector(double most) { return {(*this)(most), (*this)(most), (*this)(most)}; }

 private:
  std::mt19937_64 random_;
};

/// Joints of any geometry, in a file's numbers only for their limits.
struct Chain {
  Arm arm;
  AxesAtZero axes;
};

Chain chainOf(std::vector<DenavitHartenberg<double>> rows, int slide, const Vector3d& tip) {
  Chain chain;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    auto& row = chain.arm.rows.emplace_back();
    row.name = row.joint.name = "j" + std::to_string(k);
    row.placement = rows[k];
    row.joint.type = static_cast<int>(k) == slide ? JointType::kPrismatic : JointType::kRevolute;
    if (static_cast<int>(k) == slide) row.joint.lower = -1, row.joint.upper = 1;
  }
  chain.arm.p_LT = tip;
  chain.axes = axesAtZero(chain.arm);
  return chain;
}

Chain drawnChain(int joints, int slide, Draw& draw) {
  std::vector<DenavitHartenberg<double>> rows;
  for (int k = 0; k < joints; ++k) rows.push_back({draw(3), std::abs(draw(0.5)), draw(0.3), 0});
  return chainOf(rows, slide, draw.vector(0.3));
}

VectorXd drawnReadings(const Chain& chain, Draw& draw) {
  VectorXd q(chain.arm.jointCount());
  for (Eigen::Index k = 0; k < q.size(); ++k)
    q[k] = draw(chain.arm.joint(k).type == JointType::kPrismatic ? 1 : std::numbers::pi);
  return q;
}

double apart(const Chain& chain, const VectorXd& a, const VectorXd& b) {
  double most = 0;
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    const double off = a[k] - b[k];
    most = std::max(
        most,
        std::abs(chain.axes.slides[static_cast<std::size_t>(k)] ? off : std::remainder(off, 2 * std::numbers::pi)));
  }
  return most;
}

/// Whether a posture drawn at random is among those that the roots lead to.
template <int Size>
bool isAmongRoots(const Chain& chain, const VectorXd& q) {
  TipMotion tip;
  placeRigidTip(chain.axes, q, tip);
  std::vector<VectorXd> roots;
  const double reach = reachOf(chain.arm);
  ClosedLoop<Size>(closureChain<Size>(chain.axes, reach)).addRoots(tip.p, tip.axis, 0.2, roots);
  EXPECT_LE(roots.size(), Size == kLineSize ? 32U : 8U);
  InverseKinematicsOptions options;
  options.singular_floor = 1e-6;
  GoalProblem problem(
      chain.arm, false, [&](const VectorXd& at, TipMotion& out) { placeRigidTip(chain.axes, at, out); }, options);
  return std::ranges::any_of(roots, [&](const VectorXd& root) {
    return apart(chain, leadToGoal(problem, {tip.p, tip.axis}, root).q, q) < 1e-4;
  });
}

TEST(LoopClosure, AJointChangesItLinearly) {
  Draw draw(41);
  for (int n = 0; n < 50; ++n) {
    const Chain chain = drawnChain(1, n % 2 ? 0 : -1, draw);
    const VectorXd q = drawnReadings(chain, draw);
    const bool slides = chain.axes.slides[0];
    const Vector3d terms{1, slides ? q[0] : std::cos(q[0]), slides ? q[0] * q[0] : std::sin(q[0])};
    TipMotion tip;
    placeRigidTip(chain.axes, q, tip);
    const auto joint = jointClosure<kLineSize>(chain.axes, 0);
    const auto at_zero = lineClosure(chain.axes.tip, chain.axes.tool_axis), moved = lineClosure(tip.p, tip.axis);
    Closure<kLineSize> forth = Closure<kLineSize>::Zero(), back = forth;
    for (int t = 0; t < 3; ++t) {
      forth += terms[t] * (joint.forth[static_cast<std::size_t>(t)] * at_zero);
      back += terms[t] * (joint.back[static_cast<std::size_t>(t)] * moved);
    }
    EXPECT_LE((forth - moved).norm(), 1e-13 * moved.norm());
    EXPECT_LE((back - at_zero).norm(), 1e-13 * moved.norm());
  }
}

TEST(ClosedLoop, HasEveryPostureOfChainsOfAnyGeometry) {
  Draw draw(42);
  for (int n = 0; n < 60; ++n) {
    const Chain three = drawnChain(3, n % 4 - 1, draw), five = drawnChain(5, n % 6 - 1, draw);
    EXPECT_TRUE(isAmongRoots<kPlaceSize>(three, drawnReadings(three, draw))) << n;
    EXPECT_TRUE(isAmongRoots<kLineSize>(five, drawnReadings(five, draw))) << n;
  }
}

TEST(ClosedLoop, HasThemWhereAxesMeetOrAreParallel) {
  const Chain puma = chainOf({{0, 0, 0, 0},
                              {-kQuarter, 0, 0.2435, 0},
                              {0, 0.4318, -0.0934, 0},
                              {kQuarter, -0.0203, 0.4331, 0},
                              {-kQuarter, 0, 0, 0}},
                             -1, {0.04, 0.01, 0.22});
  const Chain ur5 = chainOf(
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
    const Chain six = drawnChain(6, n % 7 - 1, draw);
    const VectorXd q = drawnReadings(six, draw);
    const double reach = reachOf(six.arm);
    const auto whole = closureChain<kLineSize>(six.axes, reach);
    const auto held = static_cast<std::size_t>(n % 6);
    TipMotion tip;
    placeRigidTip(six.axes, q, tip);
    std::vector<VectorXd> roots;
    LineLoop(withJointHeld(whole, held, q[static_cast<Eigen::Index>(held)])).addRoots(tip.p, tip.axis, 0.2, roots);
    VectorXd rest(5);
    for (Eigen::Index k = 0, at = 0; k < 6; ++k)
      if (k != static_cast<Eigen::Index>(held)) rest[at++] = q[k];
    double nearest = 9;
    for (const VectorXd& root : roots)
      nearest = std::min(
          nearest, (root - rest).unaryExpr([](double d) { return std::remainder(d, 2 * std::numbers::pi); }).norm());
    EXPECT_LE(nearest, 0.05) << n;
  }
}

}  // namespace
}  // namespace tubeplan::deflection
