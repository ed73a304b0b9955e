// Description of a kind of measurement: which part of the tip's pose it measures, what a measurement must state, and
// how measurements are simulated.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "calibration/measurement.hpp"
#include "calibration/measurements/value_columns.hpp"

namespace tubeplan::calibration {

/// Pose of the tool in the world frame, or of a row's frame for a measurement of that row. For a displacement, `p_W` is
/// the displacement, and the rotation is not measured.
struct ToolPose {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< position in the world frame [m]
  /// Rotation of the tool frame; valid only for kinds that depend on the tool's rotation.
  Eigen::Matrix3d R_WT = Eigen::Matrix3d::Identity();
};

/// Measured values, up to 6 rows [m]; angles [rad] are multiplied by kTurnLever.
using MeasuredValue = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
using MeasuredRows = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 6, 3>;

/// Covariance of the measured values [m^2], one row and column per value.
using MeasuredCovariance = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

/// Derivatives of measured values with respect to the tool's pose in the world frame.
struct MeasuredSlope {
  MeasuredRows by_place;
  MeasuredRows by_turn;  ///< derivatives per rad of rotation about the world axes; empty if rotation has no effect
};

/// Derivatives of measured values with respect to the parameters of an unknown place, which all measurements of that
/// place share.
using PlaceColumns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 4>;

/// Lever [m] by which angles are multiplied, so that all rows are lengths when measurements are weighted and reported.
inline constexpr double kTurnLever = 0.1;

/// Reference position of a displacement: the tip at another measurement, or the unloaded tip at the same joint
/// readings.
struct Departure {
  const Measurement* measurement = nullptr;
  bool is_unloaded = false;
};

/// Known positions and directions from which the target of a simulated measurement is taken.
struct KnownPlaces {
  std::optional<Eigen::Vector3d> point_W;  ///< centre of the hole or mark [m]; empty if unknown
  std::optional<Eigen::Vector3d> anchor_W, direction_W;
  Eigen::Vector3d up_W = Eigen::Vector3d::UnitZ();  ///< direction against gravity
};

/// Missing part of a measurement: a sentence that states it, and advice to the user.
struct MeasurementLack {
  std::string what, advice;
};

/// Reports that x, y, z are missing, which most kinds need; empty if the measurement states them.
[[nodiscard]] inline std::optional<MeasurementLack> lackOfPlace(const Measurement& measurement,
                                                                const std::string& kind) {
  if (measurement.p_W) return std::nullopt;
  return MeasurementLack{"the reading of kind " + kind + " has no x, y, z", "write its coordinates"};
}

/// Standard deviations per coordinate of simulated measurements [m]: of a tracker (0.003 in), of a tip brought under a
/// hole (0.030 in), and of a tip centred by hand (0.005 in).
inline constexpr double kPositionSigma = 7.62e-5, kVisitSigma = 7.62e-4, kTouchSigma = 1.27e-4;

struct MeasurementKindRow {
  MeasurementKind kind;
  const char* name;  ///< name in the column `kind` of a measurement file
  int rows = 3;
  int turn_rows = 0;  ///< number of rows that are angles, which come last
  int (*rows_of)(const Measurement& measurement) =
      nullptr;                                   ///< number of rows, if it differs between measurements; else null
  std::span<const MeasuredColumn> columns = {};  ///< columns of the values in Measurement::own, up to three

  bool has_coordinates = false;  ///< true if the first three rows are x, y, z in the world frame
  bool is_touch = false;         ///< true if the tip rests centred at `point`, whose position may be unknown
  bool is_place = false;         ///< true if p_W is the position of the tip
  /// True if the values are a displacement from the tip at another measurement, given by p_W or Measurement::own.
  bool is_from_measurement = false;
  bool names_hole = false;      ///< true if `point` may name a hole, whose centre is p_W
  bool is_centring = false;     ///< true if the arm brings the tool under the point p_W as accurately as it can
  bool has_anchor = false;      ///< true if p_W is the fixed point from which the instrument measures
  bool is_from_origin = false;  ///< true if p_W is the world's origin unless stated
  bool has_direction = false;   ///< true if the instrument measures along direction_W
  bool is_to_gravity = false;   ///< true if direction_W points up, against gravity
  /// True if own is (number of steps that entered, lower bound, upper bound); see steps.hpp.
  bool counts_steps = false;
  bool is_by_scale = true;  ///< true if lengths are multiplied by the measuring system's scale, which may be in error
  bool sees_turn = false;   ///< true if the values depend on the tool's rotation
  /// True if the instrument may be fixed to a row of the arm (Measurement::row) instead of the tool.
  bool may_be_of_row = false;

  MeasuredValue (*value)(const Measurement& measurement, const ToolPose& tool);
  MeasuredSlope (*slope)(const Measurement& measurement, const ToolPose& tool);
  /// Returns the measured values; zero for a touch of an unknown point, whose position the fit eliminates.
  MeasuredValue (*measured)(const Measurement& measurement);
  /// Writes the measured values of a tool at this pose into `measurement`, with lengths multiplied by `scale` and with
  /// `noise` [m] added.
  void (*record)(const ToolPose& tool, double scale, const MeasuredValue& noise, Measurement& measurement);

  /// Returns the missing data of a measurement other than measured values; `kind` is the kind's name. Null for kinds
  /// whose values depend on the arm alone.
  std::optional<MeasurementLack> (*lack)(const Measurement& measurement, const std::string& kind) = lackOfPlace;
  double usual_sigma = kPositionSigma;

  /// Returns the columns that hold measured values; the kind's other columns describe the target of the measurement.
  ValueColumns (*value_columns)(std::span<const MeasuredColumn> kind_columns) = allKindColumns;
  /// Returns true if the values of a measurement are possible. Null if all values are possible.
  bool (*is_possible)(const Measurement& measurement) = nullptr;

  /// Copies the target position or direction from `places` into a simulated measurement. Null for kinds without a
  /// target.
  void (*state)(const KnownPlaces& places, Measurement& measurement) = nullptr;

  /// Returns the reference position of a displacement; null for other kinds.
  Departure (*departure)(const Measurement& measurement) = nullptr;

  /// Returns the tip's position in the world frame [m], for kinds that state the position by other values than p_W;
  /// null for kinds that state p_W.
  Eigen::Vector3d (*place)(const Measurement& measurement) = nullptr;

  /// Functions of kinds that touch a surface of unknown position: the number of parameters that determine the surface,
  /// the derivatives of the values with respect to these parameters, and the fit of the surface to the points that
  /// touched it. The fit returns false and leaves the surface unchanged if the points do not determine it.
  int (*place_numbers)(const Measurement& measurement) = nullptr;
  PlaceColumns (*by_place_numbers)(const Measurement& measurement, const ToolPose& tool) = nullptr;
  bool (*settle)(const Eigen::Matrix3Xd& points_W, const Measurement& measurement, Surface& surface) = nullptr;
  /// Simulator functions of kinds that touch a surface: a surface through a point with a given normal, and the
  /// surface's point nearest to a given point.
  Surface (*through)(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W) = nullptr;
  Eigen::Vector3d (*nearest)(const Surface& surface, const Eigen::Vector3d& p_W) = nullptr;
};

}  // namespace tubeplan::calibration
