// A simulated outage: a calibrated arm that visits holes, with a change of arm or base at one of the visits.
#pragma once

#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "calibration/measurements/counted_section.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/simulation/hidden_changes.hpp"
#include "calibration/watch/change_watch.hpp"
#include "tests/calibration/estimation/cobra_touches.hpp"

namespace tubeplan::calibration {

inline constexpr double kTouchNoise = 0.005;   ///< noise of each coordinate of a touch [in]
inline constexpr double kCameraNoise = 0.005;  ///< noise of each coordinate of an offset seen by a camera [in]

inline ArmUncertainty stiffnessesByTenPercent() {
  ArmUncertainty uncertainty = ArmUncertainty::none();
  uncertainty.stiffness = 0.1;
  return uncertainty;
}

/// Kind of measurement made at the visits of an outage.
struct VisitKind {
  const char* name;
  MeasurementKind kind;
  int touch_every = 0;       ///< every so many visits, the hole is touched instead; 0: never
  bool has_lengths = false;  ///< true if the tool's steps have lengths, so that tilt keeps steps out
};
inline constexpr VisitKind kVisitKinds[] = {
    {"touch", MeasurementKind::kTouch},           {"steps", MeasurementKind::kSteps},
    {"steps-touch", MeasurementKind::kSteps, 50}, {"long-steps", MeasurementKind::kSteps, 0, true},
    {"offset", MeasurementKind::kOffset},
};

/// An arm at work: its stiffnesses are drawn at random about those of its file, six touches calibrate it, and then it
/// visits holes in random order.
class SimulatedOutage {
 public:
  explicit SimulatedOutage(std::uint64_t seed) : random_(seed), cell_(touchedCell({})), nominal_(cell_.arm) {
    tool_ = *app::readCell(TUBEPLAN_SOURCE_DIR "/app/cells/mockup.yaml").tool;
    truth_ = {drawnArm(nominal_, stiffnessesByTenPercent(), seed), cell_.X_WB_true};
    planTouches();
    BaseCalibrationOptions options;
    options.arm = stiffnessesByTenPercent();
    std::vector<Measurement> touches;
    const int count = static_cast<int>(cell_.plans.size());
    for (int k = 0; k < 6; ++k) touches.push_back(touched(k * (count - 1) / 5, truth_));
    found_ = calibrateBase(nominal_, touches, cell_.X_WB_nominal, options);
    if (found_.status != CalibrationStatus::kDone)
      throw std::runtime_error("the arm cannot be calibrated: " + found_.reason);
  }

  /// Returns the states of arm and base since a change from the table.
  ChangedState changed(const HiddenChange& change) {
    return change.make(truth_, [this] { return random_.vector(1).normalized(); });
  }

  /// Returns `count` visits of random holes; from the visit `since` on, the true arm and base are the changed ones.
  std::vector<Measurement> visits(const VisitKind& kind, int count, int since, const ChangedState& changed) {
    if (!kind.has_lengths) tool_.lengths.clear();
    std::vector<Measurement> visits;
    for (int k = 0; k < count; ++k) {
      const int hole = random_.index(static_cast<int>(cell_.plans.size()));
      const bool touches = kind.touch_every > 0 && (k + 1) % kind.touch_every == 0;
      const TrueState& now = k < since ? truth_ : (changed_ = changed(k - since + 1));
      visits.push_back(visited(touches ? MeasurementKind::kTouch : kind.kind, hole, now));
      visits.back().id = "V" + std::to_string(k + 1);
    }
    return visits;
  }

  /// Returns touches with a change that does not grow.
  std::vector<Measurement> visits(int count, int since, const deflection::Arm& arm, const Eigen::Isometry3d& X_WB) {
    return visits(kVisitKinds[0], count, since, [&](int) { return TrueState{arm, X_WB}; });
  }

  [[nodiscard]] Watch watch(const std::vector<Measurement>& visits, const WatchOptions& options = {}) const {
    return watchForChange({found_.arm, found_.X_WB, found_.uncertainty, 0, tool_}, visits, options);
  }

  [[nodiscard]] const TrueState& state() const { return truth_; }
  [[nodiscard]] const deflection::Arm& truth() const { return truth_.arm; }
  [[nodiscard]] const Eigen::Isometry3d& base() const { return truth_.X_WB; }
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
        if (simulateTouches(truth_.arm, truth_.X_WB, {plan}, {}).status == TouchSimulationStatus::kDone)
          cell_.plans.push_back(plan);
      }
    if (cell_.plans.size() < 10) throw std::runtime_error("too few holes are in reach");
  }

  Measurement visited(MeasurementKind kind, int hole, const TrueState& now) {
    if (kind == MeasurementKind::kTouch) return touched(hole, now);
    Measurement visit = commanded(kind, hole);
    Measurement true_visit = visit;
    for (Eigen::Index j = 0; j < visit.q.size(); ++j) true_visit.q[j] += random_.normal(now.arm.joint(j).encoder_sigma);
    const auto tool = toolAt(now.arm, now.X_WB, true_visit);
    if (!tool) throw std::runtime_error("a visit does not converge");
    if (kind == MeasurementKind::kSteps) {
      const auto axis = toolAxisAt(now.arm, now.X_WB, true_visit);
      visit.kind_values[0] = tubesheets::stepsInserted(tool_, (tool->p_W - *visit.p_W).head<2>(), axis->lean());
      visit.sigma = kVisitSigma;
    } else {
      visit.sigma = kCameraNoise * kInch;
      kindOf(visit).record(*tool, 1, random_.vector(visit.sigma), visit);
    }
    return visit;
  }

  /// Returns a visit at the joint values by which the calibrated model reaches the hole.
  Measurement commanded(MeasurementKind kind, int hole) {
    const TouchPlan& plan = cell_.plans[static_cast<std::size_t>(hole)];
    if (!commands_.contains(hole))
      commands_[hole] =
          reachPlaces(found_.arm, found_.X_WB, {plan.p_WH}, {plan.q_start}, 0, Eigen::Vector3d::UnitZ()).front().q;
    Measurement visit = plannedTouch(plan, commands_[hole], 0, kTouchNoise * kInch);
    visit.kind = kind;
    return visit;
  }

  Measurement touched(int hole, const TrueState& now) {
    TouchSimulationOptions options;
    options.sigma = kTouchNoise * kInch;
    options.seed = random_.seed();
    auto touch =
        simulateTouches(now.arm, now.X_WB, {cell_.plans[static_cast<std::size_t>(hole)]}, options).touches.front();
    touch.sigma = kTouchNoise * kInch;
    return touch;
  }

  RandomStream random_;
  TouchedCell cell_;
  tubesheets::SteppedTool tool_;  // the mock-up's
  deflection::Arm nominal_;
  TrueState truth_, changed_;
  BaseCalibration found_;
  std::map<int, Eigen::VectorXd> commands_;
};

}  // namespace tubeplan::calibration
