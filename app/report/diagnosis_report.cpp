#include "app/report/diagnosis_report.hpp"

#include "app/report/page.hpp"

namespace tubeplan::app {

namespace {

/// One page's sources show all these kinds; the document says which.
std::string renderKind(const nlohmann::json& report, const char* kind) {
  nlohmann::json document = report.is_object() ? report : nlohmann::json::object();
  document["page"] = kind;
  return renderPage(diagnosisPageSources(), document);
}

}  // namespace

std::string renderDiagnosisReport(const nlohmann::json& report) { return renderKind(report, "diagnosis"); }

std::string renderComparisonReport(const nlohmann::json& report) { return renderKind(report, "comparison"); }

std::string renderProjectReport(const nlohmann::json& report) { return renderKind(report, "project"); }

std::string renderImprovementReport(const nlohmann::json& report) { return renderKind(report, "improvement"); }

std::string renderLadderReport(const nlohmann::json& report) { return renderKind(report, "ladder"); }

}  // namespace tubeplan::app
