#include "app/studies/positioning/planned_visits.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "planner/collision/padding.hpp"
#include "planner/reach/insertion.hpp"

namespace tubeplan::app {

std::vector<Eigen::VectorXd> visitPostures(const planner::VisitPlan& plan) {
  std::vector<Eigen::VectorXd> postures;
  for (const auto& visit : plan.visits) postures.push_back(visit.branch.q);
  return postures;
}

std::vector<planner::Centring> predictVisits(const planner::Workcell& model, const planner::VisitPlan& plan) {
  planner::TipPrediction tips(model);
  std::vector<planner::Centring> predicted;
  for (const auto& visit : plan.visits) {
    const auto hole = planner::visitPlace(model, model.sheet.tubes[static_cast<std::size_t>(visit.tube)]);
    predicted.push_back(planner::scoreVisit(tips, model, hole, visit.branch));
  }
  return predicted;
}

std::vector<ModeScores> scoreVisitModes(const ScoringModels& models, const planner::VisitPlan& plan) {
  std::vector<ModeScores> scores(plan.visits.size());
  oneapi::tbb::parallel_for(std::size_t{0}, scores.size(), [&](std::size_t k) {
    const auto& visit = plan.visits[k];
    scores[k] = scoreModes(models, {visit.tube, visit.branch.q});
  });
  return scores;
}

std::vector<double> playInTubes(const planner::Workcell& model, const planner::VisitPlan& plan) {
  std::vector<double> play;
  for (const auto& visit : plan.visits) {
    const auto& tube = model.sheet.tubes[static_cast<std::size_t>(visit.tube)];
    play.push_back(planner::playInTube(model, planner::holeCentre(tube), visit.branch.approach));
  }
  return play;
}

double paddingAtHoles(const planner::Workcell& model, const planner::VisitPlan& plan, double sigmas) {
  const planner::BasePadding padding(model, sigmas);
  double most = 0;
  for (const auto& visit : plan.visits)
    most = std::max(
        most, padding.of({visit.branch.predicted_tip_W, visit.branch.predicted_tip_W, 0}, planner::tipRow(model.arm)));
  return most;
}

}  // namespace tubeplan::app
