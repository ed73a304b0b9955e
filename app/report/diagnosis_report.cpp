#include "app/report/diagnosis_report.hpp"

#include "app/report/page.hpp"

namespace tubeplan::app {

namespace {

constexpr std::string_view kFigures = "what --json writes";

}  // namespace

std::string renderDiagnosisReport(const nlohmann::json& report) {
  return renderPage({"diagnosis", "Diagnosis", kFigures}, report);
}

std::string renderComparisonReport(const nlohmann::json& report) {
  return renderPage({"comparison", "Model and readings", kFigures}, report);
}

std::string renderProjectReport(const nlohmann::json& report) {
  return renderPage({"project", "Project", kFigures}, report);
}

std::string renderImprovementReport(const nlohmann::json& report) {
  return renderPage({"improvement", "Improvement", kFigures}, report);
}

std::string renderLadderReport(const nlohmann::json& report) {
  return renderPage({"ladder", "Comparison of models", kFigures}, report);
}

}  // namespace tubeplan::app
