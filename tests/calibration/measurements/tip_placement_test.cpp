// Placement of the tip at a given position, starting from a nearby posture.
#include "calibration/measurements/tip_placement.hpp"

#include <gtest/gtest.h>

#include "app/formats/cell/cell_reader.hpp"
#include "calibration/simulation/campaign_random.hpp"
#include "deflection/tip_derivatives.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Vector3d;

class TipPlacementOfTheCobra : public ::testing::Test {
 protected:
  const deflection::Arm arm = app::readCell(TUBEPLAN_SOURCE_DIR "/app/cells/bench.yaml").arm;

  [[nodiscard]] deflection::Posture randomPosture(CampaignRandom& random) const {
    Eigen::VectorXd q(4);
    q << random.uniform(-3, 3), random.uniform(0.3, 2.8), random.uniform(0.3, 2) * (random.index(2) ? 1 : -1),
        random.uniform(-2, 2);
    return {q, random.uniform(0, 180), -Vector3d::UnitZ()};
  }
};

Vector3d tipOf(const deflection::Arm& arm, const deflection::Posture& posture) {
  const auto shape = deflection::solveFlexibleKinematics(arm, posture, {1e-13, 100});
  EXPECT_EQ(shape.status, deflection::KinematicsStatus::kConverged);
  return shape.X_BD.p;
}

TEST_F(TipPlacementOfTheCobra, ReachesPlacesNearbyByTheSmallestMotion) {
  CampaignRandom random(4, CampaignRandom::Stream::kPostures);
  int placed = 0;
  for (int k = 0; k < 200; ++k) {
    const auto start = randomPosture(random);
    const auto tip = deflection::differentiateTip(arm, start, deflection::jointVariables(arm));
    const Vector3d off = random.vector(0.001);
    const auto found = placeTip(arm, start, tip.kinematics.X_BD.p + off);
    if (found.status != TipPlacementStatus::kPlaced) continue;
    ++placed;
    auto posture = start;
    posture.q = found.q;
    EXPECT_LE((tipOf(arm, posture) - tip.kinematics.X_BD.p - off).norm(), 2e-11);
    const Eigen::VectorXd smallest = tip.position_B.completeOrthogonalDecomposition().solve(off);
    EXPECT_LE((found.q - start.q - smallest).norm(), 0.25 * smallest.norm() + 1e-4);
  }
  EXPECT_GE(placed, 190);
}

TEST_F(TipPlacementOfTheCobra, StaysWhereTheTipAlreadyIs) {
  CampaignRandom random(5, CampaignRandom::Stream::kPostures);
  const auto start = randomPosture(random);
  const auto found = placeTip(arm, start, tipOf(arm, start));
  EXPECT_EQ(found.status, TipPlacementStatus::kPlaced);
  EXPECT_EQ(found.q, start.q);
}

TEST_F(TipPlacementOfTheCobra, SaysWhatIsOutOfReachOrStretched) {
  CampaignRandom random(6, CampaignRandom::Stream::kPostures);
  EXPECT_EQ(placeTip(arm, randomPosture(random), Vector3d(9, 0, 1)).status, TipPlacementStatus::kNotConverged);
  // Elbow and wrist are such that the upper arm, the forearm and the tip are collinear.
  deflection::Posture straight{Eigen::Vector4d(0.2, 0.8, 0, -std::atan2(7.8471, 16.2493)), 0, -Vector3d::UnitZ()};
  EXPECT_EQ(placeTip(deflection::rigidCopy(arm), straight, tipOf(deflection::rigidCopy(arm), straight)).status,
            TipPlacementStatus::kStretched);
}

TEST_F(TipPlacementOfTheCobra, CopesWithAnArmTenTimesSofter) {
  deflection::Arm soft = arm;
  for (auto& row : soft.rows) row.joint_stiffness /= 10;
  CampaignRandom random(7, CampaignRandom::Stream::kPostures);
  int placed = 0;
  for (int k = 0; k < 100; ++k) {
    auto start = randomPosture(random);
    start.load = 20;
    const Vector3d goal = tipOf(soft, start) + random.vector(0.005);
    placed += placeTip(soft, start, goal).status == TipPlacementStatus::kPlaced;
  }
  EXPECT_GE(placed, 80);
}

}  // namespace
}  // namespace tubeplan::calibration
