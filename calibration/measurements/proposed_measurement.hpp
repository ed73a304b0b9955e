// A reading that could be made. It is a type of its own, because it has no measured value.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "calibration/measurement.hpp"
#include "calibration/measurements/value_columns.hpp"
#include "calibration/placed_arm.hpp"

namespace tubeplan::calibration {

struct ProposedMeasurement {
  std::string id;
  MeasurementKind kind = MeasurementKind::kPosition;
  std::string point;  ///< point with the meaning of Measurement::point
  std::string setup;
  double load = 0;         ///< load hung from the tip [N]
  Eigen::VectorXd q;       ///< joint positions to move to [rad, m for a prismatic joint]
  Eigen::VectorXd side_q;  ///< joint positions of the side chains [rad, m]
  /// Known hole, mark or anchor of the reading [m]; nothing for an unknown place.
  std::optional<Eigen::Vector3d> known_W;
  std::optional<Eigen::Vector3d> direction_W;
  std::shared_ptr<const Measurement> reference;  ///< earlier reading from which a displacement is taken
  bool is_length_alone = false;    ///< true: only the length of the displacement is measured, not its coordinates
  std::optional<int> row;          ///< row of the arm, as in Measurement
  std::optional<Surface> surface;  ///< assumed surface of `point`, for kinds that touch one
  /// Number that its own column states, such as a ball's radius [m].
  double given = std::numeric_limits<double>::quiet_NaN();
  double sigma = std::numeric_limits<double>::quiet_NaN();       ///< expected standard deviation of a coordinate [m]
  double turn_sigma = std::numeric_limits<double>::quiet_NaN();  ///< expected standard deviation of an angle [rad]
  std::vector<int> approach_directions;                          ///< directions from which the joints are to arrive
  deflection::ConditionValues conditions;  ///< expected conditions; the time among them is the earliest for the reading
};

/// Return true if a proposed reading touches a point of known place, or of unknown place.
[[nodiscard]] bool touchesKnownPoint(const ProposedMeasurement& proposed);
[[nodiscard]] bool touchesUnknownPoint(const ProposedMeasurement& proposed);

/// Returns the values that must be written down; for a displacement either its coordinates or its length.
[[nodiscard]] ValueColumns valueColumnsOf(const ProposedMeasurement& proposed);

/// Returns a reading with the proposed conditions and joint positions, and nothing measured.
[[nodiscard]] Measurement conditionsOf(const ProposedMeasurement& proposed);

/// Returns the reading expected without noise where the arm was placed last, or nothing if the shape does not converge.
/// It serves the computation of a design, and must not enter a table of measurements.
[[nodiscard]] std::optional<Measurement> expectedReading(const PlacedArm& placed, const ProposedMeasurement& proposed);

}  // namespace tubeplan::calibration
