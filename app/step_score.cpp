#include "app/step_score.hpp"

namespace tubeplan::app {

ScoringModels scoringModels(const planner::Workcell& model, const std::optional<BothCalibrations>& bases,
                            const planner::Workcell& truth) {
  ScoringModels models{bases ? withBase(model, bases->flexible) : model, bases ? withBase(model, bases->rigid) : model,
                       truth};
  models.rigid.arm = deflection::rigidCopy(models.rigid.arm);
  return models;
}

ModeScores scoreModes(const ScoringModels& models, const TubeToScore& tube, bool with_approach) {
  ModeScores scores;
  const auto hole = planner::holeCentre(models.truth.sheet.tubes.at(static_cast<std::size_t>(tube.tube)));
  planner::CompensationOptions options;
  options.with_approach = with_approach;
  for (std::size_t k = 0; k < kCompensations.size(); ++k) {
    options.mode = kCompensations[k];
    const auto& cell = options.mode == planner::Compensation::kNone ? models.rigid : models.flexible;
    const auto branch = planner::compensateFrom(cell, hole, tube.q, options);
    if (branch.status == deflection::BranchStatus::kConverged)
      scores[k] = planner::scoreVisit(models.truth, hole, branch, tube.tip_error_W);
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
