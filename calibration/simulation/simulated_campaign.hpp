// Simulated measurement campaigns with a true arm, for practising calibration with a known truth.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "calibration/simulation/campaign_design.hpp"
#include "calibration/simulation/campaign_options.hpp"
#include "calibration/simulation/campaign_truth.hpp"

namespace tubeplan::calibration {

struct CampaignHooks {
  std::function<void(std::size_t done, std::size_t total)> progress;
  std::function<bool()> stop;
};

enum class CampaignStatus { kNotRun, kDone, kRefused, kOutOfReach, kStopped };

struct SimulatedCampaign {
  CampaignStatus status = CampaignStatus::kNotRun;
  std::string reason;
  std::vector<Measurement> measurements;
  /// Touched or measured points in order, each once; empty for kinds that measure no point.
  std::vector<CampaignPoint> points;
};

/// Simulates the measurements of the true arm according to design and options. Each point or posture is drawn again
/// until the arm reaches it under every load, within joint limits, with the tip within the region and clear of the
/// scene. Then noise of coordinates and encoders is added. The arm and the base of each set-up are taken from the
/// truth. Refuses designs with problems (findDesignProblem()), designs at holes if the options list no holes, and
/// designs whose number of set-ups differs from the truth's.
[[nodiscard]] SimulatedCampaign simulateCampaign(const CampaignTruth& truth, const CampaignDesign& design,
                                                 const CampaignOptions& options, const CampaignHooks& hooks = {});

}  // namespace tubeplan::calibration
