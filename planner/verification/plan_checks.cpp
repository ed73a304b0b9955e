#include "planner/verification/plan_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "deflection/prepared_arm.hpp"
#include "planner/verification/path_clearance_check.hpp"
#include "planner/verification/segmented_statics.hpp"

namespace tubeplan::planner {

namespace {

using Eigen::Vector3d, Eigen::VectorXd;
constexpr std::size_t kMostFindings = 100;
constexpr double kLimitShare = 1 + 1e-9;
constexpr double kTimeTolerance = 1e-6;  // tolerance of a single time [s]
constexpr double kSumTolerance = 1e-3;   // tolerance of a sum of many times [s]

class Checker {
 public:
  Checker(const Workcell& cell, const StatedPlan& plan, const PlanCheckOptions& options, const PlanHooks& hooks)
      : cell_(cell),
        plan_(plan),
        options_(options),
        hooks_(hooks),
        gravity_B_(deflection::gravityInBase(cell.arm, cell.X_WB)),
        arm_(cell.arm) {}

  PlanCheck run() {
    if (plan_.tubes.empty()) find("the plan visits no tube: there is nothing to prove");
    checkTubes();
    if (shapesFit()) {
      checkOrder();
      checkJoints();
      checkSpeeds();
      checkApproaches();
      checkAxes();
      checkTimes();
      checkPathClearance(
          cell_, plan_, options_, hooks_, [this](std::string what) { find(std::move(what)); }, result_);
    }
    result_.status = result_.findings.empty() ? PlanCheckStatus::kProved : PlanCheckStatus::kRefuted;
    result_.tubes = static_cast<int>(plan_.tubes.size());
    result_.rows = static_cast<int>(plan_.path.size());
    return result_;
  }

 private:
  void find(std::string what) {
    if (result_.findings.size() < kMostFindings) result_.findings.push_back(std::move(what));
  }

  /// Returns the tip position in the world [m]; NaN if the shape does not converge.
  Vector3d tipAt(const VectorXd& q) {
    if (arm_.solve({q, cell_.load, gravity_B_}, {1e-13, 100}) != deflection::KinematicsStatus::kConverged)
      return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    return cell_.X_WB * arm_.X_BD().p;
  }

  bool shapesFit() {
    const auto joints = cell_.arm.jointCount();
    const auto fits = [&](const VectorXd& q) { return q.size() == joints && q.allFinite(); };
    const bool fit =
        std::all_of(plan_.path.begin(), plan_.path.end(), [&](const PathRow& row) { return fits(row.q); }) &&
        std::all_of(plan_.tubes.begin(), plan_.tubes.end(), [&](const StatedTube& tube) { return fits(tube.q); });
    if (!fit) find("joint values are missing or not finite");
    return fit;
  }

  void checkTubes() {
    std::set<std::pair<int, int>> seen;
    for (const auto& tube : plan_.tubes) {
      const std::string name = tubesheets::tubeName(tube.row, tube.column);
      const auto* hole = cell_.sheet.find(tube.row, tube.column);
      if (!hole) {
        find(name + " is not on this sheet");
        continue;
      }
      if (!seen.insert({tube.row, tube.column}).second) find(name + " is visited twice");
      if (!((tube.hole_W - holeCentre(*hole)).norm() <= options_.stated_tolerance))
        find(name + ": the stated hole is not at the sheet's position");
      if (tube.q.size() != cell_.arm.jointCount()) continue;
      const Vector3d tip = tipAt(tube.q);
      const double off = (tip - visitPlace(cell_, *hole)).norm();
      result_.worst_centring = std::max(result_.worst_centring, off);
      if (!(off <= options_.centring_tolerance))
        find(fmt::format("{}: the deflected tip is {:.3g} m off {}", name, off,
                         cell_.insertion > 0 ? "its position in the tube" : "the hole's centre"));
      checkTilt(name, tube.tilt);
      checkStatics(name, tube.q, tip);
      if (!((tip - tube.predicted_tip_W).norm() <= options_.stated_tolerance))
        find(name + ": the stated tip is not the model's");
      // A centring error is lateral only, because the lateral offset decides whether a step of the tool enters.
      const double sideways = (tip - tube.hole_W).head<2>().norm();
      if (tube.centring_error && !(std::abs(*tube.centring_error - sideways) <= options_.stated_tolerance))
        find(name + ": the stated centring error is not the model's");
    }
    for (const auto& [row, column] : plan_.unreachable) {
      if (!cell_.sheet.find(row, column))
        find(tubesheets::tubeName(row, column) + ", stated as unreachable, is not on this sheet");
      if (seen.contains({row, column})) find(tubesheets::tubeName(row, column) + " is both visited and unreachable");
    }
  }

