// Tip poses at the visits of a plan: as the model predicts them, and as a true arm reaches them.
#pragma once

#include <vector>

#include "app/studies/positioning/step_score.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

/// Returns the posture of each visit, in the order of the visits.
[[nodiscard]] std::vector<Eigen::VectorXd> visitPostures(const planner::VisitPlan& plan);

/// Returns the centring at each visit as the model predicts it.
[[nodiscard]] std::vector<planner::Centring> predictVisits(const planner::Workcell& model,
                                                           const planner::VisitPlan& plan);

/// Returns the centring of each visit in every mode of compensation, computed on all cores.
[[nodiscard]] std::vector<ModeScores> scoreVisitModes(const ScoringModels& models, const planner::VisitPlan& plan);

/// Returns the smallest clearance between tool and tube at each visit [m].
[[nodiscard]] std::vector<double> playInTubes(const planner::Workcell& model, const planner::VisitPlan& plan);

/// Returns the largest padding [m] that the uncertainty of the base, at `sigmas` standard deviations, requires at the
/// tip in any of the visited holes.
[[nodiscard]] double paddingAtHoles(const planner::Workcell& model, const planner::VisitPlan& plan, double sigmas);

}  // namespace tubeplan::app
