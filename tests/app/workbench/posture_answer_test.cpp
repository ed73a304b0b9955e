// The page shows the same clearance of a posture as a plan uses.
#include "app/workbench/posture_answer.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/formats/cell/workcell.hpp"
#include "deflection/effects/effect.hpp"
#include "planner/collision/arm_clearance.hpp"

namespace tubeplan::app {
namespace {

// Backlash, within which a joint may move, reduces the clearance margin on the page by as much as in a plan.
TEST(PostureAnswer, TheMarginIsThatOfAPlan) {
  Cell cell = readCell(TUBEPLAN_SOURCE_DIR "/app/cells/mockup.yaml");
  const double without = clearanceOf(*makeModel(0, "", "given", cell), Eigen::Vector4d(-0.6, 0.8, -0.6, -0.2), 0)
                             .at("margin")
                             .get<double>();
  const int kind = *deflection::findEffectKind("backlash");
  const auto place =
      deflection::findPlace(cell.arm, deflection::effectKinds()[static_cast<std::size_t>(kind)], "tool.z");
  ASSERT_TRUE(place.has_value());
  cell.arm.effects.push_back({kind, *place, {0.002}});
  const ModelPointer model = makeModel(0, "", "given", cell);
  planner::Workcell posed = workcellOf(cell, "test the page");
  for (const double load : {0., 120.}) {
    posed.load = load;
    const planner::ArmClearance clearance(posed);
    ASSERT_GT(clearance.armTravel().jump, 1e-4);
    for (const Eigen::Vector4d& q : {Eigen::Vector4d(-0.6, 0.8, -0.6, -0.2), Eigen::Vector4d(0.3, 1.1, -1.2, 0.1)}) {
      const auto expected = clearance.at(q, planner::ContactRule::kApproach);
      const nlohmann::json page = clearanceOf(*model, q, load);
      EXPECT_NEAR(page.at("margin"), cell.units.toFile(expected.margin, dimension::kLength), 1e-9);
      EXPECT_NEAR(page.at("distance"), cell.units.toFile(expected.distance, dimension::kLength), 1e-9);
      EXPECT_EQ(page.at("pair"), nlohmann::json({expected.body, expected.other}));
    }
  }
  EXPECT_LT(clearanceOf(*model, Eigen::Vector4d(-0.6, 0.8, -0.6, -0.2), 0).at("margin"), without);
}

}  // namespace
}  // namespace tubeplan::app
