// Check that a simulated campaign's true arm is clear of the cell's scene.
#pragma once

#include "app/studies/cell_model.hpp"
#include "calibration/simulation/campaign_truth.hpp"
#include "calibration/simulation/simulated_campaign.hpp"

namespace tubeplan::app {

/// Returns a check by the planner, for the deflected true arm at its true base in each set-up; with `touches_holes` the
/// tool may be in the sheet. Empty if the cell has no bodies that could touch anything. Not safe from several threads
/// at once.
[[nodiscard]] calibration::CampaignClearance clearanceOf(const CellModel& cell, const calibration::CampaignTruth& truth,
                                                         bool touches_holes);

}  // namespace tubeplan::app
