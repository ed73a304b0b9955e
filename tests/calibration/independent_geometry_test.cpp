// The geometric parameters that a fit frees must be complete, not redundant and well distinguishable, for random arms
// in all row conventions.
#include "calibration/independent_geometry.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "deflection/tip_derivatives.hpp"
#include "tests/calibration/random_mechanisms.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

/// Returns the derivatives of the tool pose at random postures with respect to the named parameters. If no measurement
/// depends on the tool's rotation, its three columns follow; if the base is free, its six columns follow. Each column
/// is scaled to length 1.
Eigen::MatrixXd motions(const PlacedArm& placed, const std::vector<std::string>& names) {
  constexpr int kPostures = 30;
  std::vector<deflection::Variable> variables;
  for (const auto& name : names)
    variables.push_back(deflection::Variable::number(deflection::findParameter(placed.arm, name)->path));
  const bool has_base = !placed.base_poses[0].is_known;
  for (const std::string axis : {"x", "y", "z"})
    if (!placed.shows_tool_turn)
      variables.push_back(
          deflection::Variable::number(deflection::findParameter(placed.arm, "tool.turn." + axis)->path));
  const auto count = static_cast<Eigen::Index>(variables.size());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(6 * kPostures, count + (has_base ? 6 : 0));
  RandomStream random(3);
  for (int k = 0; k < kPostures; ++k) {
    Eigen::VectorXd q(placed.arm.jointCount());
    for (auto& measurement : q) measurement = random.uniform(-3, 3);
    const auto tip = deflection::differentiateTip(placed.arm, {q}, variables);
    all.block(6 * k, 0, 3, count) = tip.position_B;
    all.block(6 * k + 3, 0, 3, count) = tip.rotation_B;
    if (!has_base) continue;
    all.block<3, 3>(6 * k, count).setIdentity();
    all.block<3, 3>(6 * k, count + 3) = -deflection::crossMatrix<double>(tip.kinematics.X_BD.p);
    all.block<3, 3>(6 * k + 3, count + 3).setIdentity();
  }
  for (Eigen::Index k = 0; k < all.cols(); ++k)
    if (all.col(k).norm() > 1e-12) all.col(k).normalize();
  return all;
}

Eigen::Index rankOf(const Eigen::MatrixXd& columns) {
  const Eigen::VectorXd values = columns.bdcSvd().singularValues();
  return (values.array() > 1e-9 * values[0]).count();
}

std::vector<std::string> allGeometry(const PlacedArm& placed) {
  std::vector<std::string> names;
  for (const auto& parameter : deflection::parametersOf(placed.arm))
    if (isGeometry(parameter.name) && (placed.shows_tool_turn || !parameter.name.starts_with("tool.turn")))
      names.push_back(parameter.name);
  return names;
}

std::vector<std::string> chosen(PlacedArm placed) {
  std::vector<std::string> names;
  for (const auto& unknown : chooseUnknowns(placed, {{"geometry"}, true}).list)
    if (unknown.owner == Unknown::Owner::kArm) names.push_back(unknown.name);
  return names;
}

TEST(IndependentGeometry, IsCompleteAndNotRedundantHoweverRowsAreWritten) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const PlacedArm by_dh = mechanism(seed), by_origins = byOrigins(by_dh);
    Eigen::Index made = 0;
    for (PlacedArm placed : {by_dh, by_origins}) {
      placed.shows_tool_turn = seed % 2 == 0;
      const auto names = chosen(placed);
      const Eigen::MatrixXd columns = motions(placed, names);
      const Eigen::Index rank = rankOf(columns);
      EXPECT_EQ(rank, columns.cols()) << seed << ": redundant";
      EXPECT_EQ(rank, rankOf(motions(placed, allGeometry(placed)))) << seed << ": not complete";
      made = made == 0 ? rank : made;
      EXPECT_EQ(rank, made) << seed << ": as many numbers whichever way";
    }
  }
}

