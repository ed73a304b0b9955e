#include "app/documents/diagnosis_pages.hpp"

#include <nlohmann/json.hpp>

#include "app/documents/diagnosis_views_json.hpp"
#include "app/files/origin.hpp"
#include "app/report/diagnosis_report.hpp"

namespace tubeplan::app {

namespace {

/// Errors as the page's pictures take them: measured less predicted, at the tip's place after the refit.
void addPictures(const Cell& cell, nlohmann::json& json) {
  const auto reversed = [](const nlohmann::json& error) {
    nlohmann::json turned = nlohmann::json::array();
    for (const auto& part : error) turned.push_back(part.is_number() ? nlohmann::json(-part.get<double>()) : part);
    return turned;
  };
  json["joints"] = jointsJson(cell.arm, cell.units);
  for (auto& reading : json["readings"]) {
    reading["position"] = reading["position_after"];
    reading["before"] = reversed(reading["error_before"]);
    reading["after"] = reversed(reading["error_after"]);
  }
}

/// The figures with what the page's head says.
nlohmann::json pageOf(const std::string& what, const CellReadings& input, std::uint64_t seed,
                      const nlohmann::json& figures) {
  nlohmann::json page = figures;
  page.update({{"title", what + " of " + input.cell.name},
               {"cell", input.cell.name},
               {"measurements", input.file},
               {"seed", seed}});
  stateOrigin(page);
  return page;
}

}  // namespace

std::string comparisonPage(const CellReadings& input, std::uint64_t seed, const nlohmann::json& figures) {
  nlohmann::json page = pageOf("Comparison", input, seed, figures);
  addPictures(input.cell, page);
  return renderComparisonReport(page);
}

std::string diagnosisPage(const CellReadings& input, std::uint64_t seed, const nlohmann::json& figures) {
  return renderDiagnosisReport(pageOf("Diagnosis", input, seed, figures));
}

}  // namespace tubeplan::app
