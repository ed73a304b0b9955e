// Validated request for a centring campaign, in internal units.
#pragma once

#include "app/commands/campaign/campaign.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "app/studies/monte_carlo/centring_trial.hpp"

namespace tubeplan::app {

struct CentringTask {
  Cell cell;
  planner::Workcell model, truth;
  CentringHoles holes;
  int tubes = 0;  ///< number of requested tubes, including those out of reach
  CentringOptions options;
};

/// Choice of the holes that the runs of a kind of campaign visit.
struct VisitedHoles {
  std::size_t tubes = 80;          ///< number of tubes spread over the sheet if the request names none
  const char* option = "--holes";  ///< option with the number of holes that a run visits
  int least = 1, most = 1000;      ///< limits of this number
};

/// Reads the cells, finds the holes within reach and lists the settings. Throws InputError for bad input.
[[nodiscard]] CentringTask centringTask(const CampaignRequest& request, const VisitedHoles& visited = {});

/// Returns a key made of everything that affects the results, except the number of runs.
[[nodiscard]] PlanKey centringKey(const CentringTask& task, const CampaignRequest& request);

}  // namespace tubeplan::app
