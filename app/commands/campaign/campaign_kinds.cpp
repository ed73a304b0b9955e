#include <array>

#include "app/commands/campaign/campaign.hpp"

namespace tubeplan::app {

namespace {

constexpr std::array kCampaignKinds{
    CampaignKind{"centre", "a true arm is drawn, touches holes, is calibrated and visits others: how well tools centre",
                 makeCentringCampaign},
    CampaignKind{"diagnose", "readings of an arm that hides a random effect, or none: how often it is found",
                 makeDiagnosisCampaign}};

}  // namespace

std::span<const CampaignKind> campaignKinds() { return kCampaignKinds; }

}  // namespace tubeplan::app
