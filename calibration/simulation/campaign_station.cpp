#include "calibration/simulation/campaign_station.hpp"

#include "calibration/measurements/measurement_posture.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/measurements/tip_placement.hpp"
#include "deflection/effects/effect_context.hpp"

namespace tubeplan::calibration {

namespace {

using Eigen::Vector3d, Eigen::VectorXd;

constexpr deflection::FlexibleKinematicsOptions kShapeExactly{1e-13, 100};

std::optional<ToolPose> toolIn(const deflection::Arm& arm, const CampaignSite& site, const Measurement& measurement) {
  return toolAt(arm, site.X_WB, measurement, kShapeExactly);
}

/// Returns the places that the design states for its measurements: the point, unless its position is unknown, the
/// anchor and the direction.
KnownPlaces knownPlaces(const deflection::Arm& arm, const CampaignDesign& design,
                        const std::optional<Vector3d>& point_W) {
  return {design.points_known ? point_W : std::nullopt, design.anchor_W, design.direction_W, -arm.gravity_W};
}

/// Returns the noise of each row [m]; angles are multiplied by kTurnLever. Touches ignore this noise, because the tip
/// position of a touch already contains noise.
MeasuredValue noiseOf(const MeasurementKindRow& kind, const MeasurementConditions& conditions) {
  MeasuredValue noise = MeasuredValue::Zero(kind.rows);
  const int turns = kind.turn_rows;
  noise.head(kind.rows - turns) = conditions.coordinate_noise.head(kind.rows - turns);
  noise.tail(turns) = kTurnLever * conditions.turn_noise.head(turns);
  return noise;
}

/// Records the values of `measurement` for a tool at the pose `tool`.
PostureRefusal measure(const deflection::Arm& arm, const CampaignSite& site, const MeasurementConditions& conditions,
                       ToolPose tool, const std::optional<Surface>& surface, Measurement& measurement) {
  const MeasurementKindRow& kind = kindOf(measurement);
  if (const auto from = departureOf(measurement); from && !kind.is_from_measurement) {
    const auto departure_tool = toolIn(arm, site, measurementAt(*from));
    if (!departure_tool) return PostureRefusal::kNotConverged;
    tool.p_W -= departure_tool->p_W;
  }
  if (measurement.row) {
    const auto frame = frameAt(arm, site.X_WB, measurement, kShapeExactly);
    if (!frame) return PostureRefusal::kNotConverged;
    tool = *frame;
  }
  measurement.surface = surface;
  kind.record(tool, deflection::measurementScale(arm), noiseOf(kind, conditions), measurement);
  measurement.surface.reset();  // the position of the surface is unknown to the measurement
  return isPossible(measurement) ? PostureRefusal::kNone : PostureRefusal::kOutsideRegion;
}

Measurement measurementUnder(const CampaignDesign& design, const CampaignSite& site, std::size_t index,
                             const MeasurementConditions& conditions) {
  Measurement measurement;
  measurement.kind = design.kind;
  measurement.setup = site.name;
  const std::size_t rows = std::max<std::size_t>(1, design.rows.size());
  if (!design.rows.empty()) measurement.row = design.rows[index % rows];
  measurement.load = design.loads[index / rows % design.loads.size()];
  measurement.side_q = conditions.side_q;
  if (design.push > 0) measurement.wrench = TipWrench{conditions.push};
  const MeasurementKindRow& kind = kindOf(measurement);
  if (design.sigma > 0 && kind.rows > kind.turn_rows && !kind.counts_steps) measurement.sigma = design.sigma;
  if (design.sigma_W) {
    measurement.sigma = meanSigma(*design.sigma_W);
    measurement.sigma_W = design.sigma_W;
    measurement.correlation_W = design.correlation_W;
  }
  if (design.turn_sigma > 0 && kind.turn_rows > 0) measurement.turn_sigma = design.turn_sigma;
  measurement.conditions = conditions.stated;
  return measurement;
}

}  // namespace

CampaignStation::CampaignStation(const deflection::Arm& arm, const CampaignDesign& design,
                                 const CampaignOptions& options)
    : arm_(arm),
      design_(design),
      options_(options),
      source_(arm, options.seed),
      reach_(deflection::reachOf(arm)),
      fresh_holes_(options.holes),
      last_q_(source_.randomPosture()) {}

StationMeasurements CampaignStation::read(const CampaignSite& site, int number,
                                          const std::vector<MeasurementConditions>& conditions) {
  StationMeasurements taken;
  taken.name = (kindOf(design_.kind).is_touch ? "H" : "P") + std::to_string(number);
  VectorXd q_before = last_q_, q = last_q_;
  for (std::size_t k = 0; k < conditions.size(); ++k) {
    if (k % static_cast<std::size_t>(measurementsPerPosture(design_)) == 0) taken.refusal = begin(site, taken, q);
    if (taken.refusal != PostureRefusal::kNone) return taken;
    Measurement measurement = measurementUnder(design_, site, k, conditions[k]);
    measurement.point = taken.name;
    measurement.q = q;
    Vector3d tip_W;
    taken.refusal = take(site, conditions[k], taken, q_before, measurement, tip_W);
    if (taken.refusal != PostureRefusal::kNone) return taken;
    q_before = q = measurement.q;
    measurement.q += conditions[k].encoder_noise;
    taken.tips_W.push_back(tip_W);
    taken.measurements.push_back(std::move(measurement));
  }
  last_q_ = q_before;
  std::erase_if(fresh_holes_, [&](const auto& hole) { return hole.name == taken.name; });
  if (fresh_holes_.empty()) renewHoles();
  return taken;
}

TipTrial CampaignStation::tryRandomPosture(const CampaignSite& site) {
  Measurement measurement;
  measurement.q = source_.randomPosture();
  measurement.load = design_.loads.front();
  return check(site, measurement);
}

PostureRefusal CampaignStation::begin(const CampaignSite& site, StationMeasurements& taken, VectorXd& q) {
  if (design_.place == CampaignPlace::kHoles) return beginAtHole(site, taken, q);
  if (kindOf(design_.kind).through) return beginAtSurface(site, taken, q);
  q = source_.randomPosture();
  if (!kindOf(design_.kind).is_touch || taken.p_W) return PostureRefusal::kNone;
  Measurement first;
  first.q = q;
  first.load = design_.loads.front();
  const auto tool = toolIn(arm_, site, first);
  if (!tool) return PostureRefusal::kNotConverged;
  taken.p_W = tool->p_W;
  const Vector3d up = -arm_.gravity_W;
  if (design_.place == CampaignPlace::kPlane) *taken.p_W += (plane_height_ - up.dot(*taken.p_W)) * up;
  return PostureRefusal::kNone;
}

/// Draws a start posture at a surface. For the first posture, the surface is placed at its tip; the tips of further
/// postures are near the surface.
PostureRefusal CampaignStation::beginAtSurface(const CampaignSite& site, StationMeasurements& taken, VectorXd& q) {
  constexpr int kMostPostures = 200;
  constexpr double kNear = 0.15;  // largest distance from the surface, as a fraction of the reach
  const MeasurementKindRow& kind = kindOf(design_.kind);
  for (int draws = 0; draws < kMostPostures; ++draws) {
    Measurement first;
    first.q = q = source_.randomPosture();
    first.load = design_.loads.front();
    const auto tool = toolIn(arm_, site, first);
    if (!tool) continue;
    if (!taken.surface) {
      taken.p_W = tool->p_W;
      taken.surface = kind.through(tool->p_W, source_.direction());
      return PostureRefusal::kNone;
    }
    if ((kind.nearest(*taken.surface, tool->p_W) - tool->p_W).norm() < kNear * reach_) return PostureRefusal::kNone;
  }
  return PostureRefusal::kOutOfReach;
}

PostureRefusal CampaignStation::beginAtHole(const CampaignSite& site, StationMeasurements& taken, VectorXd& q) {
  const double below = kindOf(design_.kind).is_centring ? 0 : options_.standoff;
  std::vector<CampaignPoint> again;
  if (taken.p_W) again.push_back({taken.name, *taken.p_W});
  const auto start =
      source_.atHole(site, taken.p_W ? again : fresh_holes_, options_.hole_axis_W, below, design_.loads.front());
  q = start.q;
  taken.name = start.hole.name;
  taken.p_W = start.hole.p_W;
  return start.refusal;
}

PostureRefusal CampaignStation::take(const CampaignSite& site, const MeasurementConditions& conditions,
                                     const StationMeasurements& taken, const VectorXd& q_before,
                                     Measurement& measurement, Vector3d& tip_W) const {
  measurement.approach_directions = conditions.approach_directions(q_before, measurement.q);
  if (const auto goal_W = goalOf(site, taken, measurement, conditions.coordinate_noise)) {
    const auto refusal = bringTip(site, conditions, *goal_W, q_before, measurement);
    if (refusal != PostureRefusal::kNone) return refusal;
  }
  const TipTrial trial = check(site, measurement);
  if (trial.refusal != PostureRefusal::kNone) return trial.refusal;
  if (const auto state = kindOf(measurement).state) state(knownPlaces(arm_, design_, taken.p_W), measurement);
  tip_W = trial.tool.p_W;
  return measure(arm_, site, conditions, trial.tool, taken.surface, measurement);
}

/// Brings the tip to a goal. Effects may depend on the joints' directions of arrival, which depend on the joint values
/// at the goal. Both are therefore found by iteration.
PostureRefusal CampaignStation::bringTip(const CampaignSite& site, const MeasurementConditions& conditions,
                                         const Vector3d& goal_W, const VectorXd& q_before,
                                         Measurement& measurement) const {
  constexpr int kMostPasses = 4;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const auto placed = placeTip(arm_, postureOf(measurement, arm_, site.X_WB), site.X_WB.inverse() * goal_W);
    if (placed.status == TipPlacementStatus::kStretched) return PostureRefusal::kStretched;
    if (placed.status != TipPlacementStatus::kPlaced) return PostureRefusal::kOutOfReach;
    measurement.q = placed.q;
    const auto approach_directions = conditions.approach_directions(q_before, measurement.q);
    if (approach_directions == measurement.approach_directions) return PostureRefusal::kNone;
    measurement.approach_directions = approach_directions;
  }
  return PostureRefusal::kNotConverged;
}

