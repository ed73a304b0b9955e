// A simulated outage: a calibrated arm that touches holes, with a change of arm or base at one of them.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "calibration/watch/change_watch.hpp"
#include "tests/calibration/estimation/cobra_touches.hpp"

namespace tubeplan::calibration {

inline constexpr double kTouchNoise = 0.005;  ///< noise of each coordinate of a touch [in]

inline ArmUncertainty stiffnessesByTenPercent() {
  ArmUncertainty uncertainty = ArmUncertainty::none();
  uncertainty.stiffness = 0.1;
  return uncertainty;
}

/// An arm at work: its stiffnesses are drawn at random about those of its file, six touches calibrate it, and then it
/// touches holes in random order.
class SimulatedOutage {
 public:
  explicit SimulatedOutage(std::uint64_t seed) : random_(seed), cell_(touchedCell({})), nominal_(cell_.arm) {
    truth_ = drawnArm(nominal_, stiffnessesByTenPercent(), seed);
    planTouches();
    BaseCalibrationOptions options;
    options.arm = stiffnessesByTenPercent();
    std::vector<Measurement> touches;
    const int count = static_cast<int>(cell_.plans.size());
    for (int k = 0; k < 6; ++k) touches.push_back(touched(k * (count - 1) / 5, truth_, cell_.X_WB_true));
    found_ = calibrateBase(nominal_, touches, cell_.X_WB_nominal, options);
    if (found_.status != CalibrationStatus::kDone)
      throw std::runtime_error("the arm cannot be calibrated: " + found_.reason);
  }

  /// Returns `count` touches at random holes; from the touch `since` on, arm and base are the given ones.
  std::vector<Measurement> visits(int count, int since, const deflection::Arm& arm, const Eigen::Isometry3d& X_WB) {
    std::vector<Measurement> visits;
    for (int k = 0; k < count; ++k) {
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
    if (cell_.plans.size() < 10) throw std::runtime_error("too few holes are in reach");
  }

  Measurement touched(int hole, const deflection::Arm& arm, const Eigen::Isometry3d& X_WB) {
    TouchSimulationOptions options;
    options.sigma = kTouchNoise * kInch;
    options.seed = random_.seed();
    auto touch = simulateTouches(arm, X_WB, {cell_.plans[static_cast<std::size_t>(hole)]}, options).touches.front();
    touch.sigma = kTouchNoise * kInch;
    return touch;
  }

  RandomStream random_;
  TouchedCell cell_;
  deflection::Arm nominal_, truth_;
  BaseCalibration found_;
};

}  // namespace tubeplan::calibration
