// Every fault of an unusable arm must be reported with the path of the faulty entry.
#include <gtest/gtest.h>

#include <functional>

#include "tests/deflection/cobra.hpp"

namespace tubeplan::deflection {
namespace {

struct FaultyArm {
  std::string path;
  std::function<void(Arm&)> apply_fault;
};

TEST(ArmProblems, TheCobraHasNone) { EXPECT_TRUE(findProblems(cobraArm()).empty()); }

TEST(ArmProblems, EachIsFoundByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const FaultyArm cases[] = {
      {"tool.joint_stiffness.z", [](Arm& a) { a.rows[5].joint_stiffness[2] = -1; }},
      {"tool.joint_stiffness.z", [](Arm& a) { a.rows[5].joint_stiffness[2] = 0; }},
      {"latch-link.beam.E", [](Arm& a) { a.rows[3].beam->E = -2; }},
      {"latch-link.beam.Iz", [](Arm& a) { a.rows[3].beam->I[2] = 0; }},
      {"latch-link.beam.segments", [](Arm& a) { a.rows[3].beam->segments = 0; }},
      {"mezzanine-beam.beam", [](Arm& a) { std::get<DenavitHartenberg<double>>(a.rows[1].placement).a = 0; }},
      {"latch-link.beam.Ix", [](Arm& a) { a.rows[3].beam->I[0] = 1e-7; }},
      {"forearm.weight.end", [](Arm& a) { a.rows[4].weight.end = -1; }},
      {"forearm.dh.a", [nan](Arm& a) { std::get<DenavitHartenberg<double>>(a.rows[4].placement).a = nan; }},
      {"forearm.joint.limits", [](Arm& a) { std::swap(a.rows[4].joint.lower, a.rows[4].joint.upper); }},
      {"forearm.joint.max_speed", [](Arm& a) { a.rows[4].joint.max_speed = 0; }},
      {"forearm", [](Arm& a) { a.rows[5].name = "forearm"; }},
      {"tool.joint.name", [](Arm& a) { a.rows[5].joint.name = "theta1"; }},
      {"tool.tip", [nan](Arm& a) { a.p_LT[1] = nan; }},
      {"tool.turn", [nan](Arm& a) { a.tool_turn_L[1] = nan; }},
      {"gravity", [](Arm& a) { a.gravity_W.setZero(); }},
      {"links", [](Arm& a) { a.rows.clear(); }},
  };
  for (const auto& c : cases) {
    Arm arm = cobraArm();
    c.apply_fault(arm);
    const auto problems = findProblems(arm);
    ASSERT_FALSE(problems.empty()) << c.path;
    EXPECT_EQ(problems.front().path, c.path);
    EXPECT_FALSE(problems.front().found.empty());
    const bool is_sentence = problems.front().found.find(' ') != std::string::npos;
    EXPECT_TRUE(is_sentence || !problems.front().expected.empty()) << c.path;
  }
}

}  // namespace
}  // namespace tubeplan::deflection
