// Where the tip goes at each visit of a plan: by the model itself, and by a true arm.
#pragma once

#include <vector>

#include "app/studies/positioning/step_score.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

/// Per visit, in their order.
[[nodiscard]] std::vector<Eigen::VectorXd> visitPostures(const planner::VisitPlan& plan);

/// The model's own view of each visit: where the tip goes, and how sure that is.
[[nodiscard]] std::vector<planner::Centring> predictVisits(const planner::Workcell& model,
                                                           const planner::VisitPlan& plan);

/// Each visit by every way of steering, on all cores.
[[nodiscard]] std::vector<ModeScores> scoreVisitModes(const ScoringModels& models, const planner::VisitPlan& plan);

/// The least play of the tool in the tube of each visit [m].
[[nodiscard]] std::vector<double> playInTubes(const planner::Workcell& model, const planner::VisitPlan& plan);

/// The most that a tip at a visited hole is padded by [m], for `sigmas` of the base.
[[nodiscard]] double paddingAtHoles(const planner::Workcell& model, const planner::VisitPlan& plan, double sigmas);

}  // namespace tubeplan::app
