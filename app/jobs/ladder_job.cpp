#include "app/jobs/ladder_job.hpp"

#include "app/documents/ladder_json.hpp"
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
  for (const auto& [name, input] : models) {
    beginStep(hooks, "ladder: " + name, cells.size(), models.size());
    outcome.rungs.push_back(rungOf(name, input.cell, input.readings, options.seed, calibration::untold(hooks)));
    cells.push_back(input.cell);
  }
  outcome.steps = addSteps(options, cells, outcome.rungs, within(hooks, "ladder"));
  const Units& units = cells.front().units;
  outcome.figures = ladderJson(outcome.rungs, units);
  outcome.figures["step_table"] = ladderStepsJson(outcome.steps, options, units);
  return outcome;
}

std::string ladderPage(const nlohmann::json& figures, const std::string& measurements, std::uint64_t seed) {
  nlohmann::json page = {
      {"title", "Ladder of models"}, {"measurements", measurements}, {"seed", seed},
      {"version", kVersion},         {"units", figures["units"]},    {"models", nlohmann::json::array()}};
  for (const auto& rung : figures["rungs"]) {
    page["noise_floor"] = rung["rms"]["noise_floor"];
    page["models"].push_back({{"name", rung["name"]},
                              {"rms", rung["rms"]["fitted"]},
                              {"heldout_rms", rung["rms"]["heldout"]},
                              {"chi2_per_dof", rung["chi2_per_dof"]},
                              {"numbers", rung["fitted_numbers"]}});
    if (rung.contains("steps") && rung["steps"].is_object()) page["models"].back()["steps"] = rung["steps"]["counts"];
  }
  page["step_table"] = figures["step_table"];
  return renderLadderReport(page);
}

}  // namespace tubeplan::app
