#include "planner/verification/path_clearance_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "deflection/anchored_rows.hpp"
#include "deflection/row_placing.hpp"
#include "planner/collision/arm_clearance.hpp"
#include "planner/collision/deflection_travel.hpp"
#include "planner/verification/lipschitz_distance.hpp"

namespace tubeplan::planner {

namespace {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;

/// Returns the scene for travels between holes, in which the tool may not touch obstacles even where `allow` lists
/// permit it.
Scene withoutContact(Scene scene) {
  if (scene.links.empty()) return scene;
  std::set<std::string> tool{scene.links.back().name}, obstacles;
  for (const auto& body : scene.bodies)
    if (body.link == scene.links.back().name && !body.name.empty()) tool.insert(body.name);
  for (auto& obstacle : scene.obstacles) {
    obstacles.insert(obstacle.name);
    std::erase_if(obstacle.allow, [&](const std::string& name) { return tool.contains(name); });
  }
  for (auto& body : scene.bodies)
    if (body.link == scene.links.back().name)
      std::erase_if(body.allow, [&](const std::string& name) { return obstacles.contains(name); });
  return scene;
}

/// Returns the largest distance of a body point from its row's origin [m], with the origin moved along the row's z
/// axis.
double thickestBody(const Scene& scene, const std::vector<double>& slid) {
  double thick = 0;
  for (const auto& body : scene.bodies) {
    const auto& capsule = static_cast<const Solid&>(*body.shape).around();
    const Vector3d origin = slid.at(static_cast<std::size_t>(body.frame_index)) * Vector3d::UnitZ();
    thick = std::max(thick, std::max((capsule.from - origin).norm(), (capsule.to - origin).norm()) + capsule.radius);
  }
  return thick;
}

/// Returns the sum of the lengths of all rows beyond a row's axis, plus the thickest body [m]. No point of the arm
/// beyond the axis is farther from it than this.
double reachBeyond(const deflection::Arm& arm, int row, double thick) {
  double reach = thick;
  for (std::size_t next = static_cast<std::size_t>(row) + 1; next < arm.rows.size(); ++next)
    reach +=
        deflection::memberOf(arm, static_cast<int>(next) - 1).norm() + deflection::slideLength(arm.rows[next].joint);
  return reach;
}

/// For each joint, returns the largest displacement of any point per unit of joint motion, including all rows that turn
/// with the joint; 1 for a prismatic joint.
VectorXd leversOf(const deflection::Arm& arm, double thick) {
  const auto active = deflection::activeRows(arm);
  VectorXd lever = VectorXd::Zero(static_cast<Eigen::Index>(active.size()));
  for (int j = 0; j < lever.size(); ++j) {
    for (const auto& moved : deflection::turnedWith(arm, active[static_cast<std::size_t>(j)])) {
      const auto& joint = arm.rows[static_cast<std::size_t>(moved.row)].joint;
      const bool is_slide = joint.type == deflection::JointType::kPrismatic;
      lever[j] += std::abs(moved.ratio) * (is_slide ? 1 : reachBeyond(arm, moved.row, thick));
    }
  }
  return lever;
}

class PathClearance {
 public:
  PathClearance(const Workcell& cell, const StatedPlan& plan, const PlanCheckOptions& options, const PlanHooks& hooks,
                const ReportFinding& find, PlanCheck& result)
      : arm_(cell.arm),
        plan_(plan),
        options_(options),
        hooks_(hooks),
        find_(find),
        result_(result),
        travel_scene_(withoutContact(cell.scene)),
        travelling_(travel_scene_, BasePadding(cell, options.padding)),
        approaching_(cell.scene, BasePadding(cell, options.padding)),
        placing_(cell.arm, cell.load, cell.X_WB),
        frames_(cell.arm.rows.size()) {
    const deflection::AnchoredRows anchored = deflection::anchoredRows(cell.arm);
    const double thick = thickestBody(cell.scene, anchored.slid);
    const auto deflection = deflectionTravelOf(cell, std::vector<double>(cell.arm.rows.size(), thick));
    jump_ = deflection.jump;
    lever_ = leversOf(anchored.arm, thick);
    if (deflection.is_proved)
      lever_ = deflection.stretch * lever_ + deflection.per_joint;
    else
      lever_ *= deflectionFactor(cell);
    result_.deflection_travel_sampled = deflection.reason;
    lever_ *= 1 + BasePadding(cell, options.padding).slope();
  }

  void run() {
    double margin_before = 0;
    bool was_within = false;
    for (std::size_t k = 0; k < plan_.path.size(); ++k) {
      if (hooks_.progress && k % 64 == 0) hooks_.progress("verify", k, plan_.path.size());
      std::string names;
      const PathRow& row = plan_.path[k];
      const double margin = marginAtRow(k, &names);
      meet(margin, names);
      if (margin < 0) {
        find_(fmt::format("path row {}: too near: {}", k + 1, names));
        result_.least_margin = std::min(result_.least_margin, margin);
      }
      const bool is_within = isWithinLimits(row.q);
      if (is_within && was_within && margin >= 0 && margin_before >= 0) {
        PathRow from = plan_.path[k - 1];
        from.kind = row.kind;
        const double start = from.kind == plan_.path[k - 1].kind ? margin_before : marginAt(from.q, row.kind, nullptr);
        proveBetween(from, row.q, start, margin, k);
      }
      if (isStopped()) return find_("stopped before the clearance was proved");
      margin_before = margin;
      was_within = is_within;
    }
    checkStated();
  }

