// Check that the true arm of a simulated campaign is clear of the cell's scene.
#pragma once

#include "app/studies/cell_model.hpp"
#include "calibration/simulation/campaign_truth.hpp"
#include "calibration/simulation/simulated_campaign.hpp"

namespace tubeplan::app {

/// Returns a function that returns true if the deflected true arm, on its true base in a given set-up, is clear of the
/// scene in a posture. With `touches_holes` the tool may enter the sheet. The function is empty if the scene has no
/// bodies, and is not thread-safe.
[[nodiscard]] calibration::CampaignClearance clearanceOf(const CellModel& cell, const calibration::CampaignTruth& truth,
                                                         bool touches_holes);

}  // namespace tubeplan::app
