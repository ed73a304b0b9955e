#include "app/report/outage_report.hpp"

#include "app/report/page.hpp"

namespace tubeplan::app {

std::string renderHandOverReport(const nlohmann::json& report) {
  return renderPage({"hand-over", "Hand-over", "what --json writes"}, report);
}

std::string renderJobPlanReport(const nlohmann::json& report) {
  return renderPage({"job-plan", "Plan of a job", "what --json writes"}, report);
}

}  // namespace tubeplan::app
