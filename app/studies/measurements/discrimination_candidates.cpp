#include "app/studies/measurements/discrimination_candidates.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "app/studies/measurements/measured_room.hpp"
#include "app/studies/measurements/measurement_candidates.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/surfaces.hpp"
#include "calibration/measurements/tip_placement.hpp"
#include "calibration/statistics.hpp"
#include "deflection/inverse/inverse_solver.hpp"
#include "planner/collision/arm_clearance.hpp"

namespace tubeplan::app {

namespace {

using calibration::Measurement, calibration::MeasurementKind, calibration::ProposedMeasurement,
    calibration::MeasurementCandidate;
using Eigen::VectorXd;

constexpr double kReached = 1e-7;  // largest position error of a posture that reaches its point [m]
constexpr int kMostTouches = 4;    // largest number of touch postures per point

/// Common properties of the measurements so far, which the proposed measurements inherit.
struct Custom {
  MeasurementKind kind = MeasurementKind::kPosition;
  bool has_known_points = false;  ///< true if measurements are taken at holes or marks
  std::vector<double> loads;
  double sigma = 0, turn_sigma = 0;
  deflection::ConditionValues conditions;
  std::set<std::optional<int>> rows;  ///< rows of the arm whose frames were measured; std::nullopt for the tool
  bool has_approach_directions = false;
  std::optional<Eigen::Vector3d> anchor, direction;
  VectorXd side_q;
  std::shared_ptr<const Measurement> reference;
  bool is_length_alone = false;
};

MeasurementKind usualKind(const std::vector<Measurement>& measurements) {
  std::map<MeasurementKind, int> count;
  for (const auto& measurement : measurements) ++count[measurement.kind];
  return std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

/// Returns at most `most` values spread over the sorted list, including the smallest and the largest.
std::vector<double> thinnedOut(const std::set<double>& all, int most) {
  const std::vector<double> sorted(all.begin(), all.end());
  if (static_cast<int>(sorted.size()) <= most) return sorted;
  std::vector<double> some;
  for (int k = 0; k < most; ++k)
    some.push_back(sorted[static_cast<std::size_t>(k) * (sorted.size() - 1) / static_cast<std::size_t>(most - 1)]);
  return some;
}

/// Returns the median of each condition over the measurements of kind `of`. For the time, returns the latest value,
/// because no new measurement can be earlier.
deflection::ConditionValues usualConditionsOf(const std::vector<Measurement>& measurements, MeasurementKind of) {
  deflection::ConditionValues usual;
  for (const auto& kind : deflection::kConditionKinds) {
    std::vector<double> stated;
    for (const auto& measurement : measurements)
      if (measurement.kind == of && measurement.conditions.states(kind.condition))
        stated.push_back(measurement.conditions[kind.condition]);
    if (stated.empty()) continue;
    const bool is_clock = kind.condition == deflection::Condition::kTime;
    usual[kind.condition] = is_clock ? std::ranges::max(stated) : calibration::median(stated);
  }
  return usual;
}

Custom customOf(const std::vector<Measurement>& measurements, int most_loads) {
  Custom custom;
  custom.kind = usualKind(measurements);
  std::set<double> loads;
  std::vector<double> sigmas;
  for (const auto& measurement : measurements) {
    if (measurement.kind != custom.kind) continue;
    loads.insert(measurement.load);
    sigmas.push_back(measurement.sigma);
    custom.turn_sigma = measurement.turn_sigma;
    custom.rows.insert(measurement.row);
    if (measurement.p_W) custom.anchor = measurement.p_W;
    if (measurement.direction_W) custom.direction = measurement.direction_W;
    custom.side_q = measurement.side_q;
    custom.reference = measurement.reference;
    custom.is_length_alone = measurement.reference && !measurement.p_W;
    custom.has_approach_directions |= std::any_of(measurement.approach_directions.begin(),
                                                  measurement.approach_directions.end(), [](int s) { return s != 0; });
  }
  custom.has_known_points = kindOf(custom.kind).names_hole && custom.anchor;
  custom.loads = thinnedOut(loads, most_loads);
  custom.sigma = calibration::median(sigmas);
  custom.conditions = usualConditionsOf(measurements, custom.kind);
  return custom;
}

/// Returns the points measured so far and, for a cell with a sheet, holes spread over the sheet.
std::vector<Measurement> pointsToReadAt(const CellModel& cell, const std::vector<Measurement>& measurements,
                                        MeasurementKind kind, std::size_t most) {
  std::vector<Measurement> points;
  std::set<std::string> seen;
  for (const auto& measurement : measurements)
    if (measurement.kind == kind && measurement.p_W && seen.insert(measurement.point).second)
      points.push_back(measurement);
  if (cell.sheet) {
    const auto& tubes = cell.sheet->tubes;
    const std::size_t step = std::max<std::size_t>(1, tubes.size() / most);
    for (std::size_t t = 0; t < tubes.size() && !points.empty(); t += step) {
      Measurement hole = points.front();
      hole.point = tubesheets::tubeName(tubes[t].row, tubes[t].column);
      hole.p_W = planner::holeCentre(tubes[t]);
      if (seen.insert(hole.point).second) points.push_back(hole);
    }
  }
  return points;
}

/// Returns the vector from the measurement's known point to the tip, in the base frame [m]; zero for kinds of
/// measurement that centre the tip on the point.
Eigen::Vector3d standoffOf(const planner::Workcell& work, const Measurement& measurement) {
  if (kindOf(measurement).is_centring) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d gravity_B = deflection::gravityInBase(work.arm, work.X_WB);
  const auto shape = deflection::solveFlexibleKinematics(work.arm, {measurement.q, measurement.load, gravity_B});
  return shape.X_BD.p - work.X_WB.inverse() * *measurement.p_W;
}

/// Adds one candidate for each posture branch that places the tip at the point plus `standoff_B` [m, base frame], under
/// the load of `work`.
void addAtPoint(const planner::Workcell& work, const planner::ArmClearance& clear, deflection::InverseSolver& solver,
                const Measurement& point, const Eigen::Vector3d& standoff_B,
                std::vector<MeasurementCandidate>& candidates) {
  const Eigen::Vector3d gravity_B = deflection::gravityInBase(work.arm, work.X_WB);
  const auto shape = deflection::solveFlexibleKinematics(work.arm, {point.q, work.load, gravity_B});
  if (shape.status != deflection::KinematicsStatus::kConverged) return;
  const deflection::ToolGoal goal{work.X_WB.inverse() * *point.p_W + standoff_B, shape.X_BD.R * work.arm.tool_axis_L};
  for (const auto& branch : solver.solve(goal).branches) {
    if (branch.status != deflection::BranchStatus::kConverged || branch.position_error > kReached) continue;
    if (!work.scene.bodies.empty() && !(clear.at(branch.q, planner::ContactRule::kApproach).margin >= 0)) continue;
    ProposedMeasurement measurement;
    measurement.point = point.point;
    measurement.known_W = point.p_W;
    measurement.q = branch.q;
    measurement.load = work.load;
    candidates.push_back({{measurement}});
  }
}

/// Returns the first measurement on each touched surface, with the surface as fitted together with the arm.
std::vector<Measurement> surfacesTouched(const calibration::PlacedArm& fitted, std::vector<Measurement> measurements,
                                         MeasurementKind kind) {
  std::vector<Measurement> touched;
  if (!calibration::settleSurfaces(fitted, measurements)) return touched;
  std::set<std::string> seen;
  for (const auto& measurement : measurements)
    if (measurement.kind == kind && measurement.surface && seen.insert(measurement.point).second)
      touched.push_back(measurement);
  return touched;
}

bool isWithinLimits(const deflection::Arm& arm, const VectorXd& q) {
  for (Eigen::Index k = 0; k < q.size(); ++k)
    if (!(q[k] >= arm.joint(k).lower && q[k] <= arm.joint(k).upper)) return false;
  return true;
}

/// Returns a posture near `q` with the tip on the surface of measurement `of`; std::nullopt if the arm does not reach
/// the surface.
std::optional<VectorXd> broughtTo(const planner::Workcell& work, const Measurement& of, const VectorXd& q) {
  const deflection::Posture start{q, work.load, deflection::gravityInBase(work.arm, work.X_WB)};
  const auto shape = deflection::solveFlexibleKinematics(work.arm, start);
  if (shape.status != deflection::KinematicsStatus::kConverged) return std::nullopt;
  const Eigen::Vector3d goal_W = kindOf(of).nearest(*of.surface, work.X_WB * shape.X_BD.p);
  const auto placed = calibration::placeTip(work.arm, start, work.X_WB.inverse() * goal_W);
  const bool is_there = placed.status == calibration::TipPlacementStatus::kPlaced;
  return is_there && isWithinLimits(work.arm, placed.q) ? std::optional(placed.q) : std::nullopt;
}

/// Returns one touch for each posture, surface and load; touches that the arm cannot reach, or only with a collision,
/// are excluded.
std::vector<MeasurementCandidate> surfaceTouches(planner::Workcell work, const std::vector<VectorXd>& postures,
                                                 const std::vector<double>& loads,
                                                 const std::vector<Measurement>& surfaces) {
  std::vector<MeasurementCandidate> candidates;
  for (const double load : loads) {
    work.load = load;
    const planner::ArmClearance clear(work);
    for (std::size_t k = 0; k < postures.size() * surfaces.size(); ++k) {
      const Measurement& of = surfaces[k % surfaces.size()];
      const auto q = broughtTo(work, of, postures[k / surfaces.size()]);
      if (!q) continue;
      if (!work.scene.bodies.empty() && !(clear.at(*q, planner::ContactRule::kApproach).margin >= 0)) continue;
      ProposedMeasurement measurement;
      measurement.point = of.point;
      measurement.surface = of.surface;
      measurement.given = of.kind_values[0];
      measurement.q = *q;
      measurement.load = load;
      candidates.push_back({{measurement}});
    }
  }
  return candidates;
}

std::vector<MeasurementCandidate> bareCandidates(const CellModel& cell, const calibration::PlacedArm& fitted,
                                                 const std::vector<Measurement>& measurements, const Custom& custom,
                                                 const DiscriminationCandidateOptions& options) {
  planner::Workcell work = armAndScene(cell);
  const Eigen::Vector3d axis_L = work.arm.tool_axis_L;
  work.arm = fitted.arm;
  work.arm.tool_axis_L = axis_L;
  work.X_WB = fitted.base_poses.back().X_WB;
  std::vector<MeasurementCandidate> candidates;
  if (custom.has_known_points) {
    const auto points = pointsToReadAt(cell, measurements, custom.kind, static_cast<std::size_t>(options.postures));
    const Eigen::Vector3d standoff_B = standoffOf(work, points.front());
    const std::size_t step = std::max<std::size_t>(1, points.size() / static_cast<std::size_t>(options.postures));
    deflection::InverseKinematicsOptions inverse;
    inverse.most_branches = kMostTouches;
    for (const double load : custom.loads) {
      work.load = load;
      const planner::ArmClearance clear(work);
      deflection::InverseSolver solver(work.arm, load, deflection::gravityInBase(work.arm, work.X_WB), inverse);
      for (std::size_t k = 0; k < points.size(); k += step)
        addAtPoint(work, clear, solver, points[k], standoff_B, candidates);
    }
    return candidates;
  }
  PostureQuestion has_room;
  if (work.scene.bodies.empty())
    has_room = [room = MeasuredRoom(fitted, measurements)](const VectorXd& q, double load) {
      return room.contains(q, load);
    };
  auto postures = clearPostures(work, custom.loads, options.postures / 2, options.seed, has_room);
  const auto outer = clearPostures(work, custom.loads, options.postures - static_cast<int>(postures.size()),
                                   options.seed, has_room, PostureChoice::kNearLimits);
  postures.insert(postures.end(), outer.begin(), outer.end());
  if (kindOf(custom.kind).is_touch)
    return custom.loads.size() < 2 ? candidates : pointTouches(work, postures, custom.loads, custom.sigma);
  if (kindOf(custom.kind).settle)
    return surfaceTouches(work, postures, custom.loads, surfacesTouched(fitted, measurements, custom.kind));
  return positionMeasurements(postures, custom.loads, custom.sigma);
}

/// Sets the properties that all proposed measurements share. For measurements of angles, `number` selects the row of
/// the arm, so that the measurements alternate between the rows.
void makeAsUsual(const Custom& custom, const std::string& setup, std::size_t number, ProposedMeasurement& measurement) {
  const auto& kind = kindOf(custom.kind);
  measurement.kind = custom.kind;
  measurement.setup = setup;
  measurement.side_q = custom.side_q;
  measurement.sigma = custom.sigma;
  measurement.conditions = custom.conditions;
  if (kind.has_anchor) measurement.known_W = custom.anchor;
  measurement.direction_W = custom.direction;
  measurement.reference = custom.reference;
  measurement.is_length_alone = custom.is_length_alone;
  if (kind.turn_rows == 0) return;
  measurement.turn_sigma = custom.turn_sigma;
  measurement.row = *std::next(custom.rows.begin(), static_cast<std::ptrdiff_t>(number % custom.rows.size()));
}

}  // namespace

std::vector<MeasurementCandidate> discriminationCandidates(const CellModel& cell, const calibration::PlacedArm& fitted,
                                                           const std::vector<Measurement>& measurements,
                                                           const DiscriminationCandidateOptions& options) {
  if (measurements.empty()) return {};
  const Custom custom = customOf(measurements, options.most_loads);
  auto candidates = bareCandidates(cell, fitted, measurements, custom, options);
  boost::random::mt19937_64 random(options.seed);
  std::size_t number = 0;
  for (auto& candidate : candidates)
    for (auto& measurement : candidate.measurements) {
      makeAsUsual(custom, fitted.base_poses.back().setup, number++, measurement);
      for (Eigen::Index j = 0; custom.has_approach_directions && j < measurement.q.size(); ++j)
        measurement.approach_directions.push_back(random() >> 63 ? 1 : -1);
    }
  return candidates;
}

}  // namespace tubeplan::app