  /// Checks the tilt of the posture that was solved last: the tool enters if its tilt is no more than its first step
  /// allows.
  void checkTilt(const std::string& tube, const std::optional<double>& stated) {
    const Vector3d axis_W = cell_.X_WB.linear() * (arm_.X_BD().R * cell_.arm.tool_axis_L);
    const double tilt = std::atan2(axis_W.cross(kHoleAxis_W).norm(), axis_W.dot(kHoleAxis_W));
    result_.worst_tilt = std::max(result_.worst_tilt, tilt);
    constexpr double kDegree = std::numbers::pi / 180;
    if (const double most = tubesheets::toleratedTilt(cell_.tool);
        options_.limits_tilt && !(tilt <= most + options_.tilt_tolerance))
      find(fmt::format("{}: the tool leans by {:.3g} deg, {:.3g} deg are allowed", tube, tilt / kDegree,
                       most / kDegree));
    if (stated && !(std::abs(*stated - tilt) <= options_.tilt_tolerance))
      find(tube + ": the stated tilt is not the model's");
  }

  /// Computes the deflected shape again, by a method that shares no code with the model.
  void checkStatics(const std::string& tube, const VectorXd& q, const Vector3d& tip) {
    const auto other = solveSegmentedStatics(cell_.arm, {q, cell_.load, gravity_B_});
    if (other.status == SegmentedStaticsStatus::kNotCovered) {
      result_.statics_not_covered = other.reason;
      return;
    }
    if (other.status != SegmentedStaticsStatus::kConverged) return find(tube + ": " + other.reason);
    const double distance = (cell_.X_WB * other.p_BD - tip).norm();
    result_.worst_statics = std::fmax(result_.worst_statics, distance);
    if (!(distance <= options_.statics_tolerance))
      find(fmt::format(
          "{}: with finely segmented members the tip is {:.3g} m from the model's: raise the beams' `segments`", tube,
          distance));
  }

  /// Returns the number of segments before the first approach: 0 without a start posture; 1, a travel from it; or 2, a
  /// retreat from a hole at which the arm starts, and a travel.
  int leading() const {
    if (plan_.path.empty() || plan_.path.front().kind == SegmentKind::kApproach) return 0;
    return plan_.path.front().kind == SegmentKind::kTravel ? 1 : 2;
  }

  /// Checks that time increases, and that segments are in order: approach to a tube, retreat from the tube, travel to
  /// the next tube. A path may begin and end in a posture at rest.
  void checkOrder() {
    static constexpr std::array kCycle{SegmentKind::kTravel, SegmentKind::kApproach, SegmentKind::kRetreat};
    const int first = 4 - leading();  // place in the cycle of the first segment, plus a whole cycle
    for (std::size_t k = 0; k < plan_.path.size(); ++k) {
      const PathRow& row = plan_.path[k];
      const int step = row.segment - (k > 0 ? plan_.path[k - 1].segment : 0);
      if (k > 0 && !(row.time > plan_.path[k - 1].time))
        return find(fmt::format("path row {}: time does not rise", k + 1));
      if (step < 0 || step > (k > 0 ? 1 : 0)) return find(fmt::format("path row {}: segments out of order", k + 1));
      if (row.kind != kCycle[static_cast<std::size_t>(row.segment + first) % kCycle.size()])
        return find(fmt::format("path row {}: segment {} cannot be a {}", k + 1, row.segment + 1, nameOf(row.kind)));
    }
    if (!plan_.path.empty() && plan_.path.back().kind == SegmentKind::kApproach)
      find("the path ends at a hole, without a retreat");
    checkEnd("start", plan_.start, leading() > 0, plan_.path.empty() ? nullptr : &plan_.path.front());
    checkEnd("end", plan_.end, !plan_.path.empty() && plan_.path.back().kind == SegmentKind::kTravel,
             plan_.path.empty() ? nullptr : &plan_.path.back());
  }

  void checkEnd(const std::string& name, const std::optional<VectorXd>& stated, bool has_travel, const PathRow* row) {
    if (stated.has_value() != has_travel)
      return find("the path and the plan differ on whether there is a posture to " + name + " in");
    if (stated &&
        (stated->size() != row->q.size() || (*stated - row->q).cwiseAbs().maxCoeff() > options_.joint_tolerance))
      find("the path does not " + name + " in the stated posture");
  }

