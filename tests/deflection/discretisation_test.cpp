#include "deflection/discretisation.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/deflection/cobra.hpp"

namespace tubeplan::deflection {
namespace {

/// Returns a weightless cantilever along x with one segment, of length L = 1 m and stiffness E I = 1 N m^2: a load P of
/// alpha [N] gives P L^2 / (E I) = alpha.
Arm weightlessBeam() {
  Arm arm;
  Row<double> row;
  row.name = "beam";
  row.placement = Origin<double>{};
  row.beam = Beam<double>{};
  row.beam->E = 1;
  row.beam->I = Eigen::Vector3d::Constant(1);
  arm.rows = {row};
  arm.p_LT = Eigen::Vector3d::UnitX();
  return arm;
}

double deflectionOf(const Arm& arm, double alpha) {
  return -solveFlexibleKinematics(arm, {Eigen::VectorXd(0), alpha}).X_BD.p.z();
}

/// Tip deflection relative to the length of the beam, from the elastica (Bisshopp and Drucker 1945).
struct Elastica {
  double alpha, deflection;
};
constexpr Elastica kElastica[] = {{0.25, 0.0828}, {1, 0.3017}, {3, 0.6033}};

TEST(Discretisation, EstimatesWhatOneSegmentLeavesOfAnElastica) {
  for (const auto& [alpha, deflection] : kElastica) {
    const double error = std::abs(deflectionOf(weightlessBeam(), alpha) - deflection);
    const auto found = discretisationOf(weightlessBeam(), {Eigen::VectorXd(0), alpha}, 1e-3);
    if (error > 5e-4) {
      EXPECT_GT(found.tip_error, 0.5 * error) << alpha;
    }
    ASSERT_GE(found.factor, 1) << alpha;
    Arm cut = weightlessBeam();
    cut.rows[0].beam->segments = found.factor;
    EXPECT_NEAR(deflectionOf(cut, alpha), deflection, 1.5e-3) << alpha << ", " << found.factor << " segments";
  }
}

TEST(Discretisation, FallsWithTheSquareOfTheSegments) {
  const Posture posture{Eigen::VectorXd(0), 1.0};
  double before = 0;
  for (const int segments : {16, 32, 64}) {
    Arm cut = weightlessBeam();
    cut.rows[0].beam->segments = segments;
    const double error = discretisationOf(cut, posture, 1).tip_error;
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 0.5) << segments;
    }
    before = error;
  }
}

TEST(Discretisation, HasNothingToEstimateWhereNoBeamBends) {
  Arm rigid = weightlessBeam();
  rigid.rows[0].beam.reset();
  EXPECT_EQ(mostSegments(rigid), 0);
  const auto found = discretisationOf(rigid, {Eigen::VectorXd(0), 1.0}, 1e-6);
  EXPECT_EQ(found.tip_error, 0);
  EXPECT_EQ(found.factor, 1);
}

TEST(Discretisation, OneSegmentIsEnoughForTheCobraAtItsRatedLoad) {
  const Arm arm = cobraArm(1);
  const Eigen::VectorXd q = Eigen::Vector4d(0, std::numbers::pi / 4, -0.5, 0.2);
  EXPECT_EQ(discretisationOf(arm, {q, 30 * 4.4482216152605}, 1e-4).factor, 1);
}

}  // namespace
}  // namespace tubeplan::deflection
