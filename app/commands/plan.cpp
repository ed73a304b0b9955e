// `tubeplan plan`: plans a tour that brings the tool to the tubes of a cell, and writes the plan's files.
#include "app/jobs/plan.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/browser.hpp"
#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/calibration_json.hpp"
#include "app/documents/plan_files.hpp"
#include "app/documents/plan_text.hpp"
#include "app/documents/trajectory_yaml.hpp"
#include "app/storage/count_text.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

struct PlanOptions {
  PlanRequest request;
  std::string out, from;
  FiguresTarget figures;
  bool resume = false, trajectory = false, open = false;
};

int explainStop(PlanCheckpoint& checkpoint, const OutputFolder& folder) {
  const std::string summary = checkpoint.summary();
  if (summary.empty()) {
    remark("stopped before anything was planned\n");
    return kStoppedExitCode;
  }
  checkpoint.save();
  remark("stopped; {} are kept in {}: the same command continues from there\n", summary,
         (folder.path() / kProgressFile).string());
  return kStoppedExitCode;
}

int explain(const PlanOutcome& outcome) {
  const auto& plan = outcome.plan;
  if (outcome.calibration && outcome.calibration->flexible.status != calibration::CalibrationStatus::kDone)
    remark("{}", calibrationText(outcome.calibration->flexible, outcome.cell));
  else
    remark("no plan: {}\n", plan.reason);
  constexpr std::size_t kShown = 5;
  if (plan.unreachable.size() > kShown) remark("{} tubes, among them\n", plan.unreachable.size());
  for (std::size_t k = 0; k < std::min(kShown, plan.unreachable.size()); ++k) {
    const auto& missed = plan.unreachable[k];
    const auto& tube = outcome.model.sheet.tubes[static_cast<std::size_t>(missed.tube)];
    remark("  {} {}\n", tubesheets::tubeName(tube.row, tube.column), missed.reason);
  }
  return kNegativeAnswer;
}

std::string keptText(const std::string& from, const PlanOutcome& outcome) {
  return fmt::format("reused from {}: {}; {} added, {} removed\n", from, reusedText(outcome),
                     countText(static_cast<std::size_t>(outcome.tubes_added), "tube"), outcome.tubes_removed);
}

/// Throws InputError for an output folder in which the plan would overwrite one of its input files.
void requireOtherNames(const PlanOptions& options) {
  const auto& request = options.request;
  for (const auto& input : {request.cell, request.touches, request.tubes, request.truth}) {
    const std::filesystem::path file(input);
    const auto written = std::filesystem::path(options.out) / file.filename();
    std::error_code none;
    const bool is_output = std::ranges::find(kPlanFiles, file.filename().string()) != std::end(kPlanFiles);
    if (is_output && std::filesystem::equivalent(file, written, none))
      throw InputError::problem("--out", "this command reads " + written.string() + ", which would be overwritten",
                                "choose another folder");
  }
}

int run(const PlanOptions& options) {
  requireOtherNames(options);
  if (options.trajectory) requireAccelerations(readCell(options.request.cell).arm);
  checkFigures(options.figures);
  noteStopSignals();  // installed before the first folder is created, so that a stop removes the folder
  OutputFolder folder(options.out, "--out");
  std::vector<std::string> names(std::begin(kPlanFiles), std::end(kPlanFiles));
  // Without touches, no touches.csv is written, so an existing touches.csv of the user is not overwritten.
  if (options.request.touches.empty()) std::erase(names, "touches.csv");
  folder.requireOwn({"plan.json", kProgressFile}, names);
  PlanCheckpoint checkpoint(folder.path(), options.resume, options.from);
  const PlanOutcome outcome = runPlanJob(options.request, terminalHooks(), checkpoint);
  if (outcome.plan.status == planner::VisitPlanStatus::kStopped) return explainStop(checkpoint, folder);
  if (outcome.plan.status != planner::VisitPlanStatus::kPlanned) {
    // If the touches were refused, nothing was planned; keep the checkpoint of an earlier run.
    if (outcome.plan.status != planner::VisitPlanStatus::kNotRun) checkpoint.discard();
    return explain(outcome);
  }
  folder.write(kCacheFile, checkpoint.text());
  folder.remove(kProgressFile);
  if (options.trajectory)
    folder.write(kTrajectoryFile, trajectoryYaml(outcome));
  else
    folder.remove(kTrajectoryFile);
  writePlan(options.request, outcome, folder);
  if (wantsFigures(options.figures)) writeFigures(options.figures, planFileJson(options.request, outcome));
  if (printsText(options.figures))
    output("{}{}wrote {}\n", planText(options.request, outcome),
           options.from.empty() ? "" : keptText(options.from, outcome),
           (folder.path() / "{plan.json,path.csv,cell.yaml,report.html,worklist.csv}").string());
  if (options.open) openInBrowser(std::filesystem::absolute(folder.path() / "report.html").string());
  return kDone;
}

}  // namespace

