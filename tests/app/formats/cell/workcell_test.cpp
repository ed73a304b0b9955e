// Tests that cells are refused before planning if planning does not support them.
#include "app/formats/cell/workcell.hpp"

#include <limits>

#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

class WorkcellRefusals : public ::testing::Test {
 protected:
  Cell cell = readCell((shippedCells() / "column.yaml").string());

  static void expectRefused(const Cell& cell, const std::string& found, const std::string& advice) {
    const std::string message = messageOf([&] { (void)workcellOf(cell, "plan a visit"); });
    expectSays(message, found);
    expectSays(message, "to plan a visit");
    expectSays(message, advice);
  }
};

TEST_F(WorkcellRefusals, TheCellAsShippedIsPlannedFor) {
  const planner::Workcell work = workcellOf(cell, "plan a visit");
  EXPECT_EQ(work.arm.rows.size(), cell.arm.rows.size());
  EXPECT_EQ(work.sheet.tubes.size(), cell.sheet->tubes.size());
}

TEST_F(WorkcellRefusals, ASlideWithoutLimits) {
  for (const bool lower : {true, false}) {
    Cell without = cell;
    auto& slide = without.arm.rows[0].joint;
    (lower ? slide.lower : slide.upper) = (lower ? -1 : 1) * std::numeric_limits<double>::infinity();
    expectRefused(without, "the slide lift has no limits", "add limits: [LOWEST, HIGHEST]");
  }
}

TEST_F(WorkcellRefusals, AJointThatFollowsOthers) {
  auto& joint = cell.arm.rows[2].joint;
  joint.type = deflection::JointType::kPassive;
  joint.follows = {{1, -1}};
  expectRefused(cell, "the joint elbow follows others", "an encoder reading of its own");
}

TEST_F(WorkcellRefusals, ASideChain) {
  cell.arm.side_chains.push_back({1, {cell.arm.rows[2]}});
  expectRefused(cell, "a side chain at upper-link", "a lump of the link");
}

TEST_F(WorkcellRefusals, AToolWithoutADirection) {
  cell.tool_axis_stated = false;
  expectRefused(cell, "the insertion direction of the tool", "add tool: {axis: [x, y, z]}");
}

}  // namespace
}  // namespace tubeplan::app
