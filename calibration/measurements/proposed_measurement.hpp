// A reading that could be made. What is proposed is another type than what was measured: it has no measured value.
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
  std::string point;  ///< as of Measurement
  std::string setup;
  double load = 0;         ///< N, hung from the tip
  Eigen::VectorXd q;       ///< where the joints are brought to, rad (m for a prismatic joint)
  Eigen::VectorXd side_q;  ///< the same of the side chains' joints
  std::optional<Eigen::Vector3d>
      known_W;  ///< m, the hole, mark or anchor that it is taken of; none of a measured place
  std::optional<Eigen::Vector3d> direction_W;
  std::shared_ptr<const Measurement> reference;             ///< the reading made that a way is taken from
  bool is_length_alone = false;                             ///< of that way its length is measured, not its coordinates
  std::optional<int> row;                                   ///< of the arm, as of Measurement
  std::optional<Surface> surface;                           ///< that `point` is taken to be, of kinds that touch one
  double given = std::numeric_limits<double>::quiet_NaN();  ///< m, of it what its own column states (a ball's radius)
  double sigma = std::numeric_limits<double>::quiet_NaN();  ///< m, that a coordinate would have
  double turn_sigma = std::numeric_limits<double>::quiet_NaN();  ///< rad, that an angle would have
  std::vector<int> approach_directions;                          ///< in which the joints are to arrive
  deflection::ConditionValues conditions;  ///< that are expected; nothing can be read before the time among them
};

/// Return whether a proposed reading touches a point whose place is, or is not, known.
[[nodiscard]] bool touchesKnownPoint(const ProposedMeasurement& proposed);
[[nodiscard]] bool touchesUnknownPoint(const ProposedMeasurement& proposed);

/// Returns what must be written down of it: of a way either its coordinates or its length.
[[nodiscard]] ValueColumns valueColumnsOf(const ProposedMeasurement& proposed);

/// Returns the reading's conditions, its joints where they are brought to, and nothing measured.
[[nodiscard]] Measurement conditionsOf(const ProposedMeasurement& proposed);

/// Returns what the arm where it stands last would read, without noise: for the arithmetic of a design, never for a
/// table. Nothing where the shape does not converge.
[[nodiscard]] std::optional<Measurement> expectedReading(const PlacedArm& placed, const ProposedMeasurement& proposed);

}  // namespace tubeplan::calibration
