// What a campaign of centring is asked for, checked and in internal units.
#pragma once

#include "app/commands/campaign/campaign.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "app/studies/monte_carlo/centring_trial.hpp"

namespace tubeplan::app {

struct CentringTask {
  Cell cell;
  planner::Workcell model, truth;
  CentringHoles holes;
  int tubes = 0;  ///< asked for; those out of reach are not among the holes
  CentringOptions options;
};

/// Reads the cells, finds which holes are in reach, draws up the settings. Throws InputError.
[[nodiscard]] CentringTask centringTask(const CampaignRequest& request);

/// All that figures depend on but the number of runs.
[[nodiscard]] PlanKey centringKey(const CentringTask& task, const CampaignRequest& request);

}  // namespace tubeplan::app