 private:
  [[nodiscard]] bool isStopped() const { return hooks_.stop && hooks_.stop(); }

  /// Returns true if all joint values are within their limits. Another check reports rows beyond the limits. Moves to
  /// them are skipped here, because they may be very long.
  [[nodiscard]] bool isWithinLimits(const VectorXd& q) const {
    for (int j = 0; j < q.size(); ++j)
      if (isPastLimit(arm_.joint(j), q[j])) return false;
    return true;
  }

  /// Checks the stated clearance against the smallest margin met. That margin is a lower bound of the true margin, and
  /// `slack` allows for the difference.
  void checkStated() {
    if (!plan_.least_clearance || plan_.path.empty()) return;
    const double stated = *plan_.least_clearance - travel_scene_.clearance;
    const double slack = 2 * std::max(options_.distance_accuracy, options_.distance_share * std::abs(least_met_));
    if (stated > least_met_ + slack)
      find_(fmt::format("the stated clearance is {:.4g} m, but it is only {:.4g} m at {}", *plan_.least_clearance,
                        least_met_ + travel_scene_.clearance, result_.tightest));
  }

  double marginAt(const VectorXd& q, SegmentKind kind, std::string* names) {
    return marginOf(placing_.place(q), 0, kind, names);
  }

  /// Returns the margin at row k of the path. Rows are placed side by side in as many lanes as the processor's kernels
  /// have.
  double marginAtRow(std::size_t k, std::string* names) {
    const auto lanes = static_cast<std::size_t>(placing_.lanes());
    if (k % lanes == 0) {
      const std::size_t count = std::min(lanes, plan_.path.size() - k);
      PostureColumns q(plan_.path[k].q.size(), static_cast<Eigen::Index>(count));
      for (std::size_t l = 0; l < count; ++l) q.col(static_cast<Eigen::Index>(l)) = plan_.path[k + l].q;
      rows_ = placing_.place(q, 0);
    }
    return marginOf(rows_, static_cast<int>(k % lanes), plan_.path[k].kind, names);
  }

  double marginOf(const deflection::PlacedRows& placed, int lane, SegmentKind kind, std::string* names) {
    if (!placed.is_converged[static_cast<std::size_t>(lane)]) return -std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < frames_.size(); ++row) frames_[row] = placed.X_WL(static_cast<int>(row), lane);
    LipschitzMargins& margins = kind == SegmentKind::kTravel ? travelling_ : approaching_;
    return margins.at(frames_, options_.distance_accuracy, options_.distance_share, names) -
           placed.bow[static_cast<std::size_t>(lane)] - jump_;
  }

  /// Returns an upper bound of any point's travel in a straight joint move [m], including changes of the deflection.
  double travel(const VectorXd& a, const VectorXd& b) const { return lever_.dot((b - a).cwiseAbs()); }

  void meet(double margin, const std::string& names) {
    if (!(margin < least_met_)) return;
    least_met_ = margin;
    result_.tightest = names;
  }

  /// Proves the segment between two rows. Returns false if it is refuted, or if the check is stopped.
  bool proveBetween(const PathRow& a, const VectorXd& qb, double margin_a, double margin_b, std::size_t row) {
    const double far = travel(a.q, qb), proved = std::min({margin_a, margin_b, (margin_a + margin_b - far) / 2});
    const bool too_coarse = proved < least_met_ - options_.report_accuracy && far >= options_.least_travel;
    if (proved >= 0 && !too_coarse) {
      result_.least_margin = std::min(result_.least_margin, proved);
      return true;
    }
    if (isStopped()) return false;
    PathRow middle = a;
    middle.q = (a.q + qb) / 2;
    std::string names;
    const double margin = marginAt(middle.q, a.kind, &names);
    meet(margin, names);
    if (margin < 0 || far < options_.least_travel) {
      find_(fmt::format("path between rows {} and {}: too near: {}", row, row + 1, names));
      result_.least_margin = std::min({result_.least_margin, margin, proved});
      return false;
    }
    return proveBetween(a, middle.q, margin_a, margin, row) && proveBetween(middle, qb, margin, margin_b, row);
  }

  const deflection::Arm& arm_;
  const StatedPlan& plan_;
  const PlanCheckOptions& options_;
  const PlanHooks& hooks_;
  const ReportFinding& find_;
  PlanCheck& result_;
  Scene travel_scene_;
  LipschitzMargins travelling_, approaching_;
  deflection::RowPlacing placing_;
  deflection::PlacedRows rows_;  ///< rows of the path placed side by side, including the row that was requested last
  std::vector<Isometry3d> frames_;
  VectorXd lever_;
  double jump_ = 0;
  double least_met_ = std::numeric_limits<double>::infinity();  ///< smallest margin of any posture so far [m]
};

}  // namespace

bool isPastLimit(const deflection::Joint<double>& joint, double q) {
  constexpr double kRounding = 1e-12;  // resolution of joint values in plan files [rad or m]
  return q < joint.lower - kRounding || q > joint.upper + kRounding;
}

void checkPathClearance(const Workcell& cell, const StatedPlan& plan, const PlanCheckOptions& options,
                        const PlanHooks& hooks, const ReportFinding& find, PlanCheck& result) {
  PathClearance(cell, plan, options, hooks, find, result).run();
}

}  // namespace tubeplan::planner
