#include "planner/motion/motion_check.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "planner/motion/side_by_side.hpp"
#include "tests/planner/toy_arm.hpp"

namespace tubeplan::planner {
namespace {

using Eigen::VectorXd;
using testing::leastSampled;
using testing::shape;
using testing::ToyArm;
using testing::uniform;

const ToyArm kArm{{0.6, 0.5, 0.4}, 0.02};

VectorXd posture(double a, double b, double c) { return Eigen::Vector3d(a, b, c); }

TEST(CheckMotion, FreeMotionHasAProvedMarginBelowWhatIsSampled) {
  const CollisionWorld world(kArm.scene({{"post", shape("cylinder", {1.0, 0.7, -1, 1.0, 0.7, 1, 0.1}), {}}}));
  const auto clearance_of = kArm.clearanceOf(world);
  const VectorXd q0 = posture(-0.5, 0.2, 0.1), q1 = posture(0.2, 0.1, 0.4);
  const double sampled = leastSampled(q0, q1, clearance_of, 10000);
  ASSERT_GT(sampled, 0.05);
  const auto coarse = checkMotion(q0, q1, clearance_of, kArm.travel(world));
  EXPECT_EQ(coarse.status, MotionCheckStatus::kFree);
  EXPECT_GT(coarse.proved_margin, 0);
  EXPECT_LE(coarse.proved_margin, sampled);
  const auto fine = checkMotion(q0, q1, clearance_of, kArm.travel(world), {.accuracy = 1e-3});
  EXPECT_LE(fine.proved_margin, sampled);
  EXPECT_GT(fine.proved_margin, sampled - 1.1e-3);
  EXPECT_GT(fine.checks, coarse.checks);
  EXPECT_GE(fine.tightest.margin, sampled - 1e-3);
  EXPECT_EQ(fine.tightest.other, "post");
}

TEST(CheckMotion, BlockedMotionNamesPairAndPlace) {
  const CollisionWorld world(kArm.scene({{"post", shape("cylinder", {1.3, 0, -1, 1.3, 0, 1, 0.1}), {}}}));
  const auto result = checkMotion(posture(-0.6, 0, 0), posture(0.6, 0, 0), kArm.clearanceOf(world), kArm.travel(world));
  EXPECT_EQ(result.status, MotionCheckStatus::kBlocked);
  EXPECT_EQ(result.tightest.body, "link3");
  EXPECT_EQ(result.tightest.other, "post");
  EXPECT_NE(result.reason.find("link3 collides with post"), std::string::npos) << result.reason;
  EXPECT_NEAR(result.where, 0.5, 0.1);
  EXPECT_TRUE(std::isnan(result.proved_margin));
}

TEST(CheckMotion, StandingStillIsOneQuestion) {
  const CollisionWorld world(kArm.scene({{"wall", shape("keep_side", {1.8, 0, 0, -1, 0, 0}), {}}}));
  const auto result = checkMotion(posture(0, 0, 0), posture(0, 0, 0), kArm.clearanceOf(world), kArm.travel(world));
  EXPECT_EQ(result.status, MotionCheckStatus::kFree);
  EXPECT_EQ(result.checks, 1);
  EXPECT_NEAR(result.proved_margin, 0.28, 1e-12);
}

TEST(CheckMotion, NothingToTouchIsFreeAtOnce) {
  const ToyArm arm{{0.6, 0.5}};
  const CollisionWorld world(arm.scene({}));
  const auto result = checkMotion(Eigen::Vector2d(0, 0), Eigen::Vector2d(3, 3), arm.clearanceOf(world),
                                  arm.travel(world), {.accuracy = 1e-6});
  EXPECT_EQ(result.status, MotionCheckStatus::kFree);
  EXPECT_EQ(result.checks, 2);
}

TEST(CheckMotion, AClearanceThatCannotBeToldBlocks) {
  const auto lost_in_the_middle = [](const VectorXd& q) {
    Clearance clearance;
    clearance.distance = clearance.margin = q[0] > 0.4 && q[0] < 0.6 ? std::nan("") : 0.3;
    clearance.other = "the arm's shape did not settle";
    return clearance;
  };
  const TravelBound travel{VectorXd::Constant(1, 1.0)};
  const auto result = checkMotion(VectorXd::Zero(1), VectorXd::Ones(1), lost_in_the_middle, travel);
  EXPECT_EQ(result.status, MotionCheckStatus::kBlocked);
  EXPECT_EQ(result.reason, "the arm's shape did not settle");
}

TEST(CheckMotion, GivesUpHonestlyWhenPosturesRunOut) {
  const CollisionWorld world(kArm.scene({{"wall", shape("keep_side", {1.55, 0, 0, -1, 0, 0}), {}}}));
  const auto result =
      checkMotion(posture(-1, 0, 0), posture(1, 0, 0), kArm.clearanceOf(world), kArm.travel(world), {.max_checks = 5});
  EXPECT_EQ(result.status, MotionCheckStatus::kBlocked);
  EXPECT_EQ(result.checks, 5);
  EXPECT_NE(result.reason.find("5 postures"), std::string::npos) << result.reason;
}

/// Motions across a plate 10 micrometres thick are found blocked. The plate is at a random position, seldom at a point
/// of bisection, and the arm is as thin as a hair, so that only about a hundred-thousandth of a motion is in contact.
TEST(CheckMotion, NoThinPlateIsSteppedOver) {
  const ToyArm hair{{0.6, 0.5, 0.4}, 1e-6};
  std::mt19937_64 generator(77);
  int missed_by_steps = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const VectorXd q0 = posture(uniform(generator, -1, -0.3), 0, 0), q1 = posture(uniform(generator, 0.3, 1), 0, 0);
    const double angle = uniform(generator, -0.2, 0.2), turn = std::numbers::pi / 2 + angle;
    const CollisionWorld world(hair.scene(
        {{"plate", shape("box", {1.2 * std::cos(angle), 1.2 * std::sin(angle), 0, 1e-5, 0.2, 0.2, 0, 0, turn}), {}}}));
    const auto clearance_of = hair.clearanceOf(world);
    const auto result = checkMotion(q0, q1, clearance_of, hair.travel(world));
    EXPECT_EQ(result.status, MotionCheckStatus::kBlocked);
    EXPECT_EQ(result.tightest.other, "plate");
    if (trial < 30 && leastSampled(q0, q1, clearance_of, 10000) >= 0) ++missed_by_steps;
  }
  EXPECT_GT(missed_by_steps, 10);  // if sampling found all plates, the test would show nothing
}

/// Random motions among obstacles: no motion in which fine sampling finds contact is "free", and no motion with ample
/// clearance is "blocked".
TEST(CheckMotion, AgreesWithFineStepsOnRandomMotions) {
  const ToyArm arm{{0.6, 0.5, 0.4}, 0.02, 0.01};
  const CollisionWorld world(arm.scene({{"post", shape("cylinder", {0.9, 0.5, -1, 0.9, 0.5, 1, 0.05}), {}},
                                        {"plate", shape("box", {-0.6, 0.7, 0, 0.5, 1e-5, 0.5, 0, 0, 0.3}), {}},
                                        {"wall", shape("keep_side", {0, -1.3, 0, 0, 1, 0}), {}}}));
  const auto clearance_of = arm.clearanceOf(world);
  std::mt19937_64 generator(9);
  int free = 0, blocked = 0;
  for (int trial = 0; trial < 150; ++trial) {
    VectorXd q0(3), q1(3);
    for (double& angle : q0) angle = uniform(generator, -2, 2);
    for (double& angle : q1) angle = uniform(generator, -2, 2);
    if (clearance_of(q0).margin < 0 || clearance_of(q1).margin < 0) continue;
    const auto result = checkMotion(q0, q1, clearance_of, arm.travel(world));
    const double sampled = leastSampled(q0, q1, clearance_of, 2000);
    if (result.status == MotionCheckStatus::kFree) {
      ++free;
      EXPECT_GE(sampled, result.proved_margin);
    } else {
      ++blocked;
      EXPECT_LT(sampled, 5e-3);
    }
  }
  EXPECT_GT(free, 15);
  EXPECT_GT(blocked, 15);
}

/// Returns the result of checking a motion whose margin is `margin` [m] everywhere and whose points travel by at most
/// `travel` [m].
MotionCheckResult evenlyFree(double margin, double travel, const MotionCheckOptions& options = {}) {
  const auto clearance_of = [margin](const VectorXd&) {
    Clearance clearance;
    clearance.margin = margin;
    return clearance;
  };
  return checkMotion(posture(0, 0, 0), posture(1, 0, 0), clearance_of, {posture(travel, 0, 0)}, options);
}

TEST(CheckMotion, HalvesUntilTheEndsHaveMoreToSpareThanTheTravelBetween) {
  EXPECT_EQ(evenlyFree(1, 1.5).checks, 2);
  EXPECT_EQ(evenlyFree(1, 1.5).proved_margin, 0.25);
  EXPECT_EQ(evenlyFree(1, 2).checks, 3);  // a travel equal to the sum of the two margins does not exclude contact
  EXPECT_EQ(evenlyFree(1, 2).proved_margin, 0.5);
  EXPECT_EQ(evenlyFree(1, 5).checks, 5);
}

TEST(CheckMotion, HalvesForAccuracyDownToTheLeastTravel) {
  EXPECT_EQ(evenlyFree(1, 1, {.least_travel = 1e-4, .accuracy = 0.5}).checks, 2);
  EXPECT_EQ(evenlyFree(1, 1, {.least_travel = 1e-4, .accuracy = 0.1}).checks, 9);
  EXPECT_EQ(evenlyFree(1, 1, {.least_travel = 1, .accuracy = 0.1}).checks, 3);
  EXPECT_EQ(evenlyFree(1, 1, {.least_travel = 1.1, .accuracy = 0.1}).checks, 2);
}

/// Returns a clearance function that also computes several postures at once; `calls` counts the calls for several.
PostureClearance allAtOnce(const PostureClearance& alone, int& calls) {
  return SideBySideClearance{alone, [alone, &calls](const PostureColumns& q) {
                               ++calls;
                               MarginsSideBySide found;
                               for (Eigen::Index k = 0; k < q.cols(); ++k) {
                                 Clearance clearance = alone(q.col(k));
                                 found.margins.push_back(clearance.margin);
                                 if (k > 0 && clearance.margin >= found.margins[found.tightest]) continue;
                                 found.tightest = static_cast<std::size_t>(k);
                                 found.clearance = std::move(clearance);
                               }
                               return found;
                             }};
}

TEST(CheckMotion, AsksForTheMiddlesOfHalvesTooWhereTheyWillBeNeeded) {
  for (const bool is_far : {false, true}) {
    int calls = 0, single_calls = 0;
    const auto even = [&single_calls](const VectorXd&) {
      ++single_calls;
      Clearance clearance;
      clearance.margin = 0.1;
      return clearance;
    };
    const TravelBound travel{posture(is_far ? 1 : 0.5, 0, 0)};
    const auto result = checkMotion(posture(0, 0, 0), posture(1, 0, 0), allAtOnce(even, calls), travel);
    EXPECT_EQ(result.status, MotionCheckStatus::kFree);
    EXPECT_EQ(result.checks, is_far ? 9 : 5);
    // One call each for the ends, the middle and quarter points, and the eighth points.
    EXPECT_EQ(calls, is_far ? 3 : 2);
    EXPECT_EQ(single_calls, result.checks);  // no posture is evaluated twice or needlessly
  }
}

TEST(CheckMotion, PosturesAskedTogetherChangeNoAnswer) {
  const CollisionWorld world(kArm.scene({{"post", shape("cylinder", {1.0, 0.7, -1, 1.0, 0.7, 1, 0.1}), {}},
                                         {"wall", shape("keep_side", {-1.2, 0, 0, 1, 0, 0}), {}}}));
  const PostureClearance alone = kArm.clearanceOf(world);
  std::mt19937_64 random(7);
  int calls = 0, free = 0, blocked = 0;
  const auto same = [](double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; };
  for (int trial = 0; trial < 400; ++trial) {
    const auto any = [&] { return posture(uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -2, 2)); };
    const VectorXd q0 = any(), q1 = trial % 3 ? VectorXd(q0 + 0.2 * any()) : any();
    const MotionCheckOptions options{.least_travel = trial % 5 ? 1e-4 : 1e-2,
                                     .accuracy = trial % 2 ? 1e-3 : std::numeric_limits<double>::infinity(),
                                     .max_checks = trial % 7 ? 100000 : 9};
    const auto one = checkMotion(q0, q1, alone, kArm.travel(world), options);
    const auto all = checkMotion(q0, q1, allAtOnce(alone, calls), kArm.travel(world), options);
    EXPECT_EQ(all.status, one.status) << trial;
    EXPECT_EQ(all.reason, one.reason) << trial;
    EXPECT_EQ(all.checks, one.checks) << trial;
    EXPECT_EQ(all.where, one.where) << trial;
    EXPECT_TRUE(same(all.proved_margin, one.proved_margin)) << trial;
    EXPECT_TRUE(same(all.tightest.margin, one.tightest.margin)) << trial;
    EXPECT_EQ(describe(all.tightest), describe(one.tightest)) << trial;
    (one.status == MotionCheckStatus::kFree ? free : blocked) += 1;
  }
  EXPECT_GT(calls, 400);
  EXPECT_GT(free, 50);
  EXPECT_GT(blocked, 50);
}

}  // namespace
}  // namespace tubeplan::planner
