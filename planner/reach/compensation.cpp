#include "planner/reach/compensation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "planner/reach/tip_prediction.hpp"
#include "planner/reach/tool_placer.hpp"

namespace tubeplan::planner {

namespace {

using deflection::BranchStatus, deflection::ToolGoal;
using Eigen::Vector3d, Eigen::VectorXd;

struct CompensationRow {
  Compensation mode;
  std::string_view name;
  std::string_view words;
};
constexpr std::array kModes{CompensationRow{Compensation::kNone, "none", "no compensation"},
                            CompensationRow{Compensation::kGoalPoint, "goal-point", "goal-point compensation"},
                            CompensationRow{Compensation::kViaPoint, "via-point", "via-point compensation"}};

const CompensationRow& rowOf(Compensation mode) {
  return *std::find_if(kModes.begin(), kModes.end(), [&](const auto& row) { return row.mode == mode; });
}

/// Approach to the goal in one branch. Via points are evenly spaced from the goal down to the standoff. Their spacing
/// is halved until the tip of the placer's model, midway between via points, is close enough to the vertical line.
class Approach {
 public:
  Approach(const Vector3d& goal_W, TubeBranch& branch) : goal_W_(goal_W), branch_(&branch), postures_{branch.q} {}

  [[nodiscard]] bool isOpen() const { return open_; }
  [[nodiscard]] const VectorXd& lowest() const { return postures_.back(); }
  [[nodiscard]] const std::vector<VectorXd>& middles() const { return middles_; }

  /// Returns the point that lies below the goal by the fraction `share` of the standoff [m].
  [[nodiscard]] Vector3d placeAt(double share, double standoff) const {
    return goal_W_ - share * standoff * kHoleAxis_W;
  }
  [[nodiscard]] Vector3d middlePlace(std::size_t k, double standoff) const {
    return placeAt((static_cast<double>(k) + 0.5) / static_cast<double>(postures_.size() - 1), standoff);
  }

  void addBelow(const deflection::Branch& via) {
    if (!fails(via)) postures_.push_back(via.q);
  }

  /// Adds one via point between each pair of consecutive via points.
  void addBetween(std::span<const deflection::Branch> vias) {
    std::vector<VectorXd> denser{postures_.front()};
    for (std::size_t k = 0; k < vias.size(); ++k) {
      if (fails(vias[k])) return;
      denser.push_back(vias[k].q);
      denser.push_back(postures_[k + 1]);
    }
    postures_ = std::move(denser);
  }

  void findMiddles() {
    middles_.clear();
    for (std::size_t k = 0; k + 1 < postures_.size(); ++k) middles_.push_back((postures_[k] + postures_[k + 1]) / 2);
  }

  /// Ends the refinement if the tip is close enough to the vertical at every midpoint, or if no more via points are
  /// allowed.
  void judge(std::span<const Vector3d> tips_W, const CompensationOptions& options) {
    double worst = 0;
    for (const Vector3d& tip_W : tips_W) worst = worseOf(worst, (tip_W - goal_W_).head<2>().norm());
    if (worst <= options.path_tolerance) {
      open_ = false;
      branch_->approach.assign(postures_.rbegin(), postures_.rend());
    } else if (2 * static_cast<int>(postures_.size()) - 1 > options.max_via_points) {
      branch_->approach.assign(postures_.rbegin(), postures_.rend());
      fail("the tip leaves the hole's axis between via points");
    }
  }

  void fail(const std::string& why) {
    open_ = false;
    branch_->status = BranchStatus::kNotConverged;
    branch_->reason = "approach: " + why;
  }

 private:
  bool fails(const deflection::Branch& via) {
    if (via.status == BranchStatus::kConverged) return false;
    fail(via.reason);
    return true;
  }

