#include "app/documents/ladder_json.hpp"

#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/documents/model_comparison_json.hpp"
#include "app/report/diagnosis_report.hpp"
#include "app/storage/origin.hpp"

namespace tubeplan::app {

namespace {

nlohmann::json ladderStepsJson(const LadderSteps& steps, std::uint64_t seed, const Units& units) {
  if (!steps.reason.empty()) return {{"reason", steps.reason}};
  return {{"real_arm", steps.real.name},
          {"unmodelled_sigma", lengthOf(steps.real.unmodelled, units)},
          {"holes", steps.holes},
          {"out_of_reach", steps.out_of_reach},
          {"seed", seed}};
}

constexpr TextLine kTrueArmWords[] = {
    {"step_table/reason", "no step table: {}\n"},
    {"step_table/real_arm", "true arm: {}"},
    {"+step_table/unmodelled_sigma", " (sigma {:.3r units/length} per coordinate)"},
    {"step_table/real_arm", "; {holes} random holes within its reach ({out_of_reach} drawn beyond it)\n"},
    {"set_aside", kSetAsideWords, {}, {}, 1}};

}  // namespace

nlohmann::json ladderJson(const std::vector<ModelComparisonRow>& comparison, const LadderSteps& steps,
                          const std::vector<std::string>& set_aside, std::uint64_t seed, const Units& units) {
  nlohmann::json figures = modelComparisonJson(comparison, set_aside.size(), units);
  figures["sentence"] = modelComparisonSentence(comparison, units);
  figures["set_aside"] = set_aside;
  figures["step_table"] = ladderStepsJson(steps, seed, units);
  return figures;
}

std::string ladderText(const nlohmann::json& figures) {
  return textOf(figures, "{sentence}\n") + modelComparisonText(figures) + textOf(figures, kTrueArmWords);
}

nlohmann::json ladderModels(const nlohmann::json& compared_models) {
  nlohmann::json models = nlohmann::json::array();
  for (const auto& compared : compared_models) {
    models.push_back({{"name", compared["name"]},
                      {"rms", compared["rms"]["fitted"]},
                      {"heldout_rms", compared["rms"]["heldout"]},
                      {"chi2_per_dof", compared["chi2_per_dof"]},
                      {"p_value", compared["p_value"]},
                      {"numbers", compared["fitted_numbers"]}});
    if (compared.contains("steps") && compared["steps"].is_object())
      models.back()["steps"] = compared["steps"]["counts"];
  }
  return models;
}

std::string ladderPage(const nlohmann::json& figures, const std::string& measurements, std::uint64_t seed) {
  nlohmann::json page = {{"title", "Comparison of models"},
                         {"measurements", measurements},
                         {"seed", seed},
                         {"units", figures["units"]},
                         {"sentence", figures["sentence"]},
                         {"error_unit", figures["error_unit"]},
                         {"error_budget", figures["error_budget"]},
                         {"set_aside", figures["set_aside"]},
                         {"models", ladderModels(figures["models"])}};
  for (const auto& compared : figures["models"]) page["noise_floor"] = compared["rms"]["noise_floor"];
  page["step_table"] = figures["step_table"];
  stateOrigin(page);
  return renderLadderReport(page);
}

}  // namespace tubeplan::app
