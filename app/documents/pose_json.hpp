// Poses of the tip (rigid and deflected) and of the base, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/units.hpp"
#include "app/studies/positioning/base_standing.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::app {

struct PoseFigures {
  Eigen::Vector3d position, angles;  ///< position [m]; rotation angles about fixed axes [rad]
};

[[nodiscard]] PoseFigures poseFiguresOf(const deflection::PoseOf<double>& X);

/// Returns the pose of the tool frame at the tip without deflection.
[[nodiscard]] PoseFigures rigidToolOf(const deflection::FlexibleKinematics& shape);
[[nodiscard]] PoseFigures flexibleToolOf(const deflection::FlexibleKinematics& shape);

/// Returns the deflected pose minus the rigid pose; angles are within half a turn.
[[nodiscard]] PoseFigures poseChange(const deflection::FlexibleKinematics& shape);

/// Returns {position: [3], fixed_angles: [3]} in file units.
[[nodiscard]] nlohmann::json figuresJson(const PoseFigures& figures, const Units& units);

/// Returns {rigid, flexible, change, deflection, iterations}; the poses of the tip are in the arm's base frame.
[[nodiscard]] nlohmann::json poseFiguresJson(const deflection::FlexibleKinematics& shape, const Units& units);

/// Returns {tip_error, needed, warning} for a posture. `tip_error` is the error of the tip caused by too few beam
/// segments. `needed` is the number of segments with which this error is below a hundredth of the deflection. `warning`
/// is empty if the stated number of segments suffices.
[[nodiscard]] nlohmann::json segmentsJson(const Cell& cell, const deflection::Posture& posture,
                                          const deflection::FlexibleKinematics& shape);

/// Returns {position: [3], rpy: [3]} in file units.
[[nodiscard]] nlohmann::json poseJson(const Eigen::Isometry3d& X, const Units& units);

/// Returns {status, words, placed, touches}, which state how a base was determined; `words` is a phrase to follow
/// "proved" or "steps".
[[nodiscard]] nlohmann::json standingJson(const BaseStanding& standing);

/// Returns standingJson() for runs that each calibrate their own base from `touches` touches, with `misfits`, the
/// number of runs whose touches do not fit.
[[nodiscard]] nlohmann::json eachRunJson(int touches, std::uint64_t misfits);

/// Returns a base pose together with standingJson(), which states how it was determined.
[[nodiscard]] nlohmann::json placedBaseJson(const Eigen::Isometry3d& X_WB, const BaseStanding& standing,
                                            const Units& units);

/// Returns joint values in file units at full precision: rounding would move the tip by more than the stated accuracy
/// of a plan.
[[nodiscard]] nlohmann::json jointValuesJson(const Eigen::VectorXd& q, const Cell& cell);

}  // namespace tubeplan::app