Run configurePlan(CLI::App& cli) {
  const auto options = std::make_shared<PlanOptions>();
  auto& request = options->request;
  addCell(cli, request.cell);
  cli.add_option("--tubes", request.tubes,
                 "tubes: all, R10C20, R1-10C5-9, outer:2, every:10, spread:60, or a CSV work list; plugged, "
                 "stabilised, inaccessible and unresolved ones only by state or by name: all,plugged")
      ->capture_default_str();
  addListColumns(cli, request.conditions.columns);
  cli.add_option("--touches", request.touches,
                 "touched holes (CSV) to calibrate the base with, or auto: the true arm touches three");
  cli.add_option("--truth", request.truth, "cell of the true arm, for simulated touches and for the score");
  cli.add_option("--compensation", request.compensation, "none, goal-point or via-point")->capture_default_str();
  cli.add_option("--travel", request.travel,
                 "joints: the quickest way from tube to tube; line: the tip straight from standoff to standoff, as a "
                 "camera is moved along a row, where that is possible without collision")
      ->capture_default_str();
  cli.add_option("--load", request.load, "load hung on the tip, in the cell's unit of force")->type_name("FORCE");
  auto& conditions = request.conditions;
  cli.add_option("--start", conditions.start,
                 "the posture to start from: `park` (the cell's), joint readings, --start=A,B,..., or with --from the "
                 "tube at which the arm is; from a hole the tool first moves straight down")
      ->type_name("POSTURE");
  cli.add_option("--end", conditions.end, "the posture to end in: `park` or joint readings")->type_name("POSTURE");
  cli.add_option("--first", conditions.first,
                 "tubes to visit before all others, as for --tubes; repeat for the next zone");
  cli.add_option("--dwell", conditions.dwell,
                 "dwell time at each hole in seconds, unless a work list's dwell_s says otherwise")
      ->capture_default_str();
  cli.add_option(
         "--padding", request.padding,
         "extra clearance, in standard deviations of the position of each body under the uncertainty of base and arm")
      ->capture_default_str();
  cli.add_option(
         "--standoff", request.standoff,
         "distance below a hole at which its approach begins, in the cell's unit of length (1 in; padding is added)")
      ->type_name("LENGTH");
  cli.add_flag("--least-standoff", request.has_least_standoff,
               "use at each hole the smallest standoff without collision, up to that of --standoff");
  cli.add_option("--insertion", request.insertion,
                 "insertion depth of the tip past a hole's face, in the cell's unit of length")
      ->type_name("LENGTH")
      ->capture_default_str();
  addSeed(cli, request.seed, "seed of the random numbers");
  cli.add_option("--out", options->out, "the folder for plan.json, path.csv, cell.yaml, worklist.csv and report.html")
      ->type_name("FOLDER")
      ->required();
  cli.add_flag("--resume", options->resume,
               "continue the plan that was stopped in the folder; refuse if its options differ");
  cli.add_option("--from", options->from,
                 "the folder of an earlier plan: reuse what is still valid of it and plan the rest anew");
  cli.add_flag("--open", options->open, "open the report in a browser");
  cli.add_flag("--trajectory", options->trajectory, "also write trajectory.yaml, a ROS 2 JointTrajectory");
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
