#include "app/studies/positioning/step_score.hpp"

#include "deflection/inverse/inverse_solver.hpp"

namespace tubeplan::app {

ScoringModels scoringModels(const planner::Workcell& model, const std::optional<BothCalibrations>& bases,
                            const planner::Workcell& truth) {
  ScoringModels models{bases ? withBase(model, bases->flexible) : model, bases ? withBase(model, bases->rigid) : model,
                       truth};
  if (!bases) models.rigid.arm = deflection::rigidCopy(models.rigid.arm);
  return models;
}

std::vector<std::optional<planner::Centring>> centringsAt(const PlacedModel& model, const planner::Workcell& truth,
                                                          planner::TipPrediction& true_tips,
                                                          const std::vector<HoleToScore>& holes) {
  std::vector<deflection::ToolGoal> goals;
  std::vector<Eigen::VectorXd> starts;
  for (const auto& hole : holes) {
    goals.push_back({model.X_WB.inverse() * hole.p_WH, model.X_WB.linear().transpose() * planner::kHoleAxis_W});
    starts.push_back(hole.q_start);
  }
  const auto gravity_B = deflection::gravityInBase(model.arm, model.X_WB);
  const auto found = deflection::InverseSolver(model.arm, truth.load, gravity_B).refine(goals, starts);
  std::vector<std::optional<planner::Centring>> scores(holes.size());
  planner::TubeBranch visit;
  for (std::size_t k = 0; k < holes.size(); ++k) {
    if (found[k].status != deflection::BranchStatus::kConverged) continue;
    visit.q = found[k].q;
    scores[k] = planner::scoreVisit(true_tips, truth, holes[k].p_WH, visit, holes[k].tip_error_W);
  }
  return scores;
}

ModeScores scoreModes(const ScoringModels& models, const TubeToScore& tube, bool with_approach) {
  ModeScores scores;
  planner::TipPrediction tips(models.truth);
  const auto hole = planner::visitPlace(models.truth, models.truth.sheet.tubes.at(static_cast<std::size_t>(tube.tube)));
  planner::CompensationOptions options;
  options.with_approach = with_approach;
  for (std::size_t k = 0; k < kCompensations.size(); ++k) {
    options.mode = kCompensations[k];
    const auto& cell = options.mode == planner::Compensation::kNone ? models.rigid : models.flexible;
    const auto branch = planner::compensateFrom(cell, hole, tube.q, options);
    if (branch.status == deflection::BranchStatus::kConverged)
      scores[k] = planner::scoreVisit(tips, models.truth, hole, branch, tube.tip_error_W);
  }
  return scores;
}

std::array<std::vector<int>, kCompensations.size()> countByMode(const std::vector<ModeScores>& scores, int steps) {
  std::array<std::vector<int>, kCompensations.size()> counts;
  for (std::size_t mode = 0; mode < counts.size(); ++mode) {
    std::vector<planner::Centring> of_mode;
    for (const auto& score : scores)
      if (score[mode]) of_mode.push_back(*score[mode]);
    counts[mode] = planner::countSteps(of_mode, steps);
  }
  return counts;
}

}  // namespace tubeplan::app