  void checkJoints() {
    for (std::size_t k = 0; k < plan_.path.size(); ++k)
      for (int j = 0; j < plan_.path[k].q.size(); ++j) {
        const auto& joint = cell_.arm.joint(j);
        if (isPastLimit(joint, plan_.path[k].q[j]))
          find(fmt::format("path row {}: {} is past its limit", k + 1, joint.name));
      }
  }

  /// Checks the mean speeds between rows, and their change over the time between the midpoints of the steps. Both are
  /// within limits if the motion itself is.
  void checkSpeeds() {
    const JointSpeeds limits = jointSpeedsOf(cell_.arm);
    VectorXd before;
    double step_before = 0;
    for (std::size_t k = 1; k < plan_.path.size(); ++k) {
      const double step = plan_.path[k].time - plan_.path[k - 1].time;
      const VectorXd speed = (plan_.path[k].q - plan_.path[k - 1].q) / step;
      const double share = (speed.cwiseAbs().array() / limits.max_speed.array()).maxCoeff();
      result_.worst_speed_share = std::max(result_.worst_speed_share, share);
      if (!(share <= kLimitShare))
        find(fmt::format("path row {}: a joint exceeds its speed limit ({:.4f} of it)", k + 1, share));
      if (before.size()) {
        const VectorXd acceleration = (speed - before) / ((step + step_before) / 2);
        const double acceleration_share =
            (acceleration.cwiseAbs().array() / limits.max_acceleration.array()).maxCoeff();
        result_.worst_acceleration_share = std::max(result_.worst_acceleration_share, acceleration_share);
        // Joint values are written to 1e-12 rad; over two short steps, this rounding can cause an error that is a
        // noticeable fraction of the acceleration limit.
        const double rounding = 8e-12 / (step * std::min(step, step_before)) / limits.max_acceleration.minCoeff();
        if (!(acceleration_share <= kLimitShare + rounding))
          find(fmt::format("path row {}: a joint exceeds its acceleration limit ({:.4f} of it)", k + 1,
                           acceleration_share));
      }
      before = speed;
      step_before = step;
    }
  }

  /// Checks that the stated times agree with the path.
  void checkTimes() {
    if (plan_.path.empty()) return;
    double travel = 0;
    for (std::size_t k = 1; k < plan_.path.size(); ++k)
      if (plan_.path[k].kind == SegmentKind::kTravel) travel += plan_.path[k].time - plan_.path[k - 1].time;
    const auto compare = [&](const char* what, const std::optional<double>& stated, double found) {
      if (stated && !(std::abs(*stated - found) <= kSumTolerance))
        find(fmt::format("the stated {} is {:.3f} s, that of the path {:.3f} s", what, *stated, found));
    };
    compare("travel time", plan_.travel_time, travel);
    compare("total time", plan_.total_time, plan_.path.back().time - plan_.path.front().time);
  }

  /// Returns how long the arm rests in the posture of row k from that row on [s].
  double dwellAfter(std::size_t k) const {
    std::size_t last = k;
    while (last + 1 < plan_.path.size() && plan_.path[last + 1].q == plan_.path[k].q) ++last;
    return plan_.path[last].time - plan_.path[k].time;
  }

  /// Checks that each stated tube is the end of one approach, in order, and that the arm dwells there as long as
  /// stated.
  void checkApproaches() {
    std::size_t tube = 0;
    for (std::size_t k = 0; k < plan_.path.size(); ++k) {
      const auto& row = plan_.path[k];
      const bool ends = k + 1 == plan_.path.size() || plan_.path[k + 1].kind != SegmentKind::kApproach;
      if (row.kind != SegmentKind::kApproach || !ends) continue;
      if (tube >= plan_.tubes.size()) return find("the path has more approaches than the plan has tubes");
      const StatedTube& stated = plan_.tubes[tube++];
      if ((row.q - stated.q).cwiseAbs().maxCoeff() > options_.joint_tolerance)
        find(fmt::format("path row {}: the approach does not end at {}", k + 1,
                         tubesheets::tubeName(stated.row, stated.column)));
      if (!(dwellAfter(k) >= stated.dwell - kTimeTolerance))
        find(fmt::format("path row {}: the arm stays {:.3f} s at {}, {:.3f} s are stated", k + 1, dwellAfter(k),
                         tubesheets::tubeName(stated.row, stated.column), stated.dwell));
      if (tube > 1 && stated.zone < plan_.tubes[tube - 2].zone)
        find(tubesheets::tubeName(stated.row, stated.column) + " comes after tubes of a later zone");
    }
    if (tube < plan_.tubes.size()) find(fmt::format("the path approaches {} of {} tubes", tube, plan_.tubes.size()));
  }

