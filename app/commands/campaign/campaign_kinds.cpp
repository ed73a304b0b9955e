#include <array>

#include "app/commands/campaign/campaign.hpp"

namespace tubeplan::app {

namespace {

constexpr std::array kCampaignKinds{
    CampaignKind{
        "centre",
        "each run draws a true arm, touches holes, calibrates and visits others: distribution of the centring error",
        makeCentringCampaign},
    CampaignKind{"diagnose",
                 "each run simulates readings of an arm with a random hidden effect, or none: how often it is found",
                 makeDiagnosisCampaign},
    CampaignKind{
        "outage",
        "each run calibrates a true arm and visits holes, with a hidden change at some visit, or none: how soon "
        "the watch finds it",
        makeOutageCampaign}};

}  // namespace

std::span<const CampaignKind> campaignKinds() { return kCampaignKinds; }

}  // namespace tubeplan::app
