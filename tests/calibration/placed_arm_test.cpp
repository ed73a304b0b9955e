// Tests of the names of parameters that may be freed, of the variables that stand for them, and of base poses aligned
// in closed form.
#include "calibration/placed_arm.hpp"

#include <gtest/gtest.h>

#include "calibration/estimation/fit.hpp"
#include "calibration/independent_geometry.hpp"
#include "calibration/measurements/measurement_placement.hpp"
#include "calibration/placed_arm.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

std::vector<std::string> namesOf(const std::vector<Unknown>& unknowns) {
  std::vector<std::string> names;
  for (const auto& unknown : unknowns) names.push_back(unknown.name);
  return names;
}

const Unknown& named(const std::vector<Unknown>& unknowns, const std::string& name) {
  for (const auto& unknown : unknowns)
    if (unknown.name == name) return unknown;
  ADD_FAILURE() << name;
  return unknowns.front();
}

TEST(PlacedArm, PlacingsComeFirstThenNamesInTheirOrderThenGeometry) {
  PlacedArm placed = cobraTwice();
  placed.base_poses[0].is_known = true;
  const auto unknowns = chooseUnknowns(placed, {{"geometry", "tool.tip", "forearm.dh.a"}, true}).list;
  const auto names = namesOf(unknowns);
  EXPECT_EQ(names[0], "base.shift.x@B");
  EXPECT_EQ(names[5], "base.turn.z@B");
  EXPECT_EQ((std::vector<std::string>{names.begin() + 6, names.begin() + 10}),
            (std::vector<std::string>{"tool.tip.x", "tool.tip.y", "tool.tip.z", "forearm.dh.a"}));
  const auto geometry = independentGeometry(placed, {unknowns.begin(), unknowns.begin() + 10});
  ASSERT_EQ(names.size(), 10 + geometry.size());
  for (std::size_t k = 0; k < geometry.size(); ++k) EXPECT_EQ(names[10 + k], geometry[k].name);
  for (std::size_t k = 0; k < names.size(); ++k) EXPECT_EQ(unknowns[k].is_geometry, k >= 10) << names[k];
}

TEST(PlacedArm, NamesThatCannotBeFreedAreProblems) {
  const auto problem = [](const std::vector<std::string>& names) {
    PlacedArm placed = cobra();
    const auto problems = chooseUnknowns(placed, {names, true}).problems;
    return problems.empty() ? "" : problems[0].name + ": " + problems[0].what;
  };
  EXPECT_NE(problem({"tol.tip"}).find("no number 'tol.tip'"), std::string::npos);
  EXPECT_NE(problem({"tool.beam.Iz"}).find("tool.beam.Iz"), std::string::npos);
  EXPECT_NE(problem({"tool.tip", "tool.tip"}).find("freed twice"), std::string::npos);
  EXPECT_NE(problem({"tool.tip", "tool.tip.x"}).find("'tool.tip.x' is freed twice"), std::string::npos);
  EXPECT_NE(problem({"geometry", "geometry"}).find("freed twice"), std::string::npos);
  EXPECT_NE(problem({"tool.joint_stiffness.x", "tool.joint_stiffness.x"}).find("freed twice"), std::string::npos);
  EXPECT_EQ(problem({"geometry", "tool.tip.x"}), "");
}

TEST(PlacedArm, VariablesMeanWhatTheirScaleSays) {
  PlacedArm placed = cobra();
  const auto unknowns =
      chooseUnknowns(placed, {{"tool.joint_stiffness.z", "tool.joint_stiffness.x", "forearm.dh.a"}, true}).list;
  const Unknown& soft = named(unknowns, "tool.joint_stiffness.z");
  EXPECT_EQ(soft.scale, Unknown::Scale::kCompliance);
  EXPECT_NEAR(valueAt(soft, -0.5 / soft.start), 2 * soft.start, 1e-9 * soft.start);
  const Unknown& rigid = named(unknowns, "tool.joint_stiffness.x");
  EXPECT_EQ(rigid.scale, Unknown::Scale::kCompliance);
  EXPECT_TRUE(std::isfinite(placed.arm.rows[5].joint_stiffness.x())) << "becomes finite";
  EXPECT_NEAR(valueAt(rigid, 1e-5), 1 / (1 / rigid.start + 1e-5), 1e-9 * rigid.start);
  EXPECT_GT(rigid.start, 1000 * soft.start) << "but hardly gives";
  EXPECT_NEAR(valueAt(named(unknowns, "forearm.dh.a"), 0.001), 26.406 * kInch + 0.001, 1e-12);
  for (const auto& unknown : unknowns)
    for (const double x : {0., 0.3 * unknown.typical}) {
      const double h = 1e-6 * unknown.typical;
      const double slope = (valueAt(unknown, x + h) - valueAt(unknown, x - h)) / (2 * h);
      EXPECT_NEAR(slopeAt(unknown, x), slope, 1e-5 * std::abs(slope)) << unknown.name;
    }
}

