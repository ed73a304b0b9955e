#include "calibration/simulation/campaign_design.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::calibration {

namespace {

constexpr double kPoundForce = 4.4482216152605;  // one pound-force [N]

CampaignDesign makeBench(bool) {
  CampaignDesign design;
  design.name = "bench";
  design.loads = usualLoads();
  return design;
}

CampaignDesign makeBowl(bool has_sheet) {
  CampaignDesign design;
  design.name = "bowl";
  design.kind = MeasurementKind::kTouch;
  design.place = has_sheet ? CampaignPlace::kHoles : CampaignPlace::kPlane;
  design.loads = usualLoads();
  design.sigma = kTouchSigma;
  return design;
}

CampaignDesign makeTouch(bool) {
  CampaignDesign design;
  design.name = "touch";
  design.kind = MeasurementKind::kTouch;
  design.points_known = false;
  design.loads = usualLoads();
  design.sigma = kTouchSigma;
  return design;
}

constexpr std::array<NamedDesign, 3> kDesigns{{
    {"bench", "the tip's position at random postures, each under every load", makeBench},
    {"bowl", "touches of known points (the sheet's holes, else points of a plane), each under every load", makeBowl},
    {"touch", "touches of unknown points, each under every load", makeTouch},
}};

int measurementsPerPoint(const CampaignDesign& design) {
  return measurementsPerPosture(design) * design.postures_per_point;
}

/// Returns the smallest number of measurements of one surface that gives information on the arm.
int leastOfSurface(const MeasurementKindRow& kind) { return kind.place_numbers({}) + 1; }

std::string findNoiseProblem(const CampaignDesign& design) {
  for (const double sigma : {design.sigma, design.turn_sigma})
    if (!(sigma >= 0) || !std::isfinite(sigma)) return "a sigma is negative or not finite";
  if (design.sigma_W && !(design.sigma_W->minCoeff() > 0 && design.sigma_W->allFinite()))
    return "a sigma of x, y or z is not above zero";
  if (design.sigma_W && !kindOf(design.kind).has_coordinates)
    return std::string("readings of kind ") + kindOf(design.kind).name +
           " do not measure x, y, z, so they have no sigmas of x, y and z";
  if (design.correlation_W && !design.sigma_W) return "the correlations need the sigmas of x, y and z";
  if (design.correlation_W && !isPossibleCorrelation(*design.correlation_W))
    return "the correlations are not positive definite";
  return {};
}

std::string findLoadProblem(const CampaignDesign& design) {
  const auto& loads = design.loads;
  if (loads.empty()) return "there are no loads";
  if (!std::all_of(loads.begin(), loads.end(), [](double load) { return std::isfinite(load) && load >= 0; }))
    return "a load is negative or not finite";
  if (kindOf(design.kind).departure && !kindOf(design.kind).is_from_measurement &&
      *std::min_element(loads.begin(), loads.end()) <= 0)
    return "a deflection is measured under a load of zero, where it is zero";
  const bool is_seen = !kindOf(design.kind).is_centring && design.place == CampaignPlace::kHoles;
  if (is_seen && *std::max_element(loads.begin(), loads.end()) > 0)
    return "holes are observed under a load, which must be zero";
  return {};
}

std::string findKindProblem(const CampaignDesign& design) {
  const MeasurementKindRow& kind = kindOf(design.kind);
  const bool is_touch = kind.is_touch, is_surface = kind.settle != nullptr;
  if (kind.has_anchor && !kind.is_from_origin && !design.anchor_W)
    return std::string("readings of kind ") + kind.name + " need an anchor";
  if (kind.has_direction && !design.direction_W)
    return std::string("readings of kind ") + kind.name + " need a direction";
  if (!is_touch && design.place == CampaignPlace::kPlane)
    return "the design is at points of a plane, but its readings do not touch them";
  const bool is_of_holes = kind.is_place || kind.names_hole;
  if (!is_of_holes && design.place == CampaignPlace::kHoles)
    return "the design is at holes, but its readings neither touch nor observe them";
  if (kind.names_hole && !is_touch && design.place != CampaignPlace::kHoles)
    return std::string("readings of kind ") + kind.name + " are made at holes of the sheet only";
  if (!design.rows.empty() && !kind.may_be_of_row)
    return std::string("readings of kind ") + kind.name + " cannot be of rows of the arm";
  if (is_surface && measurementsPerPoint(design) < leastOfSurface(kind))
    return std::string("a ") + kind.name + " of unknown place is touched fewer than " +
           std::to_string(leastOfSurface(kind)) + " times, which carries no information";
  if (!is_touch && !is_surface && design.postures_per_point != 1)
    return "a point that is not touched has several postures";
  if (is_touch && !design.points_known && measurementsPerPoint(design) < 2)
    return "unknown points are each touched only once, which carries no information";
  return {};
}

}  // namespace

std::span<const NamedDesign> campaignDesigns() { return kDesigns; }

const NamedDesign* findCampaignDesign(std::string_view name) {
  const auto found = std::find_if(kDesigns.begin(), kDesigns.end(), [&](const auto& row) { return row.name == name; });
  return found == kDesigns.end() ? nullptr : &*found;
}

std::vector<double> usualLoads() { return {0, 20 * kPoundForce, 40 * kPoundForce}; }

Eigen::Matrix3d noiseFactor(const CampaignDesign& design) {
  if (!design.sigma_W) return design.sigma * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d R = correlationMatrix(design.correlation_W.value_or(Eigen::Vector3d::Zero()));
  return design.sigma_W->asDiagonal() * Eigen::Matrix3d(R.llt().matrixL());
}

int measurementsPerPosture(const CampaignDesign& design) {
  return static_cast<int>(design.loads.size() * std::max<std::size_t>(1, design.rows.size()));
}

int pointsOf(const CampaignDesign& design, int measurements) {
  const int each = measurementsPerPoint(design), points = measurements / each, remaining = measurements % each;
  // A single touch of an unknown point gives no information, nor do too few touches of a surface. Such touches are
  // added to the preceding point.
  const MeasurementKindRow& kind = kindOf(design.kind);
  const int least = kind.settle ? leastOfSurface(kind) : design.points_known ? 1 : 2;
  const bool is_kept = remaining >= least || (remaining > 0 && points == 0);
  return points + (is_kept ? 1 : 0);
}

std::string findDesignProblem(const CampaignDesign& design, int measurements) {
  if (measurements < 1 || measurements > kMostMeasurements)
    return "the design has " + std::to_string(measurements) + " readings, not 1 to " +
           std::to_string(kMostMeasurements);
  if (auto problem = findNoiseProblem(design); !problem.empty()) return problem;
  if (!(design.held_out >= 0 && design.held_out < 1)) return "the held-out fraction is not from 0 to below 1";
  if (design.postures_per_point < 1 || design.setups < 1) return "a point has no posture, or there is no set-up";
  if (auto problem = findLoadProblem(design); !problem.empty()) return problem;
  if (auto problem = findKindProblem(design); !problem.empty()) return problem;
  const int points = pointsOf(design, measurements);
  if (points < design.setups)
    return "the design has " + std::to_string(design.setups) + " set-ups, but only " + std::to_string(points) +
           " points or postures";
  if (points < 2 && design.held_out > 0) return "a single point or posture cannot be held out in part";
  return {};
}

}  // namespace tubeplan::calibration
