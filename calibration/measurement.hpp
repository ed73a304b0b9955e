// A measurement, also called a measurement: what was measured, at which joint readings and under which load.
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

/// Value of a number that is neither stated nor computed: NaN.
inline constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

/// Kinds of measurement, in the order of the table in measurements/measurement_kinds.hpp.
enum class MeasurementKind {
  kPosition,     ///< p_W is the measured position of the tip
  kTouch,        ///< the tip rests centred at `point`; p_W is the position of that point, empty if unknown
  kDeflection,   ///< p_W is the tip's measured displacement from its unloaded position at the same joint readings
  kDistance,     ///< p_W is a fixed anchor, own[0] the measured distance from the anchor to the tip [m]
  kAxis,         ///< p_W is a fixed anchor, own[0] the distance of the tip beyond the anchor along `direction_W` [m]
  kOrientation,  ///< own is roll, pitch and yaw of the tool frame in the world frame [rad]
  kPose,         ///< position and orientation in one measurement: the values of kPosition and kOrientation
  kOffset,       ///< p_W is a hole or mark, own its centre relative to the tip, in the tool frame [m]
  kTilt,         ///< own holds the angles above the horizontal of the axes of the tool frame or of a row's frame [rad]
  kSteps,  ///< p_W is a hole; own is the number of tool steps that entered it, and the limits of the centring error [m]
  kRelative,  ///< p_W is the displacement of the tip from its position at `reference`, or own[0] its length [m]
  kPlane,     ///< the tip touches the plane named `point`, whose position is unknown
  kSphere,    ///< the tip touches the sphere named `point`, of unknown centre; own[0] is its radius [m], NaN if unknown
  kPolar,     ///< p_W is a station; own is range [m], horizontal and vertical angle [rad] to the tip
  kDirection,  ///< own is azimuth and altitude [rad] of the x axis of the tool frame or of a row's frame
};

/// A touched plane or sphere of unknown position, as fitted to the measurements that touched it.
struct Surface {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();           ///< point of a plane, or centre of a sphere [m]
  Eigen::Vector3d direction_W = Eigen::Vector3d::UnitZ();  ///< unit normal of a plane
  double radius = 0;                                       ///< radius of a sphere [m]
};

/// Force and moment on the tip, in world axes.
struct TipWrench {
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();   ///< force [N]
  Eigen::Vector3d moment_W = Eigen::Vector3d::Zero();  ///< moment about the tip [N m]
  bool operator==(const TipWrench&) const = default;
};

struct Measurement {
  std::string id;
  MeasurementKind kind = MeasurementKind::kPosition;
  /// Name of the touched point, plane or sphere, shared by all measurements that touch it; may be empty for other
  /// kinds.
  std::string point;
  /// Name of the set-up, shared by measurements with the same base pose; empty if all measurements share one base pose.
  std::string setup;
  double load = 0;                  ///< load hung from the tip [N]
  std::optional<TipWrench> wrench;  ///< force and moment on the tip in addition to `load`
  Eigen::VectorXd q;  ///< joint readings in the order of the arm's active rows [rad, m for a prismatic joint]
  /// Measurements of the side chains' joints, in the order of deflection/side_chains.hpp [rad, m for a prismatic
  /// joint].
  Eigen::VectorXd side_q;
  std::optional<Eigen::Vector3d> p_W;          ///< point in the world frame [m], with the meaning stated at `kind`
  std::optional<Eigen::Vector3d> direction_W;  ///< unit vector along which the kind measures; empty for other kinds
  /// Measurement whose tip position is the origin of this displacement; null for most kinds.
  std::shared_ptr<const Measurement> reference;
  std::optional<Eigen::Vector3d> p_TQ;  ///< position of the measured point in the tool frame [m]; empty: the tip itself
  /// Touched plane or sphere as fitted (surfaces.hpp); empty before the fit and for kinds that touch no surface.
  std::optional<Surface> surface;
  std::optional<int> row;  ///< row of the arm whose deflected frame is measured; empty: the tool frame
  /// Values of the file columns that only this kind of measurement has, in the order of those columns; NaN = not
  /// stated.
  Eigen::Vector3d own = Eigen::Vector3d::Constant(kNotKnown);
  double turn_sigma = kNotKnown;           ///< standard deviation of a measured angle [rad]; NaN = not stated
  double sigma = kNotKnown;                ///< standard deviation of each measured coordinate [m]; NaN = not stated
  std::optional<Eigen::Vector3d> sigma_W;  ///< standard deviations of x, y and z [m]; empty if all equal `sigma`
  /// Error correlations of x with y, x with z, y with z; only together with sigma_W; empty: uncorrelated.
  std::optional<Eigen::Vector3d> correlation_W;
  /// Sign of each joint's last motion: -1, +1 or 0 (not known); empty if not stated.
  std::vector<int> approach_directions;
  deflection::ConditionValues conditions;  ///< conditions stated for the measurement, such as temperature and time
  bool is_held_out = false;                ///< true: not used in the fit, but to validate it
  int line = 0;                            ///< line number in the measurement file, from 1
};

/// Returns the items of `all` at the indices `places`, in the order of `places`.
template <class Item>
[[nodiscard]] std::vector<Item> picked(const std::vector<Item>& all, const std::vector<int>& places) {
  std::vector<Item> some;
  for (const int place : places) some.push_back(all.at(static_cast<std::size_t>(place)));
  return some;
}

/// Returns `readings` without those at the indices `places`, which must be in ascending order.
[[nodiscard]] inline std::vector<Measurement> withoutMeasurements(std::vector<Measurement> measurements,
                                                                  const std::vector<int>& places) {
  int place = 0;
  std::erase_if(measurements,
                [&](const Measurement&) { return std::binary_search(places.begin(), places.end(), place++); });
  return measurements;
}

}  // namespace tubeplan::calibration
