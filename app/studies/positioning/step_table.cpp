#include "app/studies/positioning/step_table.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "calibration/simulation/campaign_random.hpp"
#include "planner/reach/scoring.hpp"

namespace tubeplan::app {

namespace {

using calibration::CampaignRandom;
using deflection::BranchStatus;
using Eigen::VectorXd;

constexpr std::size_t kBatch = 256;  // number of holes tried at once

Eigen::Vector3d placeOf(const planner::Workcell& cell, int tube) {
  return planner::holeCentre(cell.sheet.tubes[static_cast<std::size_t>(tube)]);
}

planner::CompensationOptions atTheHole() {
  planner::CompensationOptions options;
  options.mode = planner::Compensation::kGoalPoint;
  options.with_approach = false;
  return options;
}

std::vector<int> openTubes(const tubesheets::Sheet& sheet) {
  std::vector<int> open;
  for (std::size_t k = 0; k < sheet.tubes.size(); ++k)
    if (sheet.tubes[k].state == tubesheets::TubeState::kOpen) open.push_back(static_cast<int>(k));
  return open;
}

/// Returns a posture of the arm under each tube; an empty vector for a tube out of reach.
std::vector<VectorXd> posturesUnder(const planner::Workcell& cell, const std::vector<int>& tubes,
                                    const calibration::StopQuestion& stop) {
  std::vector<VectorXd> postures(tubes.size());
  oneapi::tbb::parallel_for(std::size_t{0}, tubes.size(), [&](std::size_t k) {
    if (calibration::shouldStop(stop)) return;
    const auto branches = planner::compensate(cell, placeOf(cell, tubes[k]), atTheHole());
    if (!branches.empty() && branches.front().status == BranchStatus::kConverged) postures[k] = branches.front().q;
  });
  return postures;
}

}  // namespace

StepHoles drawStepHoles(const RealArm& real, int count, std::uint64_t seed, const calibration::StopQuestion& stop) {
  CampaignRandom order(seed, CampaignRandom::Stream::kPostures), errors(seed, CampaignRandom::Stream::kNoise);
  std::vector<int> open = openTubes(real.cell.sheet);
  order.shuffle(open);
  StepHoles drawn;
  for (std::size_t from = 0; from < open.size(); from += kBatch) {
    const auto begin = open.begin() + static_cast<std::ptrdiff_t>(from);
    const std::vector<int> batch(begin, begin + static_cast<std::ptrdiff_t>(std::min(kBatch, open.size() - from)));
    const auto postures = posturesUnder(real.cell, batch, stop);
    for (std::size_t k = 0; k < batch.size(); ++k) {
      if (static_cast<int>(drawn.holes.size()) == count) return drawn;
      if (postures[k].size() == 0)
        ++drawn.out_of_reach;
      else
        drawn.holes.push_back({batch[k], postures[k], errors.vector(real.unmodelled)});
    }
  }
  return drawn;
}

StepTable stepTableOf(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const RealArm& real,
                      const StepHoles& drawn, const calibration::StopQuestion& stop) {
  planner::Workcell model;
  model.arm = arm;
  model.arm.tool_axis_L = real.cell.arm.tool_axis_L;
  model.X_WB = X_WB;
  model.load = real.cell.load;
  std::vector<planner::Centring> scores(drawn.holes.size());
  oneapi::tbb::parallel_for(std::size_t{0}, scores.size(), [&](std::size_t k) {
    if (calibration::shouldStop(stop)) return;
    const StepHole& hole = drawn.holes[k];
    const auto centre = placeOf(real.cell, hole.tube);
    const auto branch = planner::compensateFrom(model, centre, hole.q, atTheHole());
    if (branch.status == BranchStatus::kConverged)
      scores[k] = planner::scoreVisit(real.cell, centre, branch, hole.tip_error_W);
  });
  StepTable table;
  table.holes = static_cast<int>(scores.size());
  table.counts = planner::countSteps(scores, static_cast<int>(real.cell.tool.steps.size()));
  table.no_posture = static_cast<int>(
      std::count_if(scores.begin(), scores.end(), [](const planner::Centring& score) { return score.steps < 0; }));
  table.counts.front() += table.no_posture;
  std::vector<double> errors;
  for (const auto& score : scores)
    if (score.steps >= 0) errors.push_back(score.error);
  std::sort(errors.begin(), errors.end());
  if (errors.empty()) return table;
  table.median_error = errors[errors.size() / 2];
  table.p95_error = errors[std::min(errors.size() - 1, errors.size() * 95 / 100)];
  return table;
}

}  // namespace tubeplan::app
