#include "calibration/measurements/predict_all.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "calibration/measurements/shifted_joints.hpp"
#include "deflection/kinematics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::Vector3d;

bool areForKernels(const deflection::Arm& arm, const std::vector<Measurement>& measurements) {
  if (!arm.mountings.empty() || !arm.side_chains.empty()) return false;
  if (!std::ranges::all_of(arm.effects, deflection::shiftsJoints)) return false;
  return std::none_of(measurements.begin(), measurements.end(), [](const Measurement& measurement) {
    const Measurement* from = referenceOf(measurement);
    return measurement.row || measurement.wrench || (from && from->wrench);
  });
}

namespace {

constexpr std::size_t kMeasurementsOfCore = 128;  // measurements per block for one core, solved side by side
constexpr std::size_t kMeasurementsInTurn =
    16;  // measurements per block for one core, solved one at a time with one prepared arm

/// Arguments of predictAll(): the measurements to predict, and what to compute for each.
struct PredictionTask {
  const PlacedArm& placed;
  const std::vector<Measurement>& measurements;
  const std::vector<int>& base_pose_of;
  const PredictionRequest& request;
  const std::function<void(std::size_t, const Prediction&)>& each;

  [[nodiscard]] const Eigen::Isometry3d& X_WB(std::size_t k) const {
    return placed.base_poses[static_cast<std::size_t>(base_pose_of[k])].X_WB;
  }
};

bool predictInTurn(const PredictionTask& task, std::size_t first, std::size_t count) {
  MeasurementPredictor predictor(task.placed.arm);
  for (std::size_t k = first; k < first + count; ++k) {
    const Prediction prediction = predictor.predict(task.X_WB(k), task.measurements[k], task.request);
    if (!prediction.ok) return false;
    task.each(k, prediction);
  }
  return true;
}

/// Prediction of a block of measurements side by side (SIMD). Reference postures of displacements follow the
/// measurements' own postures.
class SideBySide {
 public:
  explicit SideBySide(const PredictionTask& task) : task_(task) {
    if (!task.placed.arm.effects.empty()) shifted_.emplace(task.placed.arm, task.request);
  }

  /// Returns the arm whose shapes are solved.
  [[nodiscard]] const deflection::Arm& arm() const { return shifted_ ? shifted_->bareArm() : task_.placed.arm; }

  bool predict(deflection::Kinematics& kinematics, std::size_t first, std::size_t count) {
    const deflection::Arm& arm = task_.placed.arm;
    place(first, count);
    kinematics.solveWithDerivatives(batch_, shifted_ ? shifted_->variables() : variablesOf(task_.request, arm), tips_);
    if (!std::ranges::all_of(tips_.status, [](auto s) { return s == deflection::KinematicsStatus::kConverged; }))
      return false;
    tool_frame_ = toolFrame(arm);
    prediction_.ok = true;
    for (std::size_t k = first; k < first + count; ++k) {
      const Measurement& measurement = task_.measurements[k];
      moveTo(static_cast<Index>(k - first), seesTurn(measurement), frame_);
      if (const Index from = from_[k - first]; from >= 0) {
        moveTo(from, false, reference_);
        frame_.subtract(reference_, ownJointsOf(measurement, task_.request, arm));
      }
      predictOf(frame_, arm, task_.X_WB(k), measurement, task_.request, prediction_);
      task_.each(k, prediction_);
    }
    return true;
  }

 private:
  void place(std::size_t first, std::size_t count) {
    const deflection::Arm& arm = task_.placed.arm;
    from_.assign(count, -1);
    auto postures = static_cast<Index>(count);
    for (std::size_t k = 0; k < count; ++k)
      if (isDisplacement(task_.measurements[first + k])) from_[k] = postures++;
    batch_.resize(arm.jointCount(), postures);
    if (shifted_) postures_.resize(static_cast<std::size_t>(postures));
    for (std::size_t k = first; k < first + count; ++k) {
      const Measurement& measurement = task_.measurements[k];
      const Vector3d gravity_B = deflection::gravityInBase(arm, task_.X_WB(k));
      const auto put = [&](Index at, const Measurement& of, double load) {
        batch_.q.col(at) = of.q;
        batch_.load[at] = load;
        batch_.gravity_B.col(at) = gravity_B;
        if (!shifted_) return;
        auto& posture = postures_[static_cast<std::size_t>(at)];
        posture = postureOf(of, arm, task_.X_WB(k));
        batch_.q.col(at) = shifted_->valuesAt(posture);
      };
      put(static_cast<Index>(k - first), measurement, measurement.load);
      if (const auto from = departureOf(measurement))
        put(from_[k - first], *from->measurement, from->is_unloaded ? 0 : from->measurement->load);
    }
  }

  void moveTo(Index posture, bool with_turn, FrameMotion& frame) {
    frame.p_BF = tips_.poses.col(posture).head<3>();
    if (with_turn) frame.R_BF = tips_.X_BD(posture).R * tool_frame_;
    auto& by_variables = shifted_ ? by_variables_ : frame.by_BF;
    by_variables.resize(6, tips_.jacobian.rows() / 6);
    by_variables.reshaped() = tips_.jacobian.col(posture);
    if (shifted_) shifted_->compose(postures_[static_cast<std::size_t>(posture)], by_variables, frame.by_BF);
  }

  const PredictionTask& task_;
  std::optional<ShiftedJoints> shifted_;  ///< the joints' shifts by the arm's effects; empty if it has none
  deflection::PostureBatch batch_;
  std::vector<deflection::Posture> postures_;  ///< postures of the batch as read; only with `shifted_`
  deflection::TipBatch tips_;
  std::vector<Index> from_;  ///< index of the reference posture, -1 if there is none
  Eigen::Matrix3d tool_frame_;
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_variables_;
  FrameMotion frame_, reference_;  ///< reused for successive measurements
  Prediction prediction_;          ///< reused for successive measurements
};

}  // namespace

bool predictAll(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                const std::vector<int>& base_pose_of, const PredictionRequest& request, const StopQuestion& stop,
                const std::function<void(std::size_t, const Prediction&)>& each, deflection::Kinematics* prepared) {
  const PredictionTask task{placed, measurements, base_pose_of, request, each};
  const bool side_by_side =
      areForKernels(placed.arm, measurements) && (placed.arm.effects.empty() || !request.by_joints);
  if (side_by_side && prepared && placed.arm.effects.empty() && measurements.size() <= kMeasurementsOfCore)
    return SideBySide(task).predict(*prepared, 0, measurements.size());
  const auto predictBlock = [&](std::size_t first, std::size_t count) {
    if (!side_by_side) return predictInTurn(task, first, count);
    SideBySide block(task);
    deflection::Kinematics kinematics(block.arm());
    return block.predict(kinematics, first, count);
  };
  if (side_by_side && measurements.size() <= kMeasurementsOfCore) return predictBlock(0, measurements.size());
  std::atomic<bool> ok = true;
  const tbb::blocked_range<std::size_t> blocks(0, measurements.size(),
                                               side_by_side ? kMeasurementsOfCore : kMeasurementsInTurn);
  tbb::parallel_for(blocks, [&](const auto& range) {
    if (ok && (shouldStop(stop) || !predictBlock(range.begin(), range.size()))) ok = false;
  });
  return ok;
}

}  // namespace tubeplan::calibration
