// Places of the tip at each visit of a plan: by the model itself, and by a true arm.
#pragma once

#include <vector>

#include "app/studies/positioning/step_score.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

/// Returns the posture of each visit, in their order.
[[nodiscard]] std::vector<Eigen::VectorXd> visitPostures(const planner::VisitPlan& plan);

/// Returns the model's own prediction of each visit.
[[nodiscard]] std::vector<planner::Centring> predictVisits(const planner::Workcell& model,
                                                           const planner::VisitPlan& plan);

/// Returns the scores of each visit in every mode of compensation, computed on all cores.
[[nodiscard]] std::vector<ModeScores> scoreVisitModes(const ScoringModels& models, const planner::VisitPlan& plan);

/// Returns the least clearance of the tool in the tube of each visit [m].
[[nodiscard]] std::vector<double> playInTubes(const planner::Workcell& model, const planner::VisitPlan& plan);

/// Returns the largest padding of a tip at a visited hole [m], for `sigmas` of the base.
[[nodiscard]] double paddingAtHoles(const planner::Workcell& model, const planner::VisitPlan& plan, double sigmas);

}  // namespace tubeplan::app
