// Design of a measurement campaign: what it reads, where and under which loads. It may be the bench, the bowl, touch
// points, or a design of the user.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibration/measurements/measurement_kind.hpp"

namespace tubeplan::calibration {

/// Place of the tip for a reading.
enum class CampaignPlace {
  kAnywhere,  ///< tip of a random posture
  kPlane,     ///< plane across gravity, at the height that half of the arm's postures exceed
  kHoles,     ///< holes of the sheet: in them for a touch, below them for other kinds
};

inline constexpr double kAngleSigma = 8.7e-5;  ///< sigma of an inclinometer or a six-degree probe [rad] (0.005 deg)

struct CampaignDesign {
  std::string name;
  MeasurementKind kind = MeasurementKind::kPosition;
  CampaignPlace place = CampaignPlace::kAnywhere;
  bool points_known = true;   ///< true: touched points have known places
  std::vector<double> loads;  ///< every posture is read under each of them in turn [N]
  double push = 0;            ///< largest additional force of random direction on the tip [N]
  /// Rows of the arm, each read at every posture, for kinds that may be fixed to a row; empty: the tool.
  std::vector<int> rows;
  int postures_per_point = 1;                  ///< number of postures that touch the same point, for kind touch
  int setups = 1;                              ///< number of base poses, one after the other
  std::optional<Eigen::Vector3d> anchor_W;     ///< anchor, for kinds that measure from one [m]
  std::optional<Eigen::Vector3d> direction_W;  ///< unit vector, for kinds that measure along a direction
  /// Box that the tip stays in [m]; if empty, in front of the base's own plane.
  std::optional<Eigen::AlignedBox3d> region_W;
  double sigma = kPositionSigma;  ///< standard deviation of a coordinate [m]; 0: exact readings
  /// Separate standard deviations of x, y and z, for kinds that measure them; overrides `sigma` [m].
  std::optional<Eigen::Vector3d> sigma_W;
  std::optional<Eigen::Vector3d> correlation_W;  ///< correlations beside it: of x with y, x with z, y with z
  double turn_sigma = 0;                         ///< standard deviation of an angle, for kinds that measure some [rad]
  double held_out = 0;                           ///< share of the points or postures that are held out from the fit
};

/// A named design. The table is open: a new one is a row in campaign_design.cpp.
struct NamedDesign {
  const char* name;
  const char* summary;
  CampaignDesign (*make)(bool has_sheet);
};
[[nodiscard]] std::span<const NamedDesign> campaignDesigns();

/// Returns the design of that name, or null if there is none.
[[nodiscard]] const NamedDesign* findCampaignDesign(std::string_view name);

/// Returns the loads of the thesis's trials, 0, 20 and 40 lbf [N].
[[nodiscard]] std::vector<double> usualLoads();

/// Returns the matrix that makes the noise of the coordinates [m] from three independent normal numbers of variance 1.
[[nodiscard]] Eigen::Matrix3d noiseFactor(const CampaignDesign& design);

/// Returns the number of readings at one posture: one of each row under each load.
[[nodiscard]] int readingsPerPosture(const CampaignDesign& design);

/// Returns the number of different points (or postures, if none is touched) for so many readings.
[[nodiscard]] int pointsOf(const CampaignDesign& design, int readings);

inline constexpr int kMostReadings = 100000;

/// Returns why that many readings cannot be taken by this design; empty if they can.
[[nodiscard]] std::string findDesignProblem(const CampaignDesign& design, int readings);

}  // namespace tubeplan::calibration
