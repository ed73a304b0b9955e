#include "deflection/inverse/start_postures.hpp"

#include <algorithm>
#include <cmath>

#include "deflection/inverse/branch_verdict.hpp"
#include "deflection/inverse/goal_newton.hpp"
#include "deflection/inverse/turret_branches.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

namespace {

using Eigen::VectorXd;
constexpr double kBends = 0.03;  ///< tip error that deflection may correct, as a fraction of the reach
/// Excess over joint limits [rad or fraction of the reach] or largest tilt [rad] that deflection may correct.
constexpr double kBendsBy = 0.1;
/// Smallest difference between the postures that are chosen first, in at least one joint [rad or fraction of the
/// reach].
constexpr double kUnlike = 0.3;
/// Largest difference, in every joint, between postures that are treated as the same [rad or fraction of the reach].
constexpr double kSamePosture = 1e-3;
constexpr double kNearGoal = 0.01;  ///< largest tip error of a usable search result, as a fraction of the reach
constexpr std::size_t kEnough = 8;  ///< number of usable postures that suffices for a redundant arm
/// Largest number of start postures outside limits or tilted too far; their branches explain to the user why a goal is
/// not met.
constexpr int kMostPenalized = 4;

InverseKinematicsOptions roughly(InverseKinematicsOptions options) {
  options.position_tolerance = options.pitch_tolerance = 1e-6;
  return options;
}

/// Returns the number of prismatic joints. With three, the closure equations are singular even with perturbed axes;
/// with two, they may be.
std::ptrdiff_t countSlides(const AxesAtZero& axes) { return std::count(axes.slides.begin(), axes.slides.end(), true); }

}  // namespace

StartPostures::StartPostures(const Arm& arm, const InverseKinematicsOptions& options)
    : arm_(arm),
      axes_(axesAtZero(arm)),
      is_turret_(carriesPlane(axes_)),
      options_(roughly(options)),
      rigid_(arm, false, rigidTips(axes_), options_) {}

bool StartPostures::iterateAll(const ToolGoal& goal, std::span<const VectorXd> starts,
                               std::vector<Candidate>& candidates) {
  std::vector<Candidate> met, near;
  for (const Branch& found : leadToGoals(rigid_, std::vector(starts.size(), goal), starts)) {
    if (!(found.position_error < kBends * rigid_.reach())) continue;
    const double tilted = std::max(0., found.tilt - options_.max_tilt);
    const bool is_met = found.status == BranchStatus::kConverged;
    (is_met ? met : near).push_back({found.q, rigid_.mostPastLimits(found.q) + tilted});
  }
  const bool is_any_met = !met.empty();
  candidates = is_any_met ? std::move(met) : std::move(near);
  return is_any_met;
}

/// Returns the starts that are already near the goal and within limits. With kEnough of them, a redundant arm needs no
/// others.
std::vector<StartPostures::Candidate> StartPostures::within(const ToolGoal& goal, std::span<const VectorXd> starts) {
  std::vector<Candidate> good;
  TipMotion tip;
  GoalResidual r;
  for (const VectorXd& start : starts) {
    if (rigid_.mostPastLimits(start) > 0) continue;
    rigid_.place(start, std::span(&tip, 1));
    rigid_.evaluate(goal, tip, r);
    if (r.position_error < kNearGoal * rigid_.reach() && r.tilt < options_.max_tilt) good.push_back({start, 0});
  }
  return good;
}

std::vector<StartPostures::Candidate> StartPostures::search(const ToolGoal& goal) {
  std::vector<Candidate> found;
  if (arm_.jointCount() < 3 || countSlides(axes_) >= 2) {
    (void)iterateAll(goal, latticeStarts(arm_, options_.lattice_starts), found);
    return found;
  }
  std::vector<VectorXd> starts;
  if (!postures_) postures_.emplace(arm_, axes_);
  postures_->addPostures(goal, starts);
  if (postures_->areUpright() && postures_->isContinuum()) {
    found = within(goal, starts);
    if (found.size() >= kEnough) return found;
  }
  if (iterateAll(goal, starts, found)) return found;
  // If no posture has the tool along the goal axis, postures that only reach the goal position may still have an
  // allowed tilt.
  starts.clear();
  if (!places_) places_.emplace(arm_, axes_, RigidSearch::Constraint::kPlace);
  places_->addPostures(goal, starts);
  (void)iterateAll(goal, starts, found);
  return found;
}

std::vector<VectorXd> StartPostures::distinct(std::span<const Candidate> candidates, int most) const {
  const auto areDistinct = [this](const VectorXd& a, const VectorXd& b, double least) {
    for (Eigen::Index j = 0; j < a.size(); ++j)
      if ((rigid_.scale()[j] == 1 ? angleDifference(a[j], b[j]) : std::abs(a[j] - b[j]) / rigid_.scale()[j]) > least)
        return true;
    return false;
  };
  std::vector<VectorXd> chosen;
  // Postures are chosen in the order of the search, which is the same for every goal, so that neighbouring goals get
  // corresponding branches.
  for (const double least : {kUnlike, kSamePosture})
    for (const Candidate& candidate : candidates) {
      if (static_cast<int>(chosen.size()) >= most) return chosen;
      if (std::ranges::all_of(chosen, [&](const VectorXd& other) { return areDistinct(candidate.q, other, least); }))
        chosen.push_back(candidate.q);
    }
  return chosen;
}

void StartPostures::addStarts(const ToolGoal& goal, std::vector<VectorXd>& starts) {
  if (is_turret_) return addTurretBranches(axes_, goal, starts);
  std::vector<Candidate> found = search(goal);
  const auto penalized =
      std::stable_partition(found.begin(), found.end(), [](const Candidate& c) { return c.penalty <= kBendsBy; });
  std::stable_sort(penalized, found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.penalty < b.penalty; });
  const auto good = static_cast<std::size_t>(penalized - found.begin());
  for (auto& q : distinct(std::span(found).first(good), options_.most_branches)) starts.push_back(std::move(q));
  for (auto& q : distinct(std::span(found).subspan(good), kMostPenalized)) starts.push_back(std::move(q));
}

}  // namespace tubeplan::deflection
