// Simulated measurement campaigns of a true arm, for practice with a known truth.
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
  /// Points that were touched or measured, in order, each once; empty for other readings.
  std::vector<CampaignPoint> points;
};

/// Simulates the readings of the true arm by design and options. Each point or posture is drawn until the arm reaches
/// it under every load, within its limits, with the tip within the region and clear of the scene; then the noise of
/// coordinates and encoders is added. The arm, and the base of each set-up, are the truth's. Refused: a design with
/// problems (findDesignProblem()), one at holes without holes, other set-ups than the truth has.
[[nodiscard]] SimulatedCampaign simulateCampaign(const CampaignTruth& truth, const CampaignDesign& design,
                                                 const CampaignOptions& options, const CampaignHooks& hooks = {});

}  // namespace tubeplan::calibration
