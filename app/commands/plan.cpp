// tubeplan plan: the main job.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/calibration_json.hpp"
#include "app/command.hpp"
#include "app/plan_files.hpp"
#include "app/planning_hooks.hpp"
#include "app/stop_signal.hpp"

namespace tubeplan::app {

namespace {

struct PlanOptions {
  PlanRequest request;
  std::string out;
};

int explain(const PlanOutcome& outcome) {
  const auto& plan = outcome.plan;
  if (outcome.calibration && outcome.calibration->flexible.status != calibration::CalibrationStatus::kDone)
    fmt::print(stderr, "{}", calibrationText(outcome.calibration->flexible, outcome.cell.units));
  else
    fmt::print(stderr, "no plan: {}\n", plan.reason);
  constexpr std::size_t kShown = 5;
  if (plan.unreachable.size() > kShown) fmt::print(stderr, "{} tubes, among them\n", plan.unreachable.size());
  for (std::size_t k = 0; k < std::min(kShown, plan.unreachable.size()); ++k) {
    const auto& missed = plan.unreachable[k];
    const auto& tube = outcome.model.sheet.tubes[static_cast<std::size_t>(missed.tube)];
    fmt::print(stderr, "  {} {}\n", tubesheets::tubeName(tube.row, tube.column), missed.reason);
  }
  return plan.status == planner::VisitPlanStatus::kStopped ? kStoppedExitCode : kNegativeAnswer;
}

int run(const PlanOptions& options) {
  OutputFolder folder(options.out, "--out");
  const PlanOutcome outcome = runPlanJob(options.request, terminalHooks());
  if (outcome.plan.status != planner::VisitPlanStatus::kPlanned) return explain(outcome);
  writePlan(options.request, outcome, folder);
  fmt::print("{}wrote {}\n", planText(outcome),
             (folder.path() / "{plan.json,path.csv,cell.yaml,report.html}").string());
  return kDone;
}

}  // namespace

Run configurePlan(CLI::App& cli) {
  const auto options = std::make_shared<PlanOptions>();
  auto& request = options->request;
  cli.add_option("CELL", request.cell, "the cell file")->required();
  cli.add_option("--tubes", request.tubes,
                 "which tubes: all, R10C20, R1-10C5-9, outer:2, every:10, spread:60, -plugged, or a CSV work list")
      ->capture_default_str();
  cli.add_option("--touches", request.touches,
                 "touched holes (CSV) that place the base, or auto: the true arm touches three");
  cli.add_option("--truth", request.truth, "the cell of the true arm, to touch with and to score against");
  cli.add_option("--compensation", request.compensation, "none, goal-point or via-point")->capture_default_str();
  cli.add_option("--load", request.load, "load hung on the tip, in the cell's unit of force");
  cli.add_option("--seed", request.seed, "of everything random")->check(CLI::NonNegativeNumber)->capture_default_str();
  cli.add_option("--out", options->out, "the folder for plan.json, path.csv, cell.yaml and report.html")->required();
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
