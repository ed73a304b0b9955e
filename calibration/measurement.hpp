// One reading of a session, of any kind.
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

/// A figure that nobody has stated or worked out.
inline constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

/// Rows of the table in measurements/measurement_kinds.hpp, which says what each measures.
enum class MeasurementKind {
  kPosition,     ///< p_W is the measured place of the tip
  kTouch,        ///< the tip rests centred at `point`; p_W is that place where it is known
  kDeflection,   ///< p_W is the tip's measured displacement from its unloaded place at the same joint readings
  kDistance,     ///< p_W is a fixed anchor, own[0] the measured length from it to the tip [m]
  kAxis,         ///< p_W is a fixed anchor, own[0] the distance of the tip beyond it along `direction_W` [m]
  kOrientation,  ///< own is the tool frame's roll, pitch, yaw in the world [rad]
  kPose,         ///< kPosition and kOrientation in one
  kOffset,       ///< p_W is a hole or mark, own its centre from the tip along the tool frame's axes [m]
  kTilt,         ///< own is the angles of the axes of the tool frame, or of a row's, above the horizontal [rad]
  kSteps,  ///< p_W is a hole, own the number of the tool's steps that entered, and the limits of the centring error [m]
  kRelative,   ///< p_W is the displacement of the tip from its place at `reference`, or own[0] its length [m]
  kPlane,      ///< the tip touches the plane `point`, of unknown place
  kSphere,     ///< the tip touches the sphere `point`, of unknown centre; own[0] is its radius [m] if it is known
  kPolar,      ///< p_W is a station, own the range [m], horizontal and vertical angle [rad] from it to the tip
  kDirection,  ///< own is azimuth and altitude [rad] of the x axis of the tool frame, or of a row's
};

/// A touched plane or sphere of unknown place, as fitted to the readings that touched it.
struct Surface {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();           ///< point of a plane, or centre of a sphere [m]
  Eigen::Vector3d direction_W = Eigen::Vector3d::UnitZ();  ///< normal of a plane
  double radius = 0;                                       ///< radius of a sphere [m]
};

/// Forces and moments on the tip, in the world's axes.
struct TipWrench {
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d moment_W = Eigen::Vector3d::Zero();  ///< about the tip [N m]
  bool operator==(const TipWrench&) const = default;
};

struct Measurement {
  std::string id;
  MeasurementKind kind = MeasurementKind::kPosition;
  /// Name of the touched point, shared by readings of kind touch at the same place; may be empty for other kinds.
  std::string point;
  std::string setup;  ///< name of the set-up, shared by readings with the same base pose; empty if there is one for all
  double load = 0;    ///< load hung from the tip [N]
  std::optional<TipWrench> wrench;  ///< loads on the tool in addition to `load`
  Eigen::VectorXd q;  ///< joint readings in the order of the arm's active rows [rad, m for a prismatic joint]
  /// Readings of the side chains' joints, in their order (deflection/side_chains.hpp) [rad, m].
  Eigen::VectorXd side_q;
  std::optional<Eigen::Vector3d> p_W;            ///< point of the reading in the world frame [m]
  std::optional<Eigen::Vector3d> direction_W;    ///< unit vector, for kinds that measure along one
  std::shared_ptr<const Measurement> reference;  ///< reading from whose tip this one is taken; null for most kinds
  std::optional<Eigen::Vector3d> p_TQ;  ///< measured point from the tip in the tool frame [m]; nothing: the tip itself
  /// Touched surface, for kinds that touch one, once it has been fitted (surfaces.hpp).
  std::optional<Surface> surface;
  std::optional<int> row;  ///< row of the arm whose deflected frame is read, for kinds that may; nothing: the tool's
  /// Numbers of its kind's own columns, in their order; NaN = not stated.
  Eigen::Vector3d own = Eigen::Vector3d::Constant(kNotKnown);
  double turn_sigma = kNotKnown;                 ///< rad, one standard deviation of a measured angle
  double sigma = kNotKnown;                      ///< m, one standard deviation of each measured coordinate;
                                                 ///< NaN = not stated
  std::optional<Eigen::Vector3d> sigma_W;        ///< m, the same of x, y and z apart, where they differ
  std::optional<Eigen::Vector3d> correlation_W;  ///< of x with y, x with z, y with z; only beside sigma_W. None: no two
                                                 ///< of them have errors in common
  std::vector<int> approach_directions;  ///< of each joint's last motion: -1, 0 (not known), +1; empty where not stated
  deflection::ConditionValues conditions;  ///< that it states
  bool is_held_out = false;                ///< kept from the fit, to judge it by
  int line = 0;                            ///< in its file, from 1
};

/// Returns the items at these places, in their order.
template <class Item>
[[nodiscard]] std::vector<Item> picked(const std::vector<Item>& all, const std::vector<int>& places) {
  std::vector<Item> some;
  for (const int place : places) some.push_back(all.at(static_cast<std::size_t>(place)));
  return some;
}

/// Without those at these places, which ascend.
[[nodiscard]] inline std::vector<Measurement> withoutReadings(std::vector<Measurement> readings,
                                                              const std::vector<int>& places) {
  int place = 0;
  std::erase_if(readings,
                [&](const Measurement&) { return std::binary_search(places.begin(), places.end(), place++); });
  return readings;
}

}  // namespace tubeplan::calibration