  /// Checks that a retreat from the start posture begins at a hole and moves straight down, at the rows and midway
  /// between them.
  void checkDeparture() {
    if (leading() < 2) return;
    StatedTube below;
    below.hole_W = tipAt(plan_.path.front().q);
    const bool is_at_hole = std::ranges::any_of(cell_.sheet.tubes, [&](const tubesheets::Tube& tube) {
      return (holeCentre(tube) - below.hole_W).head<2>().norm() <= cell_.sheet.hole_diameter / 2;
    });
    if (!is_at_hole) find("the path begins with a retreat, but the tip is at no hole");
    for (std::size_t k = 1; k < plan_.path.size() && plan_.path[k].segment == 0; ++k) {
      const double off =
          std::max(offAxis(plan_.path[k].q, below), offAxis((plan_.path[k - 1].q + plan_.path[k].q) / 2, below));
      result_.worst_approach = std::max(result_.worst_approach, off);
      if (!(off <= options_.approach_tolerance))
        find(fmt::format("path row {}: the tip does not go straight down from where it starts", k + 1));
    }
  }

  /// Checks that the tip follows the hole's axis in the approach to a tube and in the retreat, at the rows and midway
  /// between them.
  void checkAxes() {
    checkDeparture();
    for (std::size_t k = 0; k < plan_.path.size(); ++k) {
      const PathRow& row = plan_.path[k];
      const std::size_t tube = static_cast<std::size_t>(std::max(row.segment - leading(), 0)) / 3;
      if (row.kind == SegmentKind::kTravel || tube >= plan_.tubes.size()) continue;
      if (row.segment < leading()) continue;
      double off = offAxis(row.q, plan_.tubes[tube]);
      if (k > 0) off = std::max(offAxis((plan_.path[k - 1].q + row.q) / 2, plan_.tubes[tube]), off);
      if (k > 0 && plan_.path[k - 1].kind == SegmentKind::kTravel)
        off = std::max(offAxis(plan_.path[k - 1].q, plan_.tubes[tube]), off);
      result_.worst_approach = std::max(result_.worst_approach, off);
      checkPlay(k, row.q, plan_.tubes[tube]);
      if (k > 0) checkPlay(k, (plan_.path[k - 1].q + row.q) / 2, plan_.tubes[tube]);
      if (options_.via_points && !(off <= options_.approach_tolerance))
        find(fmt::format("path row {}: the tip leaves the axis of {}", k + 1,
                         tubesheets::tubeName(plan_.tubes[tube].row, plan_.tubes[tube].column)));
    }
  }

  /// Checks that the part of the tool inside a tube does not touch the tube.
  void checkPlay(std::size_t k, const VectorXd& q, const StatedTube& tube) {
    if (!(cell_.insertion > 0)) return;
    const Vector3d off = tipAt(q) - tube.hole_W;
    const Vector3d axis = cell_.X_WB.linear() * (arm_.X_BD().R * cell_.arm.tool_axis_L);
    const double play = tubesheets::playInTube(cell_.tool, off.head<2>(), axis.head<2>() / axis.z(), off.z());
    result_.least_play = std::fmin(result_.least_play, play);
    if (!(play >= -options_.stated_tolerance))
      find(fmt::format("path row {}: the tool touches the tube of {}", k + 1,
                       tubesheets::tubeName(tube.row, tube.column)));
  }

  /// Returns the distance of the tip from the hole's axis [m]; infinite if the shape does not converge.
  double offAxis(const VectorXd& q, const StatedTube& tube) {
    const double off = (tipAt(q) - tube.hole_W).head<2>().norm();
    return std::isnan(off) ? std::numeric_limits<double>::infinity() : off;
  }

  const Workcell& cell_;
  const StatedPlan& plan_;
  const PlanCheckOptions& options_;
  const PlanHooks& hooks_;
  Vector3d gravity_B_;
  deflection::PreparedArm arm_;
  PlanCheck result_;
};

}  // namespace

PlanCheck checkPlan(const Workcell& cell, const StatedPlan& plan, const PlanCheckOptions& options,
                    const PlanHooks& hooks) {
  return Checker(cell, plan, options, hooks).run();
}

}  // namespace tubeplan::planner
