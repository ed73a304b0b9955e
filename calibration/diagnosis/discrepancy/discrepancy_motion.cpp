#include "calibration/diagnosis/discrepancy/discrepancy_motion.hpp"

#include "calibration/measurements/measurement_kinds.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd;

namespace {

/// Returns the change of the measurement's rows per unit shift of the tool and per unit shift or rotation of the base;
/// the columns of the joints are zero.
MatrixXd rigidDisplacements(const MeasuredSlope& slope, const ToolPose& tool, const Eigen::Vector3d& base_W,
                            Index joints) {
  MatrixXd displacements = MatrixXd::Zero(slope.by_place.rows(), joints + 9);
  displacements.middleCols(joints, 3) = slope.by_place * tool.R_WT;
  displacements.middleCols(joints + 3, 3) = slope.by_place;
  displacements.rightCols(3) = -slope.by_place * deflection::crossMatrix<double>(tool.p_W - base_W);
  if (slope.by_turn.size()) displacements.rightCols(3) += slope.by_turn;
  return displacements;
}

/// Returns the motions at the two postures of a displacement: its own posture, and its reference posture with the
/// opposite sign. They are separate because the function of a term has different values at the two postures.
std::vector<Motion> motionsOfDisplacement(MeasurementPredictor& predictor, const PlacedArm& placed,
                                          const Eigen::Isometry3d& X_WB, const Measurement& measurement,
                                          const Departure& from) {
  std::vector<Motion> motions{{measurement, {}}, {measurementAt(from), {}}};
  const Index joints = measurement.q.size();
  std::vector<ToolPose> tools;
  for (const Motion& motion : motions) {
    const auto tool = toolAt(placed.arm, X_WB, motion.at);
    if (!tool) return {};
    tools.push_back(*tool);
  }
  ToolPose way = tools.front();
  way.p_W -= tools.back().p_W;
  const MeasuredSlope slope = predictedSlope(measurement, way);
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const Prediction tip = predictor.predictTip(X_WB, postureOf(motions[k].at, placed.arm, X_WB), {.by_joints = true});
    if (!tip.ok) return {};
    motions[k].displacements = rigidDisplacements(slope, tools[k], X_WB.translation(), joints);
    motions[k].displacements.leftCols(joints) = slope.by_place * tip.by_joints;
  }
  motions.back().displacements *= -1;
  return motions;
}

}  // namespace

std::vector<Motion> motionsOf(MeasurementPredictor& predictor, const PlacedArm& placed,
                              const Measurement& measurement) {
  const auto& X_WB = basePoseAt(placed, measurement);
  if (const auto from = departureOf(measurement))
    return motionsOfDisplacement(predictor, placed, X_WB, measurement, *from);
  const Prediction prediction = predictor.predict(X_WB, measurement, {.by_joints = true});
  const auto frame = frameAt(placed.arm, X_WB, measurement);
  if (!prediction.ok || !frame) return {};
  Motion motion{measurement, {}};
  motion.displacements =
      rigidDisplacements(predictedSlope(measurement, *frame), *frame, X_WB.translation(), measurement.q.size());
  motion.displacements.leftCols(measurement.q.size()) = prediction.by_joints;
  return {motion};
}

}  // namespace tubeplan::calibration
