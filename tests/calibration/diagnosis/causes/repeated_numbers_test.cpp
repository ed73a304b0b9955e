// No effect may be a cause that the free parameters reproduce at every posture, and every other effect must stay one,
// for random arms in all row conventions.
#include "calibration/diagnosis/causes/repeated_numbers.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/calibration/random_mechanisms.hpp"

namespace tubeplan::calibration {
namespace {

using EffectNames = std::set<std::string>;

std::vector<Measurement> positions(const PlacedArm& placed, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Measurement> measurements(40);
  for (auto& measurement : measurements) {
    measurement.p_W = Eigen::Vector3d::Zero();
    measurement.sigma = 1e-4;
    measurement.q.resize(placed.arm.jointCount());
    for (Eigen::Index j = 0; j < measurement.q.size(); ++j)
      measurement.q[j] = random.uniform(placed.arm.joint(j).lower, placed.arm.joint(j).upper);
  }
  return measurements;
}

bool isConstantGeometry(const Cause& cause) {
  const auto& kind = deflection::kindOf(cause.effects.front());
  const bool is_offset = std::string(kind.name) == "joint-offset";
  return is_offset || (kind.stage == deflection::EffectStage::kGeometry &&
                       kind.varies_with == std::vector<deflection::EffectVariable>{deflection::EffectVariable::kJoint});
}

EffectNames namesOf(const std::vector<Cause>& causes, bool of_geometry) {
  EffectNames names;
  for (const Cause& cause : causes)
    if (!cause.effects.empty() && isConstantGeometry(cause) == of_geometry) names.insert(cause.effect + "@" + cause.at);
  return names;
}

/// Causes before and after those are removed that the free parameters repeat.
struct Lists {
  CauseList before, after;
};

Lists listsFor(PlacedArm placed, const std::vector<std::string>& free, bool frees_base, std::uint64_t seed) {
  const auto measurements = positions(placed, seed);
  const auto fitted = chooseUnknowns(placed, {free, frees_base}).list;
  const CauseList list = listCauses(placed, measurements, fitted);
  Lists lists{list, list};
  removeRepeated(placed, measurements, fitted, Signatures(placed, list.causes), lists.after);
  return lists;
}

TEST(RepeatedNumbers, FreeGeometryLeavesNoConstantChangeOfGeometryAsACause) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const PlacedArm& placed : {mechanism(seed), byOrigins(mechanism(seed)), byStandardTable(mechanism(seed))}) {
      const Lists lists = listsFor(placed, {"tool.tip", "geometry"}, true, seed);
      EXPECT_FALSE(namesOf(lists.before.causes, true).empty());
      EXPECT_EQ(namesOf(lists.after.causes, true), EffectNames{}) << seed;
      EXPECT_GT(lists.after.not_tried.size(), lists.before.not_tried.size()) << seed;
    }
}

TEST(RepeatedNumbers, OtherEffectsStayCauses) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    PlacedArm placed = mechanism(seed);
    placed.base_poses.front().is_known = true;
    const Lists lists = listsFor(placed, {"tool.tip", "geometry"}, false, seed);
    EffectNames before = namesOf(lists.before.causes, false);
    const auto slides = std::ranges::count_if(
        placed.arm.joints(), [](const auto& joint) { return joint.type == deflection::JointType::kPrismatic; });
    // Free lengths reproduce a scale of all coordinates, where no joint slides. A slide coupled to another slide leans.
    if (slides == 0) before.erase("scale-error@measurement");
    if (slides > 1) std::erase_if(before, [](const auto& name) { return name.starts_with("joint-coupling"); });
    for (const auto& name : namesOf(lists.after.causes, false)) before.erase(name);
    EXPECT_EQ(before, EffectNames{}) << "removed with seed " << seed;
  }
}

TEST(RepeatedNumbers, AFreeTipRepeatsItsOffsetAndTheLastJointsZeroWithoutTheToolsTurn) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const bool shows_tool_turn : {false, true}) {
      PlacedArm placed = mechanism(seed);
      placed.shows_tool_turn = shows_tool_turn;
      placed.base_poses.front().is_known = true;
      const Lists lists = listsFor(placed, {"tool.tip"}, false, seed);
      const auto& last = placed.arm.rows.back().joint;
      if (last.type == deflection::JointType::kPrismatic) continue;  // shifts of the rows before it are the tip's too
      EffectNames removed{"tool-offset@tool"};
      if (!shows_tool_turn) removed.insert("joint-offset@" + last.name);
      EffectNames before = namesOf(lists.before.causes, true);
      for (const auto& name : removed) EXPECT_EQ(before.erase(name), 1U) << name;
      EXPECT_EQ(namesOf(lists.after.causes, true), before) << seed;
    }
}

TEST(RepeatedNumbers, WithoutFreeNumbersOfTheArmNothingIsRemoved) {
  const Lists lists = listsFor(mechanism(3), {}, true, 3);
  EXPECT_EQ(lists.after.causes.size(), lists.before.causes.size());
}

}  // namespace
}  // namespace tubeplan::calibration
