// Measurement that is proposed but not yet made. It is a separate type because it has no measured values.
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
  std::string point;  ///< name of the point, as in Measurement::point
  std::string setup;
  double load = 0;         ///< load hung from the tip [N]
  Eigen::VectorXd q;       ///< joint positions to move to [rad, m for a prismatic joint]
  Eigen::VectorXd side_q;  ///< joint positions of the side chains [rad, m for a prismatic joint]
  /// Known position of the hole, mark or anchor [m]; empty for an unknown place.
  std::optional<Eigen::Vector3d> known_W;
  std::optional<Eigen::Vector3d> direction_W;
  std::shared_ptr<const Measurement> reference;  ///< earlier measurement that is the reference of a displacement
  bool is_length_alone = false;    ///< true if only the length of the displacement is measured, not its coordinates
  std::optional<int> row;          ///< row of the arm whose frame is measured, as in Measurement
  std::optional<Surface> surface;  ///< assumed surface named `point`, for kinds that touch a surface
  /// Value stated in the kind's own column, such as a ball's radius [m].
  double given = std::numeric_limits<double>::quiet_NaN();
  double sigma = std::numeric_limits<double>::quiet_NaN();       ///< expected standard deviation of a coordinate [m]
  double turn_sigma = std::numeric_limits<double>::quiet_NaN();  ///< expected standard deviation of an angle [rad]
  std::vector<int> approach_directions;    ///< signs of the joints' last motions on arrival, as in Measurement
  deflection::ConditionValues conditions;  ///< expected conditions; the time is the earliest one for the measurement
};

/// Return true if the proposed measurement is a touch of a point whose position is known, or unknown, respectively.
[[nodiscard]] bool touchesKnownPoint(const ProposedMeasurement& proposed);
[[nodiscard]] bool touchesUnknownPoint(const ProposedMeasurement& proposed);

/// Returns the columns that must be filled in when the measurement is made; for a displacement, either its coordinates
/// or its length.
[[nodiscard]] ValueColumns valueColumnsOf(const ProposedMeasurement& proposed);

/// Returns a measurement with the proposed conditions and joint positions, but without measured values.
[[nodiscard]] Measurement conditionsOf(const ProposedMeasurement& proposed);

/// Returns the noise-free measurement predicted with the arm at its latest base pose; empty if the shape does not
/// converge. The measurement is only for the optimization of designs and must not be mixed with real measurements.
[[nodiscard]] std::optional<Measurement> expectedMeasurement(const PlacedArm& placed,
                                                             const ProposedMeasurement& proposed);

}  // namespace tubeplan::calibration
