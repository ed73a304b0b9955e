// What a kind of reading is: what it measures of the tip's pose, what its row must state, how it is simulated.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "calibration/measurement.hpp"
#include "calibration/measurements/value_columns.hpp"

namespace tubeplan::calibration {

/// Where the tool is, in the world; of a reading of a row's frame where that is. Of a displacement, `p_W` is that; its
/// turn is not measured.
struct ToolPose {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();       ///< m
  Eigen::Matrix3d R_WT = Eigen::Matrix3d::Identity();  ///< the tool frame; only for kinds that see the tool's turn
};

/// Measured values, up to 6 rows [m]: turns are counted as what they move at kTurnLever.
using MeasuredValue = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
using MeasuredRows = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 6, 3>;

/// Covariance of measured values [m^2], as many rows and columns as they have.
using MeasuredCovariance = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

/// How measured values change with the tool's pose in the world.
struct MeasuredSlope {
  MeasuredRows by_place;
  MeasuredRows by_turn;  ///< per rad, about the world's axes; empty where a turn changes nothing
};

/// How measured values change with the numbers of an unknown place, which readings of one point share.
using PlaceColumns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 4>;

/// Readings of angles are weighed and reported by what they move at this distance, so that all rows are lengths.
inline constexpr double kTurnLever = 0.1;  // m

/// What a displacement is taken from: where the tip is at a reading, or would be there with nothing on it.
struct Departure {
  const Measurement* reading = nullptr;
  bool is_unloaded = false;
};

/// What is known of where a simulated reading is taken.
struct KnownPlaces {
  std::optional<Eigen::Vector3d> point_W;  ///< m, the hole or mark; none where nobody knows it
  std::optional<Eigen::Vector3d> anchor_W, direction_W;
  Eigen::Vector3d up_W = Eigen::Vector3d::UnitZ();  ///< against gravity
};

/// What a reading lacks of what it is read of, or states beside it: found, expected, and what to do.
struct ReadingLack {
  std::string found, expected, advice = {};
};

/// The columns of most kinds: x, y, z.
[[nodiscard]] inline std::optional<ReadingLack> lackOfPlace(const Measurement& reading, const std::string& kind) {
  if (reading.p_W) return std::nullopt;
  return ReadingLack{"a reading of kind " + kind + " without x, y, z", "its coordinates"};
}

/// One standard deviation [m] per coordinate of a simulated reading: by a tracker (0.003 in), of a tip that is brought
/// under a hole (0.030 in), and of one that is centred by hand (0.005 in).
inline constexpr double kPositionSigma = 7.62e-5, kVisitSigma = 7.62e-4, kTouchSigma = 1.27e-4;

struct MeasurementKindRow {
  MeasurementKind kind;
  const char* name;  ///< in the column `kind`
  int rows = 3;
  int turn_rows = 0;                                     ///< the last of them, which are turns
  int (*rows_of)(const Measurement& reading) = nullptr;  ///< where they differ from reading to reading
  std::span<const MeasuredColumn> columns = {};          ///< of Measurement::own, up to three

  bool has_coordinates = false;  ///< the first rows, where there are three, are x, y, z in the world
  bool is_touch = false;         ///< the tip rests centred at `point`, whose place may be unknown
  bool is_place = false;         ///< p_W is where the tip is
  bool is_from_reading = false;  ///< a way from another reading; p_W or else its own numbers state it
  bool names_hole = false;       ///< `point` may name a hole, whose centre is p_W
  bool is_centring = false;      ///< the tool is brought under the point p_W, as well as the arm can
  bool has_anchor = false;       ///< p_W is a fixed place that it is measured from
  bool is_from_origin = false;   ///< which is the world's origin where it is not stated
  bool has_direction = false;    ///< and direction_W that along which
  bool is_to_gravity = false;    ///< direction_W points up, against gravity
  bool counts_steps = false;     ///< own is (steps that went in, beyond, within): see steps.hpp
  bool is_by_scale = true;       ///< its lengths are of the measuring system's scale, which may be off
  bool sees_turn = false;        ///< the tool's turn matters
  bool may_be_of_row =
      false;  ///< what it reads may be fixed to a row of the arm (Measurement::row) and not to the tool

  MeasuredValue (*value)(const Measurement& reading, const ToolPose& tool);
  MeasuredSlope (*slope)(const Measurement& reading, const ToolPose& tool);
  /// What was measured; of a touch of an unknown point nothing, whose elimination takes it off.
  MeasuredValue (*measured)(const Measurement& reading);
  /// Writes what is read of a tool that stands there, lengths by a scale that is off by `scale`, with that noise [m].
  void (*record)(const ToolPose& tool, double scale, const MeasuredValue& noise, Measurement& reading);

  /// What a reading lacks beside its numbers, by its kind's name; null of kinds that are of the arm alone.
  std::optional<ReadingLack> (*lack)(const Measurement& reading, const std::string& kind) = lackOfPlace;
  double usual_sigma = kPositionSigma;

  /// The columns that hold what was measured; own numbers that are none of them say what it is read of.
  ValueColumns (*value_columns)(std::span<const MeasuredColumn> own) = allOfOwn;
  /// Of kinds whose numbers cannot be any: whether those that a reading states may be right.
  bool (*is_possible)(const Measurement& reading) = nullptr;

  /// For the simulator, of kinds that are of a known place: writes what a reading states of it.
  void (*state)(const KnownPlaces& places, Measurement& reading) = nullptr;

  /// Returns what a displacement is taken from; null for kinds that are none.
  Departure (*departure)(const Measurement& reading) = nullptr;

  /// Of kinds that say where the tip is by other numbers than p_W: that place in the world [m].
  Eigen::Vector3d (*place)(const Measurement& reading) = nullptr;

  /// Of kinds that touch a surface of unknown place: how many numbers place it, how values change with these, and the
  /// surface nearest to points that touched it; false, and the surface as it was, where they do not determine one.
  int (*place_numbers)(const Measurement& reading) = nullptr;
  PlaceColumns (*by_place_numbers)(const Measurement& reading, const ToolPose& tool) = nullptr;
  bool (*settle)(const Eigen::Matrix3Xd& points_W, const Measurement& reading, Surface& surface) = nullptr;
  /// For the simulator: such a surface through a place, facing along a direction, and its point nearest to a place.
  Surface (*through)(const Eigen::Vector3d& p_W, const Eigen::Vector3d& direction_W) = nullptr;
  Eigen::Vector3d (*nearest)(const Surface& surface, const Eigen::Vector3d& p_W) = nullptr;
};

}  // namespace tubeplan::calibration