  Vector3d goal_W_;
  TubeBranch* branch_;
  std::vector<VectorXd> postures_, middles_;
  bool open_ = true;
};

void dropClosed(std::vector<Approach>& approaches) {
  std::erase_if(approaches, [](const Approach& approach) { return !approach.isOpen(); });
}

/// Adds the first via points of all branches: halfway down to the standoff, then at the standoff.
void goDown(ToolPlacer& placer, double standoff, std::vector<Approach>& approaches) {
  for (const double share : {0.5, 1.}) {
    std::vector<Vector3d> places;
    std::vector<VectorXd> starts;
    for (const Approach& approach : approaches) {
      places.push_back(approach.placeAt(share, standoff));
      starts.push_back(approach.lowest());
    }
    const auto vias = placer.near(places, starts);
    for (std::size_t k = 0; k < approaches.size(); ++k) approaches[k].addBelow(vias[k]);
    dropClosed(approaches);
  }
}

/// Checks each approach at the tip positions midway between its via points, and removes the approaches that are
/// finished.
void judgeMiddles(ToolPlacer& placer, const CompensationOptions& options, std::vector<Approach>& approaches) {
  std::vector<VectorXd> postures;
  for (Approach& approach : approaches) {
    approach.findMiddles();
    postures.insert(postures.end(), approach.middles().begin(), approach.middles().end());
  }
  const std::vector<Vector3d> tips_W = placer.tipsAt(postures);
  std::size_t first = 0;
  for (Approach& approach : approaches) {
    const std::size_t count = approach.middles().size();
    approach.judge(std::span(tips_W).subspan(first, count), options);
    first += count;
  }
  dropClosed(approaches);
}

void makeDenser(ToolPlacer& placer, double standoff, std::vector<Approach>& approaches) {
  std::vector<Vector3d> places;
  std::vector<VectorXd> starts;
  for (const Approach& approach : approaches)
    for (std::size_t k = 0; k < approach.middles().size(); ++k) {
      places.push_back(approach.middlePlace(k, standoff));
      starts.push_back(approach.middles()[k]);
    }
  const auto vias = placer.near(places, starts);
  std::size_t first = 0;
  for (Approach& approach : approaches) {
    const std::size_t count = approach.middles().size();
    approach.addBetween(std::span(vias).subspan(first, count));
    first += count;
  }
  dropClosed(approaches);
}

/// Adds as many via points as are needed to keep the tip of the placer's model within tolerance of the vertical line.
void addApproaches(ToolPlacer& placer, const CompensationOptions& options, std::vector<Approach> approaches) {
  if (options.max_via_points < 3) {
    for (Approach& approach : approaches) approach.fail("the tip leaves the hole's axis between via points");
    return;
  }
  goDown(placer, options.standoff, approaches);
  judgeMiddles(placer, options, approaches);
  while (!approaches.empty()) {
    makeDenser(placer, options.standoff, approaches);
    judgeMiddles(placer, options, approaches);
  }
}

/// The models, flexible or rigid, that a compensation mode uses for the goal and for the approach. Each is created on
/// first use.
class Modes {
 public:
  Modes(const Workcell& cell, const CompensationOptions& options) : cell_(cell), options_(options), tips_(cell) {}

  ToolPlacer& goal() { return options_.mode == Compensation::kNone ? rigid() : flexible(); }

  std::vector<TubeBranch> complete(const Vector3d& hole_W, std::vector<deflection::Branch> found) {
    std::vector<TubeBranch> branches;
    for (auto& branch : found) branches.push_back(atTheHole(std::move(branch)));
    if (!options_.with_approach) return branches;
    ToolPlacer& via = options_.mode == Compensation::kViaPoint ? flexible() : rigid();
    std::vector<Approach> approaches;
    for (TubeBranch& branch : branches)
      // The approach ends at the tip position that its own model predicts for the goal posture. With goal-point
      // compensation, this is the rigid model's tip, although the posture was found with the flexible model.
      if (branch.status == BranchStatus::kConverged) approaches.emplace_back(via.tipsAt({branch.q}).front(), branch);
    addApproaches(via, options_, std::move(approaches));
    for (TubeBranch& branch : branches)
      if (branch.status == BranchStatus::kConverged)
        branch.path_deviation = tips_.lateralDeviation(hole_W, branch.approach);
    return branches;
  }

 private:
  TubeBranch atTheHole(deflection::Branch found) {
    TubeBranch branch;
    branch.status = found.status;
    branch.reason = std::move(found.reason);
    branch.q = std::move(found.q);
    if (branch.status != BranchStatus::kConverged) return branch;
    const PredictedTip tip = tips_.at(branch.q);
    branch.predicted_tip_W = tip.p_WT;
    branch.tilt = tip.tilt;
    return branch;
  }

  ToolPlacer& flexible() {
    if (!flexible_) flexible_.emplace(cell_, cell_.arm, options_.inverse);
    return *flexible_;
  }
  ToolPlacer& rigid() {
    if (!rigid_) {
      rigid_arm_ = deflection::rigidCopy(cell_.arm);
      rigid_.emplace(cell_, *rigid_arm_, options_.inverse);
    }
    return *rigid_;
  }

  const Workcell& cell_;
  const CompensationOptions& options_;
  TipPrediction tips_;
  std::optional<deflection::Arm> rigid_arm_;
  std::optional<ToolPlacer> flexible_, rigid_;
};

}  // namespace

std::string_view nameOf(Compensation mode) { return rowOf(mode).name; }

std::string_view wordsOf(Compensation mode) { return rowOf(mode).words; }

std::optional<Compensation> findCompensation(std::string_view name) {
  for (const auto& row : kModes)
    if (row.name == name) return row.mode;
  return std::nullopt;
}

std::vector<TubeBranch> compensate(const Workcell& cell, const Vector3d& hole_W, const CompensationOptions& options) {
  Modes modes(cell, options);
  return modes.complete(hole_W, modes.goal().allBranches(hole_W));
}

TubeBranch compensateFrom(const Workcell& cell, const Vector3d& hole_W, const VectorXd& q_start,
                          const CompensationOptions& options) {
  Modes modes(cell, options);
  return std::move(modes.complete(hole_W, modes.goal().near({hole_W}, {q_start})).front());
}

}  // namespace tubeplan::planner
