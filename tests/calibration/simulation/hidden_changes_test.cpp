// Table of hidden changes: each names a cause that a watch looks for, and moves the tip as it says.
#include "calibration/simulation/hidden_changes.hpp"

#include <gtest/gtest.h>

#include <set>

#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/watch/candidate_changes.hpp"
#include "tests/calibration/estimation/cobra_touches.hpp"

namespace tubeplan::calibration {
namespace {

const TouchedCell& cellWithTouch() {
  static const TouchedCell kCell = touchedCell({{-20, 20}});
  return kCell;
}

TrueState startState() { return {cellWithTouch().arm, cellWithTouch().X_WB_nominal}; }

Eigen::Vector3d tipAt(const TrueState& state) {
  const TouchPlan& plan = cellWithTouch().plans.front();
  return toolAt(state.arm, state.X_WB, plannedTouch(plan, plan.q_start, 0, 1e-4))->p_W;
}

Eigen::Vector3d alongX() { return Eigen::Vector3d::UnitX(); }

TEST(HiddenChanges, HaveNamesOfTheirOwnAndBeginWithNone) {
  std::set<std::string> names;
  for (const auto& change : hiddenChanges()) EXPECT_TRUE(names.insert(change.name).second) << change.name;
  EXPECT_STREQ(hiddenChanges().front().name, "none");
  EXPECT_STREQ(hiddenChanges().front().effect, "");
}

TEST(HiddenChanges, NameACauseThatAWatchLooksFor) {
  const deflection::Arm arm = startState().arm;
  for (const auto& change : hiddenChanges().subspan(1)) {
    const std::string at = change.at(arm);
    ASSERT_FALSE(at.empty()) << change.name;
    if (std::string(change.effect) == kBaseMoved) {
      EXPECT_EQ(at, "base");
    } else if (std::string(change.effect) == kFreedNumbers) {
      const auto parameters = deflection::parametersOf(arm);
      EXPECT_TRUE(std::ranges::any_of(parameters, [&](const auto& number) { return number.name == at; })) << at;
    } else {
      EXPECT_EQ(deflection::makeEffect(arm, change.effect, at).status, deflection::EffectStatus::kMade) << change.name;
    }
  }
}

TEST(HiddenChanges, MoveTheTipAndGrowOnlyWhereTheySaySo) {
  const Eigen::Vector3d before = tipAt(startState());
  for (const auto& change : hiddenChanges()) {
    const ChangedState changed = change.make(startState(), alongX);
    const double first = (tipAt(changed(1)) - before).norm(), later = (tipAt(changed(20)) - before).norm();
    if (change.effect[0] == '\0') {
      EXPECT_EQ(later, 0);
      continue;
    }
    EXPECT_GT(first, 1e-6) << change.name;  // [m]
    EXPECT_LT(later, 5e-3) << change.name;
    EXPECT_NEAR(later / first, change.is_ramp ? 20 : 1, 0.5) << change.name;
  }
}

TEST(HiddenChanges, HaveNoPlaceInAnArmWithoutJoints) {
  deflection::Arm fixed = startState().arm;
  for (auto& row : fixed.rows) {
    row.joint = {};
    row.joint_stiffness.setConstant(deflection::kRigid);
  }
  EXPECT_EQ(slippingRow(fixed), -1);
  for (const auto& change : hiddenChanges())
    EXPECT_EQ(change.at(fixed).empty(),
              std::string(change.effect) != kBaseMoved && std::string(change.effect) != "thermal-growth")
        << change.name;
}

}  // namespace
}  // namespace tubeplan::calibration
