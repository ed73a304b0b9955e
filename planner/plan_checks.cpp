#include "planner/plan_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "planner/arm_clearance.hpp"
#include "planner/lipschitz_distance.hpp"

namespace tubeplan::planner {

namespace {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;
constexpr std::size_t kMostFindings = 100;
constexpr double kLimitShare = 1 + 1e-9;

class Checker {
 public:
  Checker(const Workcell& cell, const StatedPlan& plan, const PlanCheckOptions& options, const PlanHooks& hooks)
      : cell_(cell), plan_(plan), options_(options), hooks_(hooks), gravity_B_(deflection::gravityInBase(cell.arm, cell.X_WB)) {}

  PlanCheck run() {
    checkTubes();
    if (shapesFit()) {
      checkTimes();
      checkJoints();
      checkSpeeds();
      checkApproaches();
      checkClearance();
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

  Vector3d tipAt(const VectorXd& q) const {
    return cell_.X_WB * solveFlexibleKinematics(cell_.arm, {q, cell_.load, gravity_B_}, {1e-13, 100}).X_BD.p;
  }

  bool shapesFit() {
    const auto joints = static_cast<Eigen::Index>(deflection::activeRows(cell_.arm).size());
    const auto fits = [&](const VectorXd& q) { return q.size() == joints && q.allFinite(); };
    const bool fit = std::all_of(plan_.path.begin(), plan_.path.end(), [&](const PathRow& row) { return fits(row.q); }) &&
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
      if ((tube.hole_W - holeCentre(*hole)).norm() > options_.stated_tolerance) find(name + ": the stated hole is not where the sheet has it");
      if (tube.q.size() != static_cast<Eigen::Index>(deflection::activeRows(cell_.arm).size())) continue;
      const Vector3d tip = tipAt(tube.q);
      const double off = (tip - holeCentre(*hole)).norm();
      result_.worst_centring = std::max(result_.worst_centring, off);
      if (!(off <= options_.centring_tolerance)) find(fmt::format("{}: the deflected tip is {:.3g} m off the hole's centre", name, off));
      if (!((tip - tube.predicted_tip_W).norm() <= options_.stated_tolerance)) find(name + ": the stated tip is not the model's");
    }
    for (const auto& [row, column] : plan_.unreachable)
      if (seen.contains({row, column})) find(tubesheets::tubeName(row, column) + " is both visited and unreachable");
  }

  void checkTimes() {
    for (std::size_t k = 1; k < plan_.path.size(); ++k) {
      if (!(plan_.path[k].time > plan_.path[k - 1].time)) return find(fmt::format("path row {}: time does not rise", k + 1));
      const int step = plan_.path[k].segment - plan_.path[k - 1].segment;
      if (step != 0 && step != 1) return find(fmt::format("path row {}: segments out of order", k + 1));
    }
  }

  void checkJoints() {
    const auto active = deflection::activeRows(cell_.arm);
    for (std::size_t k = 0; k < plan_.path.size(); ++k)
      for (int j = 0; j < plan_.path[k].q.size(); ++j) {
        const auto& joint = cell_.arm.rows[static_cast<std::size_t>(active[static_cast<std::size_t>(j)])].joint;
        const double q = plan_.path[k].q[j];
        if (q < joint.lower - 1e-12 || q > joint.upper + 1e-12) find(fmt::format("path row {}: {} is past its limit", k + 1, joint.name));
      }
  }

  /// Mean speeds between rows, and their change over the time between the middles: within limits if the motion itself is.
  void checkSpeeds() {
    const JointSpeeds limits = jointSpeedsOf(cell_.arm);
    VectorXd before;
    double step_before = 0;
    for (std::size_t k = 1; k < plan_.path.size(); ++k) {
      const double step = plan_.path[k].time - plan_.path[k - 1].time;
      const VectorXd speed = (plan_.path[k].q - plan_.path[k - 1].q) / step;
      const double share = (speed.cwiseAbs().array() / limits.max_speed.array()).maxCoeff();
      result_.worst_speed_share = std::max(result_.worst_speed_share, share);
      if (!(share <= kLimitShare)) find(fmt::format("path row {}: a joint is faster than its limit ({:.4f} of it)", k + 1, share));
      if (before.size()) {
        const VectorXd acceleration = (speed - before) / ((step + step_before) / 2);
        const double pull = (acceleration.cwiseAbs().array() / limits.max_acceleration.array()).maxCoeff();
        result_.worst_acceleration_share = std::max(result_.worst_acceleration_share, pull);
        // Joint values are written to 1e-12 rad; over two short steps that is a share of the limit, too.
        const double rounding = 8e-12 / (step * std::min(step, step_before)) / limits.max_acceleration.minCoeff();
        if (!(pull <= kLimitShare + rounding)) find(fmt::format("path row {}: a joint accelerates past its limit ({:.4f} of it)", k + 1, pull));
      }
      before = speed;
      step_before = step;
    }
  }

  /// Each stated tube must be the end of one approach, in order, and the approach must follow the hole's axis.
  void checkApproaches() {
    std::size_t tube = 0;
    for (std::size_t k = 0; k < plan_.path.size(); ++k) {
      const auto& row = plan_.path[k];
      if (row.kind != SegmentKind::kApproach) continue;
      if (tube >= plan_.tubes.size()) return find("the path has more approaches than the plan has tubes");
      const StatedTube& stated = plan_.tubes[tube];
      const Vector3d off = tipAt(row.q) - stated.hole_W;
      result_.worst_approach = std::max(result_.worst_approach, off.head<2>().norm());
      if (options_.via_points && off.head<2>().norm() > options_.approach_tolerance)
        find(fmt::format("path row {}: the tip leaves the axis of {}", k + 1, tubesheets::tubeName(stated.row, stated.column)));
      const bool ends = k + 1 == plan_.path.size() || plan_.path[k + 1].kind != SegmentKind::kApproach;
      if (!ends) continue;
      if ((row.q - stated.q).cwiseAbs().maxCoeff() > options_.joint_tolerance)
        find(fmt::format("path row {}: the approach does not end at {}", k + 1, tubesheets::tubeName(stated.row, stated.column)));
      ++tube;
    }
    if (tube < plan_.tubes.size()) find(fmt::format("the path approaches {} of {} tubes", tube, plan_.tubes.size()));
  }

  double marginAt(const VectorXd& q, SegmentKind kind, std::string* names) const {
    double bow = 0;
    const auto frames = bodyFrames(cell_, q, &bow);
    if (frames.empty()) return -std::numeric_limits<double>::infinity();
    Scene scene = cell_.scene;
    if (kind == SegmentKind::kTravel) forbidContact(scene);
    return lipschitzMargin(scene, frames, options_.distance_accuracy, names) - bow;
  }

  /// Between holes the tool has no leave to touch anything.
  static void forbidContact(Scene& scene) {
    if (scene.links.empty()) return;
    std::set<std::string> tool{scene.links.back().name};
    for (const auto& body : scene.bodies)
      if (body.link == scene.links.back().name && !body.name.empty()) tool.insert(body.name);
    for (auto& obstacle : scene.obstacles) std::erase_if(obstacle.allow, [&](const std::string& name) { return tool.contains(name); });
  }

  /// No point of the arm moves further than this in a straight joint move; deflection's change is the tenth on top.
  double travel(const VectorXd& a, const VectorXd& b) const {
    return 1.1 * deflection::reachOf(cell_.arm) * (b - a).cwiseAbs().sum();
  }

  void proveBetween(const PathRow& a, const VectorXd& qb, double margin_a, double margin_b, std::size_t row) {
    const VectorXd& qa = a.q;
    const double far = travel(qa, qb);
    if (margin_a + margin_b >= far) {
      result_.least_margin = std::min(result_.least_margin, (margin_a + margin_b - far) / 2);
      return;
    }
    if (far < options_.least_travel) return find(fmt::format("path row {}: too near: {}", row + 1, tight_));
    PathRow middle = a;
    middle.q = (qa + qb) / 2;
    const double margin = marginAt(middle.q, a.kind, &tight_);
    if (margin < 0) return find(fmt::format("path between rows {} and {}: too near: {}", row, row + 1, tight_));
    proveBetween(a, middle.q, margin_a, margin, row);
    proveBetween(middle, qb, margin, margin_b, row);
  }

  void checkClearance() {
    double before = 0;
    for (std::size_t k = 0; k < plan_.path.size(); ++k) {
      if (hooks_.progress && k % 64 == 0) hooks_.progress("verify", k, plan_.path.size());
      if (hooks_.stop && hooks_.stop()) return find("stopped before the clearance was proved");
      std::string names;
      const PathRow& row = plan_.path[k];
      const double here = marginAt(row.q, row.kind, &names);
      if (here < least_at_row_) least_at_row_ = here, result_.tightest = names;
      if (here < 0) find(fmt::format("path row {}: too near: {}", k + 1, names));
      if (k > 0 && here >= 0 && before >= 0) {
        PathRow from = plan_.path[k - 1];
        from.kind = row.kind;
        const double start = from.kind == plan_.path[k - 1].kind ? before : marginAt(from.q, row.kind, nullptr);
        tight_ = names;
        proveBetween(from, row.q, start, here, k);
      }
      before = here;
    }
  }

  const Workcell& cell_;
  const StatedPlan& plan_;
  const PlanCheckOptions& options_;
  const PlanHooks& hooks_;
  Vector3d gravity_B_;
  PlanCheck result_;
  std::string tight_;
  double least_at_row_ = std::numeric_limits<double>::infinity();
};

}  // namespace

PlanCheck checkPlan(const Workcell& cell, const StatedPlan& plan, const PlanCheckOptions& options, const PlanHooks& hooks) {
  return Checker(cell, plan, options, hooks).run();
}

}  // namespace tubeplan::planner
