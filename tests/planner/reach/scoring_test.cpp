#include "planner/reach/scoring.hpp"

#include <gtest/gtest.h>

#include "tests/planner/workcell.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d;
using testing::holeOf;
using testing::mockup;
using testing::sideways;

/// Returns the first branch of a tube, with its approach, for the cell's own model.
TubeBranch visitOf(const Workcell& cell, int tube, Compensation mode = Compensation::kViaPoint) {
  CompensationOptions options;
  options.mode = mode;
  return compensate(cell, holeOf(cell, tube), options).front();
}

TEST(ScoreVisit, TheModelItselfIsCentredAndTakesEveryStep) {
  const Workcell cell = mockup();
  for (int tube : testing::tubesOf(cell, "spread:6,-R39C58")) {
    const Centring score = scoreVisit(cell, holeOf(cell, tube), visitOf(cell, tube));
    EXPECT_LT(score.error, 1e-6 * kInch);
    EXPECT_LT(std::abs(score.height), 1e-6 * kInch);
    EXPECT_LE(score.approach_deviation, 0.0011 * kInch);
    EXPECT_EQ(score.steps, tubesheets::stepsInserted(cell.tool, Eigen::Vector2d::Zero(), score.lean));
    EXPECT_GE(score.steps, 2);
  }
}

TEST(ScoreVisit, OnlyTheLeanKeepsACentredToolFromGoingIn) {
  Workcell cell = mockup();
  cell.tool.lengths.clear();
  for (int tube : testing::tubesOf(cell, "spread:6,-R39C58"))
    EXPECT_EQ(scoreVisit(cell, holeOf(cell, tube), visitOf(cell, tube)).steps, 3);
}

TEST(ScoreVisit, AMovedBaseIsTheErrorToTheLastDigit) {
  const Workcell cell = mockup();
  const int tube = testing::tubesOf(cell, "R10C40").front();
  const TubeBranch visit = visitOf(cell, tube);
  const Vector3d shift(0.03 * kInch, -0.04 * kInch, 0.02 * kInch);
  Workcell truth = cell;
  truth.X_WB.translation() += shift;
  const Centring score = scoreVisit(truth, holeOf(cell, tube), visit);
  EXPECT_NEAR(score.offset.x(), shift.x(), 1e-10);
  EXPECT_NEAR(score.offset.y(), shift.y(), 1e-10);
  EXPECT_NEAR(score.height, shift.z(), 1e-10);
  EXPECT_NEAR(score.error, 0.05 * kInch, 1e-10);
  EXPECT_EQ(score.steps, 2);  // 0.050 in is within the tolerances 0.089 and 0.058 in, not within 0.010 in
  EXPECT_NEAR(score.approach_deviation, 0.05 * kInch, 0.0011 * kInch);
}

TEST(ScoreVisit, WhatTheTrueArmDoesBeyondItsModelIsAdded) {
  Workcell cell = mockup();
  cell.tool.lengths.clear();  // ignores the tilt
  const int tube = testing::tubesOf(cell, "R10C40").front();
  const TubeBranch visit = visitOf(cell, tube);
  const struct {
    double error_inches;
    int steps;
  } cases[] = {{0.0, 3}, {0.0099, 3}, {0.0101, 2}, {0.0579, 2}, {0.0581, 1}, {0.0889, 1}, {0.0891, 0}, {5, 0}};
  for (const auto& [error, steps] : cases)
    for (double turn : {0.0, 1.0, 2.5, 4.0}) {
      const Vector3d off(error * kInch * std::cos(turn), error * kInch * std::sin(turn), 0.3 * kInch);
      const Centring score = scoreVisit(cell, holeOf(cell, tube), visit, off);
      EXPECT_NEAR(score.error, error * kInch, 1e-10);
      EXPECT_NEAR(score.height, 0.3 * kInch, 1e-10);
      EXPECT_EQ(score.steps, steps) << error << " in";
      EXPECT_NEAR(score.approach_deviation, error * kInch, 0.0011 * kInch);
    }
}

TEST(ScoreVisit, ATubePlannedRigidlyMissesByItsDeflection) {
  const Workcell cell = mockup();
  const int tube = testing::tubesOf(cell, "R10C40").front();
  const TubeBranch visit = visitOf(cell, tube, Compensation::kNone);
  const Vector3d deflection =
      testing::deflectedTip(cell, visit.q) - testing::deflectedTip(testing::rigid(cell), visit.q);
  const Centring score = scoreVisit(cell, holeOf(cell, tube), visit);
  EXPECT_NEAR(score.error, deflection.head<2>().norm(), 1e-9);
  EXPECT_NEAR(score.height, deflection.z(), 1e-9);
  EXPECT_LT(score.height, -0.1 * kInch);
}

TEST(ScoreVisit, AgainstTheShippedTrueArmTheErrorIsTheDistanceOfTheTwoTips) {
  const Workcell cell = mockup(), truth = mockup("mockup-true.yaml");
  for (int tube : testing::tubesOf(cell, "spread:5,-R39C58")) {
    const TubeBranch visit = visitOf(cell, tube);
    const Centring score = scoreVisit(truth, holeOf(cell, tube), visit);
    EXPECT_NEAR(score.error, sideways(testing::deflectedTip(truth, visit.q), testing::deflectedTip(cell, visit.q)),
                1e-9);
    EXPECT_EQ(score.steps, tubesheets::stepsInserted(truth.tool, score.error));
  }
}

TEST(CountSteps, CountsEachScoreOnceAndNothingElse) {
  std::vector<Centring> scores(9);
  const int steps[] = {3, 0, 2, 2, -1, 3, 3, 1, 7};
  for (std::size_t k = 0; k < scores.size(); ++k) scores[k].steps = steps[k];
  EXPECT_EQ(countSteps(scores, 3), (std::vector<int>{1, 1, 2, 3}));
  EXPECT_EQ(countSteps({}, 3), (std::vector<int>{0, 0, 0, 0}));
}

TEST(Scoring, AVisitScoresAloneAsAfterOthers) {
  const Workcell cell = mockup();
  Workcell truth = cell;
  truth.load += 30;
  TipPrediction tips(truth);
  for (int tube : testing::tubesOf(cell, "spread:6")) {
    const Vector3d hole_W = holeOf(cell, tube);
    const TubeBranch visit = visitOf(cell, tube);
    const Centring after_others = scoreVisit(tips, truth, hole_W, visit), alone = scoreVisit(truth, hole_W, visit);
    EXPECT_EQ(after_others.offset, alone.offset) << tube;
    EXPECT_EQ(after_others.approach_deviation, alone.approach_deviation) << tube;
    EXPECT_EQ(after_others.steps, alone.steps) << tube;
    EXPECT_GT(alone.error, 0) << tube;
  }
}

}  // namespace
}  // namespace tubeplan::planner
