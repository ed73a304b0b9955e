#include "app/report/plan_report.hpp"

#include "app/report/page.hpp"

namespace tubeplan::app {

std::string renderPlanReport(const nlohmann::json& report) {
  return renderPage({"plan", "Plan report", "plan.json"}, report);
}

}  // namespace tubeplan::app
