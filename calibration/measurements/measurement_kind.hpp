// A kind of reading: what it measures of the tip's pose, what its row must state, how it is simulated.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "calibration/measurement.hpp"
#include "calibration/measurements/value_columns.hpp"

namespace tubeplan::calibration {

/// Pose of the tool in the world, or of a row's frame for a reading of that row. For a displacement `p_W` is the
/// displacement, and its rotation is not measured.
struct ToolPose {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< position [m]
  /// Tool frame; only for kinds that depend on the tool's rotation.
  Eigen::Matrix3d R_WT = Eigen::Matrix3d::Identity();
};

/// Measured values, up to 6 rows [m]. Angles are multiplied by kTurnLever.
using MeasuredValue = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
using MeasuredRows = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 6, 3>;

/// Covariance of measured values [m^2], with as many rows and columns as there are values.
using MeasuredCovariance = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

/// Slopes of measured values by the tool's pose in the world.
struct MeasuredSlope {
  MeasuredRows by_place;
  MeasuredRows by_turn;  ///< per rad, about the world's axes; empty if rotation has no effect
};

/// Slopes of measured values by the numbers of an unknown place, which readings of one point share.
using PlaceColumns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 4>;

/// Lever [m] by which angles are multiplied, so that all rows are lengths when readings are weighed and reported.
inline constexpr double kTurnLever = 0.1;

/// Reference of a displacement: the tip at another reading, or the unloaded tip of the same reading.
struct Departure {
  const Measurement* reading = nullptr;
  bool is_unloaded = false;
};

/// Known facts of the place where a simulated reading is taken.
struct KnownPlaces {
  std::optional<Eigen::Vector3d> point_W;  ///< hole or mark [m]; nothing if unknown
  std::optional<Eigen::Vector3d> anchor_W, direction_W;
  Eigen::Vector3d up_W = Eigen::Vector3d::UnitZ();  ///< direction against gravity
};

/// Missing part of a reading, as a sentence, and advice.
struct ReadingLack {
  std::string what, advice;
};

/// Returns the lack of coordinates x, y, z, which most kinds need; nothing if they are there.
[[nodiscard]] inline std::optional<ReadingLack> lackOfPlace(const Measurement& reading, const std::string& kind) {
  if (reading.p_W) return std::nullopt;
  return ReadingLack{"the reading of kind " + kind + " has no x, y, z", "write its coordinates"};
}

/// Standard deviations [m] per coordinate of simulated readings: by a tracker (0.003 in), of a tip brought under a hole
/// (0.030 in), and of a tip centred by hand (0.005 in).
inline constexpr double kPositionSigma = 7.62e-5, kVisitSigma = 7.62e-4, kTouchSigma = 1.27e-4;

struct MeasurementKindRow {
  MeasurementKind kind;
  const char* name;  ///< name in the column `kind`
  int rows = 3;
  int turn_rows = 0;                                     ///< number of last rows that are angles
  int (*rows_of)(const Measurement& reading) = nullptr;  ///< number of rows, where it differs between readings
  std::span<const MeasuredColumn> columns = {};          ///< columns of Measurement::own, up to three

  bool has_coordinates = false;  ///< true: the first three rows are x, y, z in the world
  bool is_touch = false;         ///< true: the tip rests centred at `point`, whose place may be unknown
  bool is_place = false;         ///< true: p_W is the place of the tip
  /// True: a displacement from another reading, stated by p_W or else by its own numbers.
  bool is_from_reading = false;
  bool names_hole = false;      ///< true: `point` may name a hole, whose centre is p_W
  bool is_centring = false;     ///< true: the tool is brought under the point p_W, as well as the arm can
  bool has_anchor = false;      ///< true: p_W is a fixed place from which it is measured
  bool is_from_origin = false;  ///< true: p_W is the world's origin where it is not stated
  bool has_direction = false;   ///< true: direction_W is the direction along which it is measured
  bool is_to_gravity = false;   ///< true: direction_W points up, against gravity
  bool counts_steps = false;    ///< true: own is (steps that entered, lower bound, upper bound): see steps.hpp
  bool is_by_scale = true;  ///< true: its lengths are multiplied by the measuring system's scale, which may be in error
  bool sees_turn = false;   ///< true: it depends on the tool's rotation
  bool may_be_of_row = false;  ///< true: it may be fixed to a row of the arm (Measurement::row) and not to the tool

  MeasuredValue (*value)(const Measurement& reading, const ToolPose& tool);
  MeasuredSlope (*slope)(const Measurement& reading, const ToolPose& tool);
  /// Returns the measured values; zero for a touch of an unknown point, whose place is eliminated.
  MeasuredValue (*measured)(const Measurement& reading);
  /// Writes the reading of a tool at that pose, with lengths multiplied by `scale`, and that noise [m].
  void (*record)(const ToolPose& tool, double scale, const MeasuredValue& noise, Measurement& reading);

  /// Returns what a reading lacks besides its numbers, by its kind's name. Null for kinds that depend on the arm alone.
  std::optional<ReadingLack> (*lack)(const Measurement& reading, const std::string& kind) = lackOfPlace;
  double usual_sigma = kPositionSigma;

  /// Returns the columns that hold measured values; the other own numbers describe the target of the reading.
  ValueColumns (*value_columns)(std::span<const MeasuredColumn> own) = allOfOwn;
  /// Returns true if the numbers that a reading states are possible. Null if all numbers are.
  bool (*is_possible)(const Measurement& reading) = nullptr;

  /// Writes what a simulated reading states of its place. Null for kinds without a place.
  void (*state)(const KnownPlaces& places, Measurement& reading) = nullptr;

  /// Returns the reference of a displacement; null for other kinds.
  Departure (*departure)(const Measurement& reading) = nullptr;

  /// Returns the place of the tip in the world [m], for kinds that state it by other numbers than p_W; null for others.
  Eigen::Vector3d (*place)(const Measurement& reading) = nullptr;

  /// Functions of kinds that touch a surface of unknown place: the count of numbers that place it, the slopes of values
  /// by these, and the fit of the surface nearest to the points that touched it. The fit returns false and leaves the
  /// surface as it was if the points do not determine one.
  int (*place_numbers)(const Measurement& reading) = nullptr;
  PlaceColumns (*by_place_numbers)(const Measurement& reading, const ToolPose& tool) = nullptr;
  bool (*settle)(const Eigen::Matrix3Xd& points_W, const Measurement& reading, Surface& surface) = nullptr;
  /// Functions of the simulator for such kinds: a surface through a place, facing along a direction, and its point
  /// nearest to a place.
  Surface (*through)(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W) = nullptr;
  Eigen::Vector3d (*nearest)(const Surface& surface, const Eigen::Vector3d& p_W) = nullptr;
};

}  // namespace tubeplan::calibration
