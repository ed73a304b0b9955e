#include "app/documents/diagnosis_pages.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/documents/diagnosis_json.hpp"
#include "app/documents/diagnosis_views_json.hpp"
#include "app/documents/improvement_json.hpp"
#include "app/documents/ladder_json.hpp"
#include "app/documents/leverage_json.hpp"
#include "app/documents/moments_json.hpp"
#include "app/report/diagnosis_report.hpp"
#include "app/storage/origin.hpp"

namespace tubeplan::app {

namespace {

/// Adds the joints, and copies the tip position after the refit and the errors before and after it to the keys that the
/// page reads.
void addPictures(const Cell& cell, nlohmann::json& json) {
  json["joints"] = jointsJson(cell.arm, cell.units);
  for (auto& measurement : json["readings"]) {
    measurement["position"] = measurement["position_after"];
    measurement["before"] = measurement["error_before"];
    measurement["after"] = measurement["error_after"];
  }
}

/// Returns the names of all joints, and of the row axes on which the found effects act.
std::vector<std::string> leverNames(const deflection::Arm& arm, const nlohmann::json& page) {
  std::vector<std::string> names = deflection::jointNames(arm);
  for (const auto& explanation : page.value("explanations", nlohmann::json::array()))
    for (const auto& effect : explanation.at("effects"))
      if (const auto at = effect.at("at").get<std::string>();
          isAxisOfRow(arm, at) && std::find(names.begin(), names.end(), at) == names.end())
        names.push_back(at);
  return names;
}

/// Adds, for the measurements that the page draws, the moments and the leverages that convert a tip error into a joint
/// error.
void addLevers(const Cell& cell, const std::vector<calibration::Measurement>& measurements, nlohmann::json& page) {
  std::set<std::string> drawn;
  for (const auto& measurement : page.at("readings")) drawn.insert(measurement.at("id").get<std::string>());
  std::vector<calibration::Measurement> some;
  std::copy_if(measurements.begin(), measurements.end(), std::back_inserter(some),
               [&](const auto& measurement) { return drawn.contains(measurement.id); });
  if (some.empty()) return;
  page["leverage"] = leverageJson(cell, some, leverNames(cell.arm, page));
  page["moments"] = momentsJson(cell, some);
}

/// Returns the results with the data that the head of the page shows.
nlohmann::json pageOf(const std::string& what, const CellMeasurements& input, std::uint64_t seed,
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

std::string comparisonPage(const CellMeasurements& input, std::uint64_t seed, const nlohmann::json& figures) {
  nlohmann::json page = pageOf("Comparison", input, seed, figures);
  addPictures(input.cell, page);
  addLevers(input.cell, input.measurements, page);
  return renderComparisonReport(page);
}

std::string diagnosisPage(const CellMeasurements& input, std::uint64_t seed, const nlohmann::json& figures,
                          const nlohmann::json& tested) {
  nlohmann::json page = pageOf("Diagnosis", input, seed, figures);
  page["tested"] = tested;
  addLevers(input.cell, input.measurements, page);
  return renderDiagnosisReport(page);
}

namespace {

/// Returns the diagnosis of a step with the data that its plots need.
nlohmann::json stepPictures(const CellMeasurements& input, const ImprovementStep& step, const CellModel& model) {
  nlohmann::json figures = diagnosisJson(step.diagnosis, input.measurements, input.cell.units);
  for (const char* name : {"ranking", "detectable", "closest", "added_variable", "not_tried", "ladder"})
    figures.erase(name);
  Cell cell = input.cell;
  static_cast<CellModel&>(cell) = model;
  addLevers(cell, input.measurements, figures);
  return figures;
}

}  // namespace

std::string improvementPage(const CellMeasurements& input, std::uint64_t seed, const Improvement& result) {
  nlohmann::json page =
      pageOf("Improvement", input, seed, improvementJson(result, input.measurements, input.cell.units));
  const nlohmann::json compared = page["models"];
  page["models"] = ladderModels(compared);
  if (!compared.empty()) {
    const auto& first = compared.front()["rms"];
    page["rms"] = {{"noise_floor", first["noise_floor"]},
                   {"heldout_before", first["heldout"]},
                   {"heldout_after", compared.back()["rms"]["heldout"]}};
  }
  for (std::size_t k = 0; k < result.steps.size() && !result.models.empty(); ++k)
    page["steps"][k]["figures"] =
        stepPictures(input, result.steps[k], result.models[std::min(k, result.models.size() - 1)].cell);
  return renderImprovementReport(page);
}

}  // namespace tubeplan::app
