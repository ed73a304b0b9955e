// Pose of the tip, rigid and deflected, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/units.hpp"
#include "app/studies/positioning/base_standing.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::app {

struct PoseFigures {
  Eigen::Vector3d position, angles;  ///< position [m]; angles about fixed axes [rad]
};

[[nodiscard]] PoseFigures poseFiguresOf(const deflection::PoseOf<double>& X);

/// Returns the figures of the tool frame at the tip, without and with deflection.
[[nodiscard]] PoseFigures rigidToolOf(const deflection::FlexibleKinematics& shape);
[[nodiscard]] PoseFigures flexibleToolOf(const deflection::FlexibleKinematics& shape);

/// Returns deflected less rigid figures; angles within half a turn.
[[nodiscard]] PoseFigures poseChange(const deflection::FlexibleKinematics& shape);

/// Returns {position: [3], fixed_angles: [3]}.
[[nodiscard]] nlohmann::json figuresJson(const PoseFigures& figures, const Units& units);

/// Returns {rigid, flexible, change, iterations}, each tip in the arm's base frame.
[[nodiscard]] nlohmann::json poseFiguresJson(const deflection::FlexibleKinematics& shape, const Units& units);

/// Returns {tip_error, needed, warning} for a posture: the tip's error because of too few beam segments; the number of
/// segments that leave less than a hundredth of the deflection; a warning if the stated segments leave more, else an
/// empty text.
[[nodiscard]] nlohmann::json segmentsJson(const Cell& cell, const deflection::Posture& posture,
                                          const deflection::FlexibleKinematics& shape);

/// Returns {"position": [3], "rpy": [3]} in file units.
[[nodiscard]] nlohmann::json poseJson(const Eigen::Isometry3d& X, const Units& units);

/// Returns {status, words, placed, touches}: how a base was placed, with words that continue "proved" and "steps".
[[nodiscard]] nlohmann::json standingJson(const BaseStanding& standing);

/// Returns the same of bases that each run calibrates by `touches`, with the number of runs whose touches do not fit.
[[nodiscard]] nlohmann::json eachRunJson(int touches, std::uint64_t misfits);

/// Returns a base's pose with how it was placed.
[[nodiscard]] nlohmann::json placedBaseJson(const Eigen::Isometry3d& X_WB, const BaseStanding& standing,
                                            const Units& units);

/// Returns joint readings in file units to the last bit, because rounded ones would move the tip by more than a plan
/// promises.
[[nodiscard]] nlohmann::json jointValuesJson(const Eigen::VectorXd& q, const Cell& cell);

}  // namespace tubeplan::app
