// Watch over simulated visits: false alarms, the delay of an alarm after a hidden change, and what it names.
#include "calibration/watch/change_watch.hpp"

#include <gtest/gtest.h>

#include "calibration/watch/candidate_changes.hpp"
#include "tests/calibration/watch/simulated_outage.hpp"

namespace tubeplan::calibration {
namespace {

constexpr int kVisits = 120;

const HiddenChange& hidden(std::string_view name) {
  return *std::ranges::find_if(hiddenChanges(), [&](const auto& change) { return change.name == name; });
}

const ChangeAnswer* answerOf(const Watch& watch, const HiddenChange& change) {
  if (!watch.alarm) return nullptr;
  static const deflection::Arm kArm = touchedCell({}).arm;
  const auto& answers = watch.alarm->judgement.answers;
  const auto found = std::ranges::find_if(
      answers, [&](const auto& answer) { return answer.effect == change.effect && answer.at == change.at(kArm); });
  return found == answers.end() ? nullptr : &*found;
}

Watch watchOf(const HiddenChange& change, const VisitKind& kind, int visits, int since, std::uint64_t seed) {
  SimulatedOutage outage(seed);
  WatchOptions options;
  options.finds_means = false;
  return outage.watch(outage.visits(kind, visits, since, outage.changed(change)), options);
}

TEST(ChangeWatch, IsQuietWhereNothingChanges) {
  int alarms = 0;
  for (const VisitKind& kind : kVisitKinds)
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
      const Watch watch = watchOf(hidden("none"), kind, kVisits, kVisits, seed);
      EXPECT_TRUE(watch.status == WatchStatus::kQuiet || watch.status == WatchStatus::kAlarm) << watch.reason;
      alarms += watch.status == WatchStatus::kAlarm;
    }
  EXPECT_LE(alarms, 12);  // of 125 watches; at most 1 in 20 is allowed, and 13 alarms have a probability of 0.01
}

TEST(ChangeWatch, FindsAStepOfTheBaseWithinAFewTouchesAndSaysSo) {
  int found = 0, as_base = 0, alone = 0, early = 0, delay = 0, begin = 0;
  constexpr int kOutages = 20;
  for (std::uint64_t seed = 101; seed < 101 + kOutages; ++seed) {
    SimulatedOutage outage(seed);
    const int since = 20 + outage.random().index(60);
    const Eigen::Vector3d way = outage.random().vector(1).normalized();
    Eigen::Isometry3d moved = outage.base();
    moved.translation() += 0.02 * kInch * way;
    const Watch watch = outage.watch(outage.visits(kVisits, since, outage.truth(), moved));
    if (!watch.alarm) continue;
    if (watch.alarm->measurement < since) {
      ++early;
      continue;
    }
    ++found;
    delay += watch.alarm->measurement - since + 1;
    const auto& answers = watch.alarm->judgement.answers;
    as_base += std::ranges::any_of(answers, [](const auto& answer) { return answer.effect == kBaseMoved; });
    alone += watch.alarm->kind == ChangeKind::kBaseStep;
    begin += std::abs(watch.alarm->since - since) <= 2;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const AnsweredNumber& shift = watch.alarm->judgement.base.at(axis);
      EXPECT_NEAR(shift.value, 0.02 * kInch * way[static_cast<Eigen::Index>(axis)], 5 * shift.sigma);
    }
  }
  EXPECT_GE(found, 0.95 * kOutages);
  EXPECT_LE(early, 2);
  EXPECT_GE(as_base, 0.95 * found);
  EXPECT_GE(alone, 0.7 * found);  // a few shifts look like a part that lies before the first joint
  EXPECT_GE(begin, 0.7 * found);
  EXPECT_LE(delay, 12 * found);
}

class NamedChange : public testing::TestWithParam<const char*> {};

TEST_P(NamedChange, IsAmongTheAnswersOfTouchesWithItsCourse) {
  const HiddenChange& change = hidden(GetParam());
  int alarms = 0, named = 0;
  for (std::uint64_t seed = 201; seed < 211; ++seed) {
    const Watch watch = watchOf(change, kVisitKinds[0], 150, 30, seed);
    if (!watch.alarm || watch.alarm->measurement < 30) continue;
    ++alarms;
    const ChangeAnswer* answer = answerOf(watch, change);
    named += answer && (change.is_ramp ? answer->may_be_ramp : answer->may_be_step);
  }
  EXPECT_GE(alarms, 8);
  EXPECT_GE(named, alarms - 1);
}

INSTANTIATE_TEST_SUITE_P(OfTheTable, NamedChange,
                         testing::Values("base-turn", "joint-slip", "joint-play", "growing-play", "base-creep",
                                         "warmth"));

TEST(ChangeWatch, AChangeOfTheArmIsNotCalledAStepOfTheBase) {
  const HiddenChange& change = hidden("joint-slip");
  for (std::uint64_t seed = 301; seed < 311; ++seed) {
    const Watch watch = watchOf(change, kVisitKinds[0], kVisits, 40, seed);
    ASSERT_TRUE(watch.alarm);
    EXPECT_NE(watch.alarm->kind, ChangeKind::kBaseStep);
    for (const ChangeAnswer& answer : watch.alarm->judgement.answers) EXPECT_NE(answer.effect, kBaseMoved);
  }
}

