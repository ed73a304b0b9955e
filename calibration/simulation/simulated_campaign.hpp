// Measurement campaigns as a true arm would make them: to practise on, with the truth known.
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
  std::vector<Measurement> readings;
  std::vector<CampaignPoint> points;  ///< what was touched or looked at, in order, each once; empty for other readings
};

/// What the true arm reads, design and options saying where. Each point or posture is drawn until the arm reaches it
/// under every load, within its limits, the tip within the region and clear of the scene; then the noise of coordinates
/// and encoders is added. The arm itself, and the base of each set-up, are the truth's. Refused: a design with problems
/// (findDesignProblem), one at holes without holes, other set-ups than the truth has.
[[nodiscard]] SimulatedCampaign simulateCampaign(const CampaignTruth& truth, const CampaignDesign& design,
                                                 const CampaignOptions& options, const CampaignHooks& hooks = {});

}  // namespace tubeplan::calibration
