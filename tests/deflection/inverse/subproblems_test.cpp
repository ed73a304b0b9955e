// The closed forms for rotations about known axes must satisfy their equations, and a step of FreeMotion must not undo
// earlier steps.
#include "deflection/inverse/subproblems.hpp"

#include <gtest/gtest.h>

#include "deflection/inverse/free_motion.hpp"
#include "tests/deflection/inverse/drawn_chain.hpp"

namespace tubeplan::deflection {
namespace {

using Eigen::MatrixXd, Eigen::Vector2d, Eigen::Vector3d, Eigen::VectorXd;
using testing::Draw;

TEST(Subproblems, CosineAndSineHaveBothTheirSolutions) {
  Draw draw(1);
  for (int n = 0; n < 200; ++n) {
    const double a = draw(2), b = draw(2), x = draw(3), c = a * std::cos(x) + b * std::sin(x);
    const auto solutions = solveCosineSine(a, b, c);
    ASSERT_FALSE(solutions.empty());
    double nearest = 1;
    for (const double found : solutions) {
      EXPECT_NEAR(a * std::cos(found) + b * std::sin(found), c, 1e-12);
      nearest = std::min(nearest, std::abs(std::remainder(found - x, 2 * std::numbers::pi)));
    }
    EXPECT_LT(nearest, 1e-6);
  }
  EXPECT_TRUE(solveCosineSine(1, 1, 1.5).empty());
  EXPECT_TRUE(solveCosineSine(0, 0, 0).empty());
  EXPECT_EQ(solveCosineSine(3, 4, 5.000001, 1e-6).size(), 1u);
}

TEST(Subproblems, TurnsLeadToWhereTheyAreAskedTo) {
  Draw draw(2);
  for (int n = 0; n < 200; ++n) {
    const Vector3d axis = draw.vector(1).normalized(), a = draw.vector(1), h = draw.vector(1).normalized();
    const double turn = draw(3);
    const Vector3d b = Eigen::AngleAxisd(turn, axis) * a;
    EXPECT_NEAR(std::remainder(turnBetween(axis, a, b) - turn, 2 * std::numbers::pi), 0, 1e-9);
    // Each solution, rotated back, must give the point its original coordinate along h.
    for (const double q : solveOffset(axis, h, b, h.dot(a)))
      EXPECT_NEAR(h.dot(Eigen::AngleAxisd(-q, axis) * b), h.dot(a), 1e-12);
  }
}

TEST(Subproblems, TwoLinksReachThePlaceWithTheElbowEitherWay) {
  Draw draw(3);
  for (int n = 0; n < 200; ++n) {
    const Vector2d elbow(1 + draw(0.3), draw(0.3)), wrist = elbow + Vector2d(0.8 + draw(0.2), draw(0.2));
    const Vector2d w = turned(elbow + turned(wrist - elbow, draw(2.5)), draw(3));
    const auto solutions = solveTwoLinks(elbow, wrist, w);
    ASSERT_EQ(solutions.size(), 2u);
    for (const Vector2d& s : solutions) EXPECT_LT((turned(elbow + turned(wrist - elbow, s[1]), s[0]) - w).norm(), 1e-9);
  }
}

// The first step must be the shortest that meets its equations; the second must meet its own without undoing the first.
TEST(FreeMotion, StepsKeepWhatThoseBeforeBroughtAbout) {
  Draw draw(4);
  for (int n = 0; n < 100; ++n) {
    using Slopes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, Eigen::Dynamic>;
    using Sides = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
    Slopes first(3, 6), second(2, 6);
    for (Eigen::Index k = 0; k < 6; ++k) first.col(k) = draw.vector(1), second.col(k) = draw.vector(1).head<2>();
    const Sides wanted = draw.vector(1), then = draw.vector(1).head<2>();
    FreeMotion free(6);
    const VectorXd step = free.take<3>(first, wanted, 1e-4);
    EXPECT_LT((first * step - wanted).norm(), 1e-8);
    const VectorXd shortest = first.transpose() * (first * first.transpose()).ldlt().solve(wanted);
    EXPECT_LT((step - shortest).norm(), 1e-8);
    const VectorXd more = free.take<3>(second, then - second * step, 1e-4);
    EXPECT_LT((first * more).norm(), 1e-8);
    EXPECT_LT((second * (step + more) - then).norm(), 1e-7);
  }
}

TEST(FreeMotion, DirectionsBelowTheFloorAreLeftAsTheyAre) {
  MatrixXd slope = MatrixXd::Zero(2, 3);
  slope(0, 0) = 1;
  slope(1, 1) = 1e-3;
  FreeMotion free(3);
  const VectorXd step = free.take<Eigen::Dynamic>(slope, VectorXd::Ones(2), 0.01);
  EXPECT_NEAR(step[0], 1, 1e-12);
  EXPECT_EQ(step[1], 0);
  FreeMotion finer(3);
  EXPECT_NEAR(finer.take<Eigen::Dynamic>(slope, VectorXd::Ones(2), 1e-4)[1], 1000, 1e-6);
}

}  // namespace
}  // namespace tubeplan::deflection
