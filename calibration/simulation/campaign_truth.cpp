#include "calibration/simulation/campaign_truth.hpp"

#include <cmath>

#include "calibration/placed_arm.hpp"
#include "calibration/simulation/campaign_random.hpp"

namespace tubeplan::calibration {

CampaignTruth drawTruth(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, const TruthOptions& options) {
  CampaignRandom random(options.seed, CampaignRandom::Stream::kTruth);
  CampaignTruth truth{arm, {}};
  for (const auto& parameter : options.parameters)
    if (deflection::isStiffness(parameter.quantity))
      deflection::locate(truth.arm, parameter.path) *= std::exp(random.normal(options.spread));
  for (int k = 0; k < options.setups; ++k) {
    BaseStep step;
    step << random.vector(options.base_shift_sigma), random.vector(options.base_turn_sigma);
    truth.bases.push_back({options.setups > 1 ? "S" + std::to_string(k + 1) : "", moved(X_WB, step)});
  }
  return truth;
}

}  // namespace tubeplan::calibration