TEST(PlacedArm, AppliedMovesEachPlacingByItsOwnStep) {
  PlacedArm placed = cobraTwice();
  const auto unknowns = chooseUnknowns(placed, {{"tool.tip"}, true}).list;
  ASSERT_EQ(unknowns.size(), 15u);
  Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(15, -0.2, 0.3);
  const PlacedArm at = applied(placed, unknowns, x);
  for (int p = 0; p < 2; ++p) {
    const auto expected = moved(placed.base_poses[static_cast<std::size_t>(p)].X_WB, x.segment<6>(6 * p));
    EXPECT_LE((at.base_poses[static_cast<std::size_t>(p)].X_WB.matrix() - expected.matrix()).norm(), 1e-12);
  }
  EXPECT_LE((at.arm.p_LT - placed.arm.p_LT - x.tail<3>()).norm(), 1e-12);
}

TEST(PlacedArm, EverySetUpOfTheMeasurementsHasItsPlacing) {
  std::vector<Measurement> measurements(4);
  measurements[1].setup = measurements[3].setup = "second";
  const auto placed = placeForMeasurements(deflection::cobraArm(), Eigen::Isometry3d::Identity(), false, measurements);
  ASSERT_EQ(placed.base_poses.size(), 2u);
  EXPECT_EQ(basePoseOf(placed, measurements[2]), 0);
  EXPECT_EQ(basePoseOf(placed, measurements[3]), 1);
  EXPECT_EQ(placeForMeasurements(deflection::cobraArm(), Eigen::Isometry3d::Identity(), true, {}).base_poses.size(),
            1u);
}

TEST(AlignBases, FindsBasesFromAnywhere) {
  const PlacedArm truth = cobraTwice();
  MeasurementMaker maker(truth, 3);
  maker.add(MeasurementKind::kPosition, 4, "A");
  maker.add(MeasurementKind::kDeflection, 3, "A");
  maker.addTouches(4, {0, 30 * kPound}, true, "B");
  maker.add(MeasurementKind::kDistance, 3, "B");
  const Eigen::Isometry3d starts[] = {Eigen::Isometry3d::Identity(), poseOf({5, -3, 2}, {1, 0.7, -2}),
                                      poseOf({0, 0, -9}, {3, 0, 0})};
  for (const auto& start : starts) {
    PlacedArm placed = truth;
    for (auto& base_pose : placed.base_poses) base_pose.X_WB = start;
    alignBases(placed, maker.measurements);
    for (int p = 0; p < 2; ++p) {
      const auto k = static_cast<std::size_t>(p);
      EXPECT_LE((placed.base_poses[k].X_WB.matrix() - truth.base_poses[k].X_WB.matrix()).norm(), 1e-5) << p;
    }
  }
}

TEST(AlignBases, LeavesWhatIsKnownAndWhatCannotBeTold) {
  const PlacedArm truth = cobraTwice();
  MeasurementMaker maker(truth, 4);
  maker.add(MeasurementKind::kPosition, 5, "A");
  maker.add(MeasurementKind::kPosition, 2, "B");
  PlacedArm placed = truth;
  const auto start = poseOf({0.5, 0, 0}, {0, 0, 0.1});
  for (auto& base_pose : placed.base_poses) base_pose.X_WB = start;
  placed.base_poses[0].is_known = true;
  alignBases(placed, maker.measurements);
  EXPECT_TRUE(placed.base_poses[0].X_WB.isApprox(start)) << "known";
  EXPECT_TRUE(placed.base_poses[1].X_WB.isApprox(start)) << "two places only";
}

TEST(AlignBases, DoesNotLookAtHeldOutMeasurements) {
  PlacedArm truth = cobra();
  truth.base_poses[0].is_known = false;
  MeasurementMaker maker(truth, 5);
  maker.add(MeasurementKind::kPosition, 6);
  maker.measurements[5].is_held_out = true;
  *maker.measurements[5].p_W += Eigen::Vector3d(1, 1, 1);
  PlacedArm placed = truth;
  alignBases(placed, maker.measurements);
  EXPECT_LE((placed.base_poses[0].X_WB.matrix() - truth.base_poses[0].X_WB.matrix()).norm(), 1e-6);
}

}  // namespace
}  // namespace tubeplan::calibration