std::optional<Vector3d> CampaignStation::goalOf(const CampaignSite& site, const StationMeasurements& taken,
                                                const Measurement& measurement, const Vector3d& noise) const {
  if (!taken.p_W) return std::nullopt;
  if (taken.surface) {
    const auto tool = toolIn(arm_, site, measurement);
    const Vector3d from = tool ? tool->p_W : *taken.p_W;
    return kindOf(design_.kind).nearest(*taken.surface, from) + noise;
  }
  if (kindOf(design_.kind).is_centring) return *taken.p_W + noise;
  return *taken.p_W - options_.standoff * options_.hole_axis_W;
}

TipTrial CampaignStation::check(const CampaignSite& site, const Measurement& measurement) const {
  TipTrial trial;
  const auto tool = toolIn(arm_, site, measurement);
  if (!source_.isWithinLimits(measurement.q))
    trial.refusal = PostureRefusal::kPastLimit;
  else if (!tool)
    trial.refusal = PostureRefusal::kNotConverged;
  else if (!isInRegion(site, tool->p_W))
    trial.refusal = PostureRefusal::kOutsideRegion;
  else if (options_.is_clear && !options_.is_clear(site.setup, measurement.load, measurement.q))
    trial.refusal = PostureRefusal::kNotClear;
  if (tool) trial.tool = *tool;
  return trial;
}

bool CampaignStation::isInRegion(const CampaignSite& site, const Vector3d& tip_W) const {
  if (design_.region_W) return design_.region_W->contains(tip_W);
  if (design_.place == CampaignPlace::kHoles) return true;
  const Vector3d tip_B = site.X_WB.inverse() * tip_W;
  return tip_B.z() > 0 && tip_B.norm() >= options_.least_reach * reach_;
}

}  // namespace tubeplan::calibration
