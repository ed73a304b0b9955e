// Watch over simulated visits: false alarms, and the delay and the kind of an alarm after a hidden step of the base or
// of a stiffness.
#include "calibration/watch/change_watch.hpp"

#include <gtest/gtest.h>

#include "tests/calibration/estimation/cobra_touches.hpp"

namespace tubeplan::calibration {
namespace {

constexpr int kVisits = 120;
constexpr double kNoise = 0.005;  // of each coordinate of a touch [in]

ArmUncertainty stiffnessesByTenPercent() {
  ArmUncertainty uncertainty = ArmUncertainty::none();
  uncertainty.stiffness = 0.1;
  return uncertainty;
}

/// An arm at work: calibrated by six touches, then visiting holes in random order.
class Outage {
 public:
  explicit Outage(std::uint64_t seed) : random_(seed), cell_(touchedCell({})), nominal_(cell_.arm) {
    truth_ = drawnArm(nominal_, stiffnessesByTenPercent(), seed);
    planTouches();
    BaseCalibrationOptions options;
    options.arm = stiffnessesByTenPercent();
    std::vector<Measurement> touches;
    const int count = static_cast<int>(cell_.plans.size());
    for (int k = 0; k < 6; ++k) touches.push_back(touched(k * (count - 1) / 5, truth_, cell_.X_WB_true));
    found_ = calibrateBase(nominal_, touches, cell_.X_WB_nominal, options);
    EXPECT_EQ(found_.status, CalibrationStatus::kDone);
  }

  /// Returns touches at random holes; from the visit `since` on, the arm and base are the changed ones.
  std::vector<Measurement> visits(int since, const deflection::Arm& arm, const Eigen::Isometry3d& X_WB) {
    std::vector<Measurement> visits;
    for (int k = 0; k < kVisits; ++k) {
      const int hole = random_.index(static_cast<int>(cell_.plans.size()));
      visits.push_back(k < since ? touched(hole, truth_, cell_.X_WB_true) : touched(hole, arm, X_WB));
    }
    return visits;
  }

  [[nodiscard]] Watch watch(const std::vector<Measurement>& visits) const {
    return watchForChange({found_.arm, found_.X_WB, found_.uncertainty}, visits);
  }

  [[nodiscard]] const deflection::Arm& truth() const { return truth_; }
  [[nodiscard]] const Eigen::Isometry3d& base() const { return cell_.X_WB_true; }
  RandomStream& random() { return random_; }

 private:
  /// Plans touches on a grid of holes, as far as the true arm reaches them.
  void planTouches() {
    const Eigen::Vector3d gravity_B = deflection::gravityInBase(nominal_, cell_.X_WB_nominal);
    for (int i = 0; i < 7; ++i)
      for (int j = 0; j < 5; ++j) {
        const Eigen::Vector3d hole = Eigen::Vector3d(-36 + 12 * i, 8 + 8 * j, 0) * kInch;
        const deflection::ToolGoal goal{cell_.X_WB_nominal.inverse() * hole, Eigen::Vector3d::UnitZ()};
        const auto branches = deflection::solveInverseKinematics(nominal_, goal, 0, gravity_B).branches;
        if (branches.empty() || branches.front().status != deflection::BranchStatus::kConverged) continue;
        const std::string number = std::to_string(cell_.plans.size() + 1);
        const TouchPlan plan{"T" + number, "H" + number, hole, branches.front().q};
        if (simulateTouches(truth_, cell_.X_WB_true, {plan}, {}).status == TouchSimulationStatus::kDone)
          cell_.plans.push_back(plan);
      }
    ASSERT_GE(cell_.plans.size(), 10u);
  }

  Measurement touched(int hole, const deflection::Arm& arm, const Eigen::Isometry3d& X_WB) {
    TouchSimulationOptions options;
    options.sigma = kNoise * kInch;
    options.seed = random_.seed();
    auto touch = simulateTouches(arm, X_WB, {cell_.plans[static_cast<std::size_t>(hole)]}, options).touches.front();
    touch.sigma = kNoise * kInch;
    return touch;
  }

  RandomStream random_;
  TouchedCell cell_;
  deflection::Arm nominal_, truth_;
  BaseCalibration found_;
};

TEST(ChangeWatch, IsQuietWhereNothingChanges) {
  int alarms = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Outage outage(seed);
    const Watch watch = outage.watch(outage.visits(kVisits, outage.truth(), outage.base()));
    EXPECT_TRUE(watch.status == WatchStatus::kQuiet || watch.status == WatchStatus::kAlarm) << watch.reason;
    alarms += watch.status == WatchStatus::kAlarm;
  }
  EXPECT_LE(alarms, 4);  // at most 1 in 20 is allowed; 5 of 40 have a probability below 0.05
}

TEST(ChangeWatch, FindsAStepOfTheBaseWithinAFewTouchesAndSaysSo) {
  int found = 0, as_base = 0, early = 0, delay = 0, begin = 0;
  constexpr int kOutages = 40;
  for (std::uint64_t seed = 101; seed < 101 + kOutages; ++seed) {
    Outage outage(seed);
    const int since = 20 + outage.random().index(60);
    const Eigen::Vector3d way = outage.random().vector(1).normalized();
    Eigen::Isometry3d moved = outage.base();
    moved.translation() += 0.02 * kInch * way;
    const Watch watch = outage.watch(outage.visits(since, outage.truth(), moved));
    if (!watch.alarm) continue;
    if (watch.alarm->reading < since) {
      ++early;
      continue;
    }
    ++found;
    delay += watch.alarm->reading - since + 1;
    as_base += watch.alarm->kind == ChangeKind::kBaseStep;
    begin += std::abs(watch.alarm->since - since) <= 2;
    for (int axis = 0; axis < 3; ++axis)
      if (watch.alarm->kind == ChangeKind::kBaseStep) {
        EXPECT_NEAR(watch.alarm->step[axis], 0.02 * kInch * way[axis], 5 * watch.alarm->step_sigma[axis]);
      }
  }
  EXPECT_GE(found, 0.95 * kOutages);
  EXPECT_LE(early, 2);
  EXPECT_GE(as_base, 0.9 * found);
  EXPECT_GE(begin, 0.7 * found);
  EXPECT_LE(delay, 12 * found);
}

TEST(ChangeWatch, AChangeOfTheArmIsNotCalledAStepOfTheBase) {
  int found = 0, as_base = 0;
  for (std::uint64_t seed = 201; seed <= 220; ++seed) {
    Outage outage(seed);
    deflection::Arm changed = outage.truth();
    for (auto& row : changed.rows)
      if (row.name == "forearm") row.joint.offset += 0.15 * kDegree;  // a joint that has slipped
    const Watch watch = outage.watch(outage.visits(40, changed, outage.base()));
    found += watch.status == WatchStatus::kAlarm && watch.alarm->reading >= 40;
    as_base += watch.alarm && watch.alarm->kind == ChangeKind::kBaseStep;
  }
  EXPECT_GE(found, 19);
  EXPECT_LE(as_base, 2);
}

TEST(ChangeWatch, OfNothingIsNotComputed) {
  Outage outage(1);
  EXPECT_EQ(outage.watch({}).status, WatchStatus::kNotComputed);
}

}  // namespace
}  // namespace tubeplan::calibration
