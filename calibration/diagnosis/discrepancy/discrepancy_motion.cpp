#include "calibration/diagnosis/discrepancy/discrepancy_motion.hpp"

#include "calibration/measurements/measurement_kinds.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd;

namespace {

/// Returns the change of the reading's rows per unit shift of the tool and per unit shift or rotation of the base; the
/// columns of the joints are zero.
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
/// opposite sign. They are kept apart because the function of a term has different values at the two postures.
std::vector<Motion> motionsOfDisplacement(ReadingPredictor& predictor, const PlacedArm& placed,
                                          const Eigen::Isometry3d& X_WB, const Measurement& reading,
                                          const Departure& from) {
  std::vector<Motion> motions{{reading, {}}, {readingAt(from), {}}};
  const Index joints = reading.q.size();
  std::vector<ToolPose> tools;
  for (const Motion& motion : motions) {
    const auto tool = toolAt(placed.arm, X_WB, motion.at);
    if (!tool) return {};
    tools.push_back(*tool);
  }
  ToolPose way = tools.front();
  way.p_W -= tools.back().p_W;
  const MeasuredSlope slope = predictedSlope(reading, way);
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

std::vector<Motion> motionsOf(ReadingPredictor& predictor, const PlacedArm& placed, const Measurement& reading) {
  const auto& X_WB = basePoseAt(placed, reading);
  if (const auto from = departureOf(reading)) return motionsOfDisplacement(predictor, placed, X_WB, reading, *from);
  const Prediction prediction = predictor.predict(X_WB, reading, {.by_joints = true});
  const auto frame = frameAt(placed.arm, X_WB, reading);
  if (!prediction.ok || !frame) return {};
  Motion motion{reading, {}};
  motion.displacements =
      rigidDisplacements(predictedSlope(reading, *frame), *frame, X_WB.translation(), reading.q.size());
  motion.displacements.leftCols(reading.q.size()) = prediction.by_joints;
  return {motion};
}

}  // namespace tubeplan::calibration
