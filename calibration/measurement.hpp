// One reading of a session, whatever its kind.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "deflection/conditions.hpp"

namespace tubeplan::calibration {

using deflection::Condition;

/// Rows of the table in measurements/measurement_kinds.hpp, which says what each measures.
enum class MeasurementKind {
  kPosition,     ///< p_W is the tip's measured place
  kTouch,        ///< the tip rests centred at `point`; p_W is that place where it is known
  kDeflection,   ///< p_W is the tip's measured displacement from its unloaded place at the same joint readings
  kDistance,     ///< p_W is a fixed anchor, own[0] the measured length from it to the tip [m]
  kAxis,         ///< p_W is a fixed anchor, own[0] how far the tip is beyond it along `direction_W` [m]
  kOrientation,  ///< own is the tool frame's roll, pitch, yaw in the world [rad]
  kPose,         ///< kPosition and kOrientation in one
  kOffset,       ///< p_W is a hole or mark, own its centre from the tip along the tool frame's axes [m]
  kTilt,         ///< own is how far the axes of the tool frame, or of a row's, rise above the horizontal [rad]
  kSteps,        ///< p_W is a hole, own how many steps of the tool went in, and what that says of the centring error
  kRelative,     ///< p_W is the way that the tip has come from where it was at `reference`, or own[0] its length [m]
  kPlane,        ///< the tip touches the plane `point`, whose place nobody knows
  kSphere,       ///< the tip touches the sphere `point`, whose centre nobody knows; own[0] its radius [m] where known
  kPolar,        ///< p_W is a station, own the range [m], horizontal and vertical angle [rad] from it to the tip
  kDirection,    ///< own is azimuth and altitude [rad] of the x axis of the tool frame, or of a row's
};

/// Where a touched plane or sphere of unknown place is taken to be by the readings that touched it.
struct Surface {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();           ///< m, of a plane a point of it, of a sphere its centre
  Eigen::Vector3d direction_W = Eigen::Vector3d::UnitZ();  ///< of a plane its normal
  double radius = 0;                                       ///< m, of a sphere
};

/// Forces and moments on the tip, in the world's axes.
struct TipWrench {
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d moment_W = Eigen::Vector3d::Zero();  ///< N m, about the tip
  bool operator==(const TipWrench&) const = default;
};

struct Measurement {
  std::string id;
  MeasurementKind kind = MeasurementKind::kPosition;
  std::string
      point;  ///< readings of kind touch with the same point touched the same place; may be empty for other kinds
  std::string setup;  ///< readings with the same set-up share a base pose; empty where there is one for all
  double load = 0;    ///< N, hung from the tip
  std::optional<TipWrench> wrench;  ///< beside that load: what pushes, pulls or twists the tool
  Eigen::VectorXd q;       ///< joint readings in the order of the arm's active rows, rad (m for a prismatic joint)
  Eigen::VectorXd side_q;  ///< the same of the side chains' joints, in their order (deflection/side_chains.hpp)
  std::optional<Eigen::Vector3d> p_W;            ///< m, in the world frame
  std::optional<Eigen::Vector3d> direction_W;    ///< a unit vector, of kinds that measure along one
  std::shared_ptr<const Measurement> reference;  ///< the reading whose tip this one is taken from; none of most kinds
  std::optional<Eigen::Vector3d> p_TQ;  ///< m, the measured point from the tip in the tool frame; none: the tip itself
  std::optional<Surface> surface;       ///< that it touches, of kinds that do, once one has been settled (surfaces.hpp)
  std::optional<int> row;  ///< of the arm, whose frame as deflected is read, of kinds that may; none: the tool's
  /// Numbers of its kind's own columns, in their order; NaN = not stated.
  Eigen::Vector3d own = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  double turn_sigma = std::numeric_limits<double>::quiet_NaN();  ///< rad, one standard deviation of a measured angle
  double sigma = std::numeric_limits<double>::quiet_NaN();  ///< m, one standard deviation of each measured coordinate;
                                                            ///< NaN = not stated
  std::optional<Eigen::Vector3d> sigma_W;                   ///< m, the same of x, y and z apart, where they differ
  std::optional<Eigen::Vector3d> correlation_W;  ///< of x with y, x with z, y with z; only beside sigma_W. None: no two
                                                 ///< of them have errors in common
  std::vector<int> approach_directions;  ///< of each joint's last motion: -1, 0 (not known), +1; empty where not stated
  deflection::ConditionValues conditions;  ///< that it states
  bool is_held_out = false;                ///< kept from the fit, to judge it by
  int line = 0;                            ///< in its file, from 1
};

/// Without those at these places, which ascend.
[[nodiscard]] inline std::vector<Measurement> withoutReadings(std::vector<Measurement> readings,
                                                              const std::vector<int>& places) {
  int place = 0;
  std::erase_if(readings,
                [&](const Measurement&) { return std::binary_search(places.begin(), places.end(), place++); });
  return readings;
}

}  // namespace tubeplan::calibration