TEST(ChangeWatch, CountsOfStepsLeaveTheTruthAmongSeveralAnswers) {
  const HiddenChange& change = hidden("base-turn");
  for (const VisitKind& kind : kVisitKinds) {
    if (kind.kind != MeasurementKind::kSteps || kind.touch_every > 0) continue;
    int alarms = 0, named = 0;
    for (std::uint64_t seed = 401; seed < 404; ++seed) {
      const Watch watch = watchOf(change, kind, kVisits, 30, seed);
      if (!watch.alarm) continue;
      ++alarms;
      named += answerOf(watch, change) != nullptr;
      EXPECT_EQ(watch.alarm->test, "counts");
    }
    EXPECT_GE(alarms, 2) << kind.name;
    EXPECT_GE(named, alarms - 1) << kind.name;
  }
}

/// Counts from before the change must not favour an earlier start over the true one.
TEST(ChangeWatch, CountsOfStepsDateASlipOfAJoint) {
  const HiddenChange& change = hidden("joint-slip");
  constexpr int kSince = 70;
  int alarms = 0, named = 0, dated = 0;
  for (std::uint64_t seed = 4; seed < 8; ++seed) {
    const Watch watch = watchOf(change, kVisitKinds[1], kVisits, kSince, seed);
    if (!watch.alarm || watch.alarm->measurement < kSince) continue;
    ++alarms;
    const ChangeAnswer* answer = answerOf(watch, change);
    named += answer && answer->may_be_step;
    dated += answer && std::abs(answer->since - kSince) <= 2;
  }
  EXPECT_GE(alarms, 3);
  EXPECT_EQ(named, alarms);
  EXPECT_GE(dated, alarms - 1);
}

/// A lean of the tool alone, with the tip held, shows in the steps of a tool with lengths and in no others.
TEST(ChangeWatch, ALeanOfTheToolShowsInStepsWithLengthsAlone) {
  for (const VisitKind& kind : kVisitKinds) {
    if (kind.kind != MeasurementKind::kSteps || kind.touch_every > 0) continue;
    SimulatedOutage outage(5);
    TrueState leaning = outage.state();
    leaning.arm.tool_axis_L = Eigen::AngleAxisd(2 * kDegree, Eigen::Vector3d::UnitX()) * leaning.arm.tool_axis_L;
    WatchOptions options;
    options.finds_means = false;
    const Watch watch = outage.watch(outage.visits(kind, kVisits, 30, constantState(leaning)), options);
    EXPECT_EQ(watch.alarm.has_value(), kind.has_lengths) << kind.name;
  }
}

TEST(ChangeWatch, TwoChangesAreNotNamedAsOne) {
  int as_one = 0;
  for (std::uint64_t seed = 501; seed < 506; ++seed) {
    SimulatedOutage outage(seed);
    TrueState first = outage.state(), second;
    first.X_WB.translation().x() += 0.04 * kInch;
    second = withOffset(first, slippingRow(first.arm), 0.15 * kDegree);
    const Watch watch =
        outage.watch(outage.visits(kVisitKinds[0], kVisits, 40, [&](int n) { return n < 8 ? first : second; }));
    ASSERT_TRUE(watch.alarm);
    as_one += !watch.alarm->judgement.answers.empty();
  }
  EXPECT_LE(as_one, 1);
}

TEST(ChangeWatch, SaysWhatItsSilenceMeans) {
  const Watch by_steps = watchOf(hidden("none"), kVisitKinds[1], 60, 60, 2);
  ASSERT_EQ(by_steps.status, WatchStatus::kQuiet);
  EXPECT_FALSE(std::isfinite(by_steps.detectable.z()));  // no count of steps shows a vertical shift
  EXPECT_LT(by_steps.detectable.x(), 0.06 * kInch);
  const Watch by_touches = watchOf(hidden("none"), kVisitKinds[0], 60, 60, 2);
  ASSERT_EQ(by_touches.status, WatchStatus::kQuiet);
  EXPECT_LT(by_touches.detectable.maxCoeff(), 0.03 * kInch);
}

TEST(ChangeWatch, TellsWhatWouldSeparateTheAnswers) {
  SimulatedOutage outage(7);
  const auto visits = outage.visits(kVisitKinds[1], 100, 30, outage.changed(hidden("base-shift")));
  const Watch watch = outage.watch(visits);
  ASSERT_TRUE(watch.alarm);
  ASSERT_EQ(watch.alarm->kind, ChangeKind::kSeveral);
  ASSERT_TRUE(watch.alarm->means);
  EXPECT_GT(watch.alarm->means->pairs, 0);
  EXPECT_LE(watch.alarm->means->pairs, watch.alarm->means->of_pairs);
}

TEST(ChangeWatch, AtASingleTouchJudgesWithoutFailing) {
  SimulatedOutage outage(3);
  Eigen::Isometry3d moved = outage.base();
  moved.translation().x() += 0.5 * kInch;
  const Watch watch = outage.watch(outage.visits(1, 0, outage.truth(), moved));
  ASSERT_TRUE(watch.alarm);
  EXPECT_NE(watch.alarm->kind, ChangeKind::kNamed);
}

TEST(ChangeWatch, OfNothingIsNotComputed) {
  SimulatedOutage outage(1);
  EXPECT_EQ(outage.watch({}).status, WatchStatus::kNotComputed);
}

TEST(ChangeWatch, OfTwoSetupsIsNotComputed) {
  SimulatedOutage outage(1);
  auto visits = outage.visits(2, 2, outage.truth(), outage.base());
  visits[1].setup = "second";
  EXPECT_EQ(outage.watch(visits).status, WatchStatus::kNotComputed);
}

TEST(ChangeWatch, StopsOnRequest) {
  SimulatedOutage outage(1);
  WatchOptions options;
  options.stop = [] { return true; };
  EXPECT_EQ(outage.watch(outage.visits(3, 3, outage.truth(), outage.base()), options).status, WatchStatus::kStopped);
}

}  // namespace
}  // namespace tubeplan::calibration