// If the base is known, the parameters selected in either Denavit-Hartenberg convention must be independent, and must
// reproduce every change of geometry that six parameters per row can describe.
TEST(IndependentGeometry, IsCompleteBesideAKnownBaseByEitherTable) {
  int counted = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    PlacedArm drawn = mechanism(seed);
    drawn.base_poses[0].is_known = true;
    drawn.shows_tool_turn = seed % 2 == 0;
    int turns = 0, slides = 0;
    for (const auto& joint : drawn.arm.joints()) ++(joint.type == deflection::JointType::kPrismatic ? slides : turns);
    for (const PlacedArm& placed : {drawn, byStandardTable(drawn)}) {
      const bool is_standard = deflection::isStandard(placed.arm.rows);
      const Eigen::MatrixXd columns = motions(placed, chosen(placed));
      const Eigen::Index rank = rankOf(columns);
      EXPECT_EQ(rank, columns.cols()) << seed << " " << is_standard << ": redundant";
      const PlacedArm all = byOrigins(placed);
      EXPECT_EQ(rank, rankOf(motions(all, allGeometry(all)))) << seed << " " << is_standard << ": not complete";
      if (slides > 0) continue;
      ++counted;
      EXPECT_EQ(rank, 4 * turns + 6) << seed << " " << is_standard;
    }
  }
  EXPECT_GT(counted, 10);
}

TEST(IndependentGeometry, HoldsAsManyNumbersAsMechanismsHave) {
  int open = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const PlacedArm placed = mechanism(seed);
    int turns = 0, slides = 0;
    for (const auto& joint : placed.arm.joints()) ++(joint.type == deflection::JointType::kPrismatic ? slides : turns);
    if (placed.base_poses[0].is_known) continue;
    ++open;
    // Everett's count is 4 R + 2 P + 6; parallel prismatic joints have fewer independent parameters.
    const Eigen::MatrixXd columns = motions(placed, chosen(placed));
    EXPECT_EQ(rankOf(columns), columns.cols()) << seed;
    EXPECT_LE(columns.cols(), 4 * turns + 2 * slides + 6) << seed;
    if (slides == 0) {
      EXPECT_EQ(columns.cols(), 4 * turns + 6) << seed;
    }
  }
  EXPECT_GT(open, 30);
}

/// If measurements depend on the tool's rotation, the selection must include its parameters and have Everett's complete
/// count; otherwise, it must not include them.
TEST(IndependentGeometry, HoldsTheToolsTurnWhereMeasurementsShowIt) {
  int complete = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    PlacedArm placed = mechanism(seed);
    placed.base_poses[0].is_known = false;
    int turns = 0, slides = 0;
    for (const auto& joint : placed.arm.joints()) ++(joint.type == deflection::JointType::kPrismatic ? slides : turns);
    const auto isTurn = [](const std::string& name) { return name.starts_with("tool.turn"); };
    EXPECT_TRUE(std::ranges::none_of(chosen(placed), isTurn)) << seed;
    placed.shows_tool_turn = true;
    const auto names = chosen(placed);
    EXPECT_TRUE(std::ranges::any_of(names, isTurn)) << seed;
    if (slides > 0) continue;
    ++complete;
    EXPECT_EQ(rankOf(motions(placed, names)), 4 * turns + 6) << seed;
  }
  EXPECT_GT(complete, 20);
}

TEST(IndependentGeometry, TellsNearlyParallelAxesApartByTheirLean) {
  for (const double lean : {0., 1e-5, 1e-3, 0.02, 0.08}) {
    PlacedArm placed = cobra();
    placed.arm = deflection::rigidCopy(placed.arm);
    std::get<deflection::DenavitHartenberg<double>>(placed.arm.rows[4].placement).beta = lean;
    const auto names = chosen(placed);
    EXPECT_TRUE(std::ranges::count(names, "forearm.dh.beta")) << lean;
    EXPECT_TRUE(std::ranges::count(names, "tool.dh.beta")) << lean;
    EXPECT_FALSE(std::ranges::count(names, "latch-link.dh.beta")) << lean;
    const Eigen::VectorXd values = motions(placed, names).bdcSvd().singularValues();
    EXPECT_GT(values.tail<1>()[0], 1e-3 * values[0]) << lean;
  }
}

/// At a pitch of 90 degrees, roll and yaw rotate about the same axis, so beta must be selected as the third rotation.
TEST(IndependentGeometry, IsCompleteWhereFixedAnglesAreSingular) {
  PlacedArm placed = byOrigins(mechanism(5));
  placed.base_poses[0].is_known = false;
  placed.arm.rows[1].placement = deflection::Origin<double>{{0.2, 0.1, 0.3}, {kRightAngle, kRightAngle, 0}};
  const auto names = chosen(placed);
  EXPECT_TRUE(std::ranges::count(names, "link2.origin.beta"));
  const Eigen::MatrixXd columns = motions(placed, names);
  EXPECT_EQ(rankOf(columns), columns.cols());
}

}  // namespace
}  // namespace tubeplan::calibration
