// One measurement: the measured values, the joint readings, and the conditions under which they were taken.
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

/// Placeholder for a number that was neither given nor computed (NaN).
inline constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

/// Kinds of measurement, in the order of the table in measurements/measurement_kinds.hpp.
enum class MeasurementKind {
  kPosition,     ///< measured position of the tip: p_W
  kTouch,        ///< tip centred at `point`, whose position is p_W (empty if unknown)
  kDeflection,   ///< measured displacement of the tip from its unloaded position at the same joint readings: p_W
  kDistance,     ///< measured distance from the anchor p_W to the tip: kind_values[0] [m]
  kAxis,         ///< measured distance of the tip from the anchor p_W along `direction_W`: kind_values[0] [m]
  kOrientation,  ///< measured roll, pitch and yaw of the tool frame in the world frame: kind_values [rad]
  kPose,         ///< position and orientation together, as in kPosition and kOrientation
  kOffset,       ///< measured offset of the hole or mark p_W from the tip, in the tool frame: kind_values [m]
  kTilt,  ///< measured angles of the axes of the tool frame or of a row's frame above the horizontal: kind_values [rad]
  kSteps,  ///< kind_values: number of tool steps that entered the hole p_W, and limits of the centring error [m]
  /// Measured displacement of the tip from its position at `reference`: p_W, or its length kind_values[0] [m].
  kRelative,
  kPlane,  ///< contact of the tip with the plane named `point`, whose position is unknown
  /// Contact of the tip with the sphere named `point`, of unknown centre and radius kind_values[0] [m] (NaN if
  /// unknown).
  kSphere,
  kPolar,      ///< measured range [m], horizontal and vertical angle [rad] from the station p_W to the tip: kind_values
  kDirection,  ///< measured azimuth and altitude of the x axis of the tool frame or of a row's frame: kind_values [rad]
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
  /// Readings of the side chains' joints, in the order of deflection/side_chains.hpp [rad, m for a prismatic joint].
  Eigen::VectorXd side_q;
  std::optional<Eigen::Vector3d> p_W;          ///< point in the world frame [m]; see MeasurementKind for its meaning
  std::optional<Eigen::Vector3d> direction_W;  ///< unit vector along which the kind measures; empty for other kinds
  /// Measurement whose tip position is the origin of this displacement; null for most kinds.
  std::shared_ptr<const Measurement> reference;
  /// Position of the measured point in the tool frame [m]; empty means the tip itself.
  std::optional<Eigen::Vector3d> p_TQ;
  /// Position of the counted section relative to the measured point, in the tool frame [m] (counted_section.hpp); empty
  /// for kinds other than `steps`.
  std::optional<Eigen::Vector3d> p_QS;
  /// Touched plane or sphere as fitted (surfaces.hpp); empty before the fit and for kinds that touch no surface.
  std::optional<Surface> surface;
  std::optional<int> row;  ///< row of the arm whose deflected frame is measured; empty means the tool frame
  /// Values of the file columns that only this kind of measurement has, in the order of those columns; NaN = not
  /// stated.
  Eigen::Vector3d kind_values = Eigen::Vector3d::Constant(kNotKnown);
  double turn_sigma = kNotKnown;           ///< standard deviation of a measured angle [rad]; NaN = not stated
  double sigma = kNotKnown;                ///< standard deviation of each measured coordinate [m]; NaN = not stated
  std::optional<Eigen::Vector3d> sigma_W;  ///< standard deviations of x, y and z [m]; empty if all equal `sigma`
  /// Error correlations of x with y, x with z, y with z; only together with sigma_W; empty means uncorrelated.
  std::optional<Eigen::Vector3d> correlation_W;
  /// Sign of each joint's last motion: -1, +1 or 0 (not known); empty if not stated.
  std::vector<int> approach_directions;
  deflection::ConditionValues conditions;  ///< conditions stated for the measurement, such as temperature and time
  bool is_held_out = false;                ///< true if the measurement validates the fit instead of contributing to it
  int line = 0;                            ///< line number in the measurement file, starting from 1
};

/// Returns the items of `all` at the indices `places`, in the order of `places`.
template <class Item>
[[nodiscard]] std::vector<Item> picked(const std::vector<Item>& all, const std::vector<int>& places) {
  std::vector<Item> some;
  for (const int place : places) some.push_back(all.at(static_cast<std::size_t>(place)));
  return some;
}

/// Returns `measurements` without those at the indices `places`, which must be in ascending order.
[[nodiscard]] inline std::vector<Measurement> withoutMeasurements(std::vector<Measurement> measurements,
                                                                  const std::vector<int>& places) {
  int place = 0;
  std::erase_if(measurements,
                [&](const Measurement&) { return std::binary_search(places.begin(), places.end(), place++); });
  return measurements;
}

}  // namespace tubeplan::calibration
