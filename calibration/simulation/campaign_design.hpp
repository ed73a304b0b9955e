// Design of a measurement campaign: what is measured, where and under which loads. Predefined designs are `bench`,
// `bowl` and `touch`; users may state their own.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibration/measurements/measurement_kind.hpp"

namespace tubeplan::calibration {

/// Position of the tip for a measurement.
enum class CampaignPlace {
  kAnywhere,  ///< at the tip of any random posture
  kPlane,     ///< in the horizontal plane at the median height of the tip over random postures
  kHoles,     ///< at holes of the sheet: in them for a touch, below them for other kinds
};

/// Standard deviation of an angle from an inclinometer or a six-degree-of-freedom probe [rad] (0.005 deg).
inline constexpr double kAngleSigma = 8.7e-5;

struct CampaignDesign {
  std::string name;
  MeasurementKind kind = MeasurementKind::kPosition;
  CampaignPlace place = CampaignPlace::kAnywhere;
  bool points_known = true;   ///< true if the positions of touched points are known
  std::vector<double> loads;  ///< loads hung from the tip; every posture is measured under each of them [N]
  double push = 0;            ///< largest additional force of random direction on the tip [N]
  /// Rows of the arm whose frames are measured at every posture, for instruments that may be fixed to a row; empty
  /// means the tool.
  std::vector<int> rows;
  int postures_per_point = 1;                  ///< number of postures that touch the same point, for kind touch
  int setups = 1;                              ///< number of base poses, used one after another
  std::optional<Eigen::Vector3d> anchor_W;     ///< position of the anchor, for kinds that measure from an anchor [m]
  std::optional<Eigen::Vector3d> direction_W;  ///< unit vector, for kinds that measure along a direction
  /// Box within which the tip stays [m]. If empty, holes may be anywhere, and other targets must lie above the xy plane
  /// of the base frame.
  std::optional<Eigen::AlignedBox3d> region_W;
  double sigma = kPositionSigma;  ///< standard deviation of a coordinate [m]; 0 means noise-free measurements
  /// Separate standard deviations of x, y and z [m], for kinds that measure them; overrides `sigma`.
  std::optional<Eigen::Vector3d> sigma_W;
  /// Error correlations of x with y, x with z, y with z; only together with sigma_W.
  std::optional<Eigen::Vector3d> correlation_W;
  double turn_sigma = 0;  ///< standard deviation of an angle [rad], for kinds that measure angles
  double held_out = 0;    ///< fraction of the points or postures that are held out from the fit
};

/// A named design: one row of the table in campaign_design.cpp.
struct NamedDesign {
  const char* name;
  const char* summary;
  CampaignDesign (*make)(bool has_sheet);
};
[[nodiscard]] std::span<const NamedDesign> campaignDesigns();

/// Returns the design of that name; null if there is none.
[[nodiscard]] const NamedDesign* findCampaignDesign(std::string_view name);

/// Returns the loads used in the trials of Calkins 1994: 0, 20 and 40 lbf [N].
[[nodiscard]] std::vector<double> usualLoads();

/// Returns the matrix that maps three independent standard normal variables to the noise of the coordinates [m].
[[nodiscard]] Eigen::Matrix3d noiseFactor(const CampaignDesign& design);

/// Returns the number of measurements at one posture: one per row and load.
[[nodiscard]] int measurementsPerPosture(const CampaignDesign& design);

/// Returns the number of different points (or postures, if no point is touched) needed for `measurements` measurements.
[[nodiscard]] int pointsOf(const CampaignDesign& design, int measurements);

inline constexpr int kMostMeasurements = 100000;

/// Returns the reason why this design cannot give `measurements` measurements; empty if it can.
[[nodiscard]] std::string findDesignProblem(const CampaignDesign& design, int measurements);

}  // namespace tubeplan::calibration
