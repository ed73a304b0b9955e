#include "app/step_score.hpp"

namespace tubeplan::app {

ScoringModels scoringModels(const planner::Workcell& model, const std::optional<BothCalibrations>& bases,
                            const planner::Workcell& truth) {
  ScoringModels models{bases ? withBase(model, bases->flexible) : model, bases ? withBase(model, bases->rigid) : model,
                       truth};
  models.rigid.arm = deflection::rigidCopy(models.rigid.arm);
  return models;
}

std::optional<planner::Centring> centringAt(const PlacedModel& model, const planner::Workcell& truth,
                                            const Eigen::Vector3d& hole_W, const Eigen::VectorXd& q_start,
                                            const Eigen::Vector3d& tip_error_W) {
  const deflection::ToolGoal goal{model.X_WB.inverse() * hole_W,
                                  model.X_WB.linear().transpose() * planner::kHoleAxis_W};
  const auto gravity_B = deflection::gravityInBase(model.arm, model.X_WB);
  const auto found = deflection::refineBranch(model.arm, goal, truth.load, gravity_B, q_start);
  if (found.status != deflection::BranchStatus::kConverged) return std::nullopt;
  planner::TubeBranch visit;
  visit.q = found.q;
  return planner::scoreVisit(truth, hole_W, visit, tip_error_W);
}

ModeScores scoreModes(const ScoringModels& models, const TubeToScore& tube, bool with_approach) {
  ModeScores scores;
  planner::TipPrediction tips(models.truth);
  const auto hole = planner::holeCentre(models.truth.sheet.tubes.at(static_cast<std::size_t>(tube.tube)));
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
