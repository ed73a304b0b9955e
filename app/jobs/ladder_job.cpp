#include "app/jobs/ladder_job.hpp"

#include "app/documents/model_comparison_json.hpp"
#include "app/report/diagnosis_report.hpp"
#include "app/version.hpp"

namespace tubeplan::app {

Cell rigidOf(Cell cell) {
  cell.arm = deflection::rigidCopy(cell.arm);
  cell.identify.clear();
  return cell;
}

LadderOutcome climbLadder(const std::vector<LadderModel>& models, const LadderStepOptions& options,
                          const WorkHooks& hooks) {
  LadderOutcome outcome;
  std::vector<Cell> cells;
  for (const auto& [name, input, fit] : models) {
    beginStep(hooks, "ladder: " + name, cells.size(), models.size());
    const bool is_made = fit && fit->status != calibration::IdentificationStatus::kNotRun;
    outcome.comparison.push_back(
        is_made ? comparisonRowOf(name, *fit)
                : comparisonRowOf(name, input.cell, input.readings, options.seed, calibration::withoutProgress(hooks)));
    cells.push_back(input.cell);
  }
  outcome.steps = addSteps(options, cells, outcome.comparison, within(hooks, "ladder"));
  const Units& units = cells.front().units;
  outcome.figures = modelComparisonJson(outcome.comparison, units);
  outcome.figures["step_table"] = ladderStepsJson(outcome.steps, options, units);
  return outcome;
}

std::string ladderPage(const nlohmann::json& figures, const std::string& measurements, std::uint64_t seed) {
  nlohmann::json page = {
      {"title", "Ladder of models"}, {"measurements", measurements}, {"seed", seed},
      {"version", kVersion},         {"units", figures["units"]},    {"models", nlohmann::json::array()}};
  for (const auto& compared : figures["rungs"]) {
    page["noise_floor"] = compared["rms"]["noise_floor"];
    page["models"].push_back({{"name", compared["name"]},
                              {"rms", compared["rms"]["fitted"]},
                              {"heldout_rms", compared["rms"]["heldout"]},
                              {"chi2_per_dof", compared["chi2_per_dof"]},
                              {"numbers", compared["fitted_numbers"]}});
    if (compared.contains("steps") && compared["steps"].is_object())
      page["models"].back()["steps"] = compared["steps"]["counts"];
  }
  page["step_table"] = figures["step_table"];
  return renderLadderReport(page);
}

}  // namespace tubeplan::app
