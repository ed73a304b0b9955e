#include "app/studies/measurements/campaign_clearance.hpp"

#include <map>
#include <memory>
#include <utility>

#include "planner/collision/arm_clearance.hpp"

namespace tubeplan::app {

namespace {

/// A workcell in one set-up under one load, with its clearance check.
struct LoadedCell {
  explicit LoadedCell(planner::Workcell loaded) : cell(std::move(loaded)), clearance(cell) {}
  planner::Workcell cell;
  planner::ArmClearance clearance;  ///< refers to `cell`
};

planner::Workcell workcellUnder(const CellModel& cell, const calibration::CampaignTruth& truth, int setup,
                                double load) {
  planner::Workcell work;
  work.arm = truth.arm;
  work.X_WB = truth.bases.at(static_cast<std::size_t>(setup)).X_WB;
  work.scene = cell.scene;
  work.load = load;
  return work;
}

}  // namespace

calibration::CampaignClearance clearanceOf(const CellModel& cell, const calibration::CampaignTruth& truth,
                                           bool touches_holes) {
  if (cell.scene.bodies.empty()) return {};
  const auto rule = touches_holes ? planner::ContactRule::kApproach : planner::ContactRule::kTravel;
  using Cells = std::map<std::pair<int, double>, std::unique_ptr<LoadedCell>>;
  return [&cell, &truth, rule, made = std::make_shared<Cells>()](int setup, double load, const Eigen::VectorXd& q) {
    auto& loaded = (*made)[{setup, load}];
    if (!loaded) loaded = std::make_unique<LoadedCell>(workcellUnder(cell, truth, setup, load));
    return loaded->clearance.at(q, rule).margin >= 0;
  };
}

}  // namespace tubeplan::app
