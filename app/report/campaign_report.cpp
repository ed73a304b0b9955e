#include "app/report/campaign_report.hpp"

#include "app/report/page.hpp"

namespace tubeplan::app {

std::string renderCampaignReport(const nlohmann::json& report) {
  return renderPage({"campaign", "Campaign", "campaign.json"}, report);
}

}  // namespace tubeplan::app
