// What a measurement campaign reads, where and under which loads: the bench, the bowl, touch points, or a design of
// one's own.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "calibration/measurements/measurement_kind.hpp"

namespace tubeplan::calibration {

/// Where the tip is for a reading.
enum class CampaignPlace {
  kAnywhere,  ///< wherever a random posture puts it
  kPlane,     ///< in one plane across gravity, at the height that half of the arm's postures exceed
  kHoles,     ///< at holes of the sheet: in them for a touch, below them for what looks at them
};

inline constexpr double kAngleSigma = 8.7e-5;  ///< rad, of an inclinometer or a six-degree probe (0.005 deg)

struct CampaignDesign {
  std::string name;
  MeasurementKind kind = MeasurementKind::kPosition;
  CampaignPlace place = CampaignPlace::kAnywhere;
  bool points_known = true;    ///< of kind touch
  std::vector<double> loads;   ///< N; every posture is read under each of them in turn
  double push = 0;             ///< N; a force of any direction up to that size on the tip as well
  std::vector<int> rows;       ///< of the arm, each read at every posture, of kinds that may; else the tool
  int postures_per_point = 1;  ///< of kind touch: how many postures touch the same point
  int setups = 1;              ///< base poses, one after the other
  std::optional<Eigen::Vector3d> anchor_W;      ///< m, of kinds that measure from an anchor
  std::optional<Eigen::Vector3d> direction_W;   ///< a unit vector, of kinds that measure along one
  std::optional<Eigen::AlignedBox3d> region_W;  ///< m, where the tip stays; else in front of the base's own plane
  double sigma = kPositionSigma;                ///< m, one standard deviation of a coordinate; 0: exact readings
  std::optional<Eigen::Vector3d> sigma_W;  ///< m, of x, y and z apart, of kinds that measure them; goes before `sigma`
  std::optional<Eigen::Vector3d> correlation_W;  ///< beside it: of x with y, x with z, y with z
  double turn_sigma = 0;                         ///< rad, the same of an angle, of kinds that measure some
  double held_out = 0;                           ///< share of the points or postures that are kept from the fit
};

/// A design that has a name. An open table: a new one is one row in campaign_design.cpp.
struct NamedDesign {
  const char* name;
  const char* summary;
  CampaignDesign (*make)(bool has_sheet);
};
[[nodiscard]] std::span<const NamedDesign> campaignDesigns();

/// Null where there is none.
[[nodiscard]] const NamedDesign* findCampaignDesign(std::string_view name);

/// The loads of the thesis's trials, 0, 20 and 40 lbf [N].
[[nodiscard]] std::vector<double> usualLoads();

/// What makes the noise of the coordinates [m] of three independent normal numbers of variance 1.
[[nodiscard]] Eigen::Matrix3d noiseFactor(const CampaignDesign& design);

/// How many readings one posture takes: one of each row under each load.
[[nodiscard]] int readingsPerPosture(const CampaignDesign& design);

/// How many different points (or postures, where none is touched) so many readings take.
[[nodiscard]] int pointsOf(const CampaignDesign& design, int readings);

inline constexpr int kMostReadings = 100000;

/// Why that many readings cannot be taken by this design, or empty.
[[nodiscard]] std::string findDesignProblem(const CampaignDesign& design, int readings);

}  // namespace tubeplan::calibration
