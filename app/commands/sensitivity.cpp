// `tubeplan sensitivity`: ranks the members to stiffen or lighten and the parameters that must be known accurately
// (Calkins 1994, section 6.3).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/commands/measurement_answer.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/documents/sensitivity_report.hpp"
#include "app/formats/cell/command_inputs.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/jobs/cell_estimate.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/measurements/measurement_candidates.hpp"
#include "app/studies/measurements/simulated_calibration.hpp"
#include "app/studies/measurements/touched_holes.hpp"
#include "calibration/design/touch_choice.hpp"

namespace tubeplan::app {

namespace {

constexpr int kWorkedPostures = 60, kTouchable = 40, kChosenTouches = 3;

struct SensitivityOptions {
  std::string cell, tubes, measurements;
  FiguresTarget figures;
  std::vector<std::string> assume, columns;
  double load = 0;
  int postures = kWorkedPostures;
  std::uint64_t seed = 1;
};

/// Returns the three holes of the sheet whose touches determine the base most accurately.
BestTouches touchedHoles(const Cell& cell, const std::vector<Eigen::VectorXd>& work_postures) {
  planner::Workcell work = workcellOf(cell, "touch holes");
  work.load = 0;
  return bestTouches(work, touchCandidates(work, kTouchable), work_postures, kChosenTouches,
                     additionalUncertainty(cell));
}

/// Returns, for a cell without a sheet, the three postures in which touches of a mark determine the base most
/// accurately.
BestTouches touchedPostures(const Cell& cell, const std::vector<Eigen::VectorXd>& work_postures, std::uint64_t seed) {
  std::vector<calibration::TouchPlan> marks;
  for (const auto& q : clearPostures(armAndScene(cell), {0}, kTouchable, seed))
    marks.push_back({"", "posture " + std::to_string(marks.size() + 1), {}, q});
  const calibration::SensitivityTask usual;
  return bestTouches(cell.arm, cell.X_WB, marks, work_postures,
                     {kChosenTouches, usual.touch_sigma, additionalUncertainty(cell)});
}

/// Chooses the three touches that determine the base most accurately. If there are none, returns the reason; otherwise
/// an empty string.
std::string chooseBaseTouches(const Cell& cell, std::uint64_t seed, SensitivityReport& report,
                              calibration::SensitivityTask& task) {
  const BestTouches best = cell.sheet ? touchedHoles(cell, task.work) : touchedPostures(cell, task.work, seed);
  if (cell.sheet) task.touch_sigma = touchSigmaOf(requireTool(cell, "touch holes"));
  task.additional = additionalUncertainty(cell);
  for (const auto& plan : best.plans) {
    task.touches.push_back(plan.q_start);
    report.touches.push_back(plan.hole);
  }
  return best.reason;
}

void findSheetWork(const Cell& cell, const SensitivityOptions& options, SensitivityReport& report,
                   calibration::SensitivityTask& task) {
  planner::Workcell work = workcellOf(cell, "work at its holes");
  work.load = task.load;
  const auto selection = readTubes(tubesOrSpread(options.tubes, work.sheet, 60), work.sheet, options.columns);
  const auto& tubes = selection.tube_indices;
  for (const auto& note : listNotes(selection)) remark("note: {}\n", note);
  for (const auto& hole : reachHoles(work, tubes, false)) task.work.push_back(hole.q);
  report.work_lost = static_cast<int>(tubes.size() - task.work.size());
  task.hole_axis_W = planner::kHoleAxis_W;
}

/// Returns the posterior standard deviation of each arm parameter, in internal units; NaN for parameters that are not
/// among the unknowns.
std::vector<double> posteriorSigmas(const calibration::Estimate& estimate, const deflection::Arm& arm) {
  const auto n = estimate.information.rows();
  const Eigen::MatrixXd covariance = estimate.information.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  const auto parameters = deflection::parametersOf(arm);
  std::vector<double> sigmas(parameters.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < estimate.unknowns.size(); ++k) {
    const auto& unknown = estimate.unknowns[k];
    const auto index = static_cast<Eigen::Index>(k);
    for (std::size_t p = 0; p < parameters.size(); ++p)
      if (parameters[p].name == unknown.name)
        sigmas[p] = std::sqrt(covariance(index, index)) * unknown.typical *
                    std::abs(calibration::slopeAt(unknown, estimate.x[index]));
  }
  return sigmas;
}

int run(const SensitivityOptions& options) {
  Cell cell = readCell(options.cell);
  checkFigures(options.figures);
  if (!options.tubes.empty()) (void)requireSheet(cell, "choose --tubes");
  requireWorkList(options.columns, {options.tubes});
  SensitivityReport report;
  calibration::SensitivityTask task;
  calibration::MeasurementChecks checks;
  task.load = parseLoad(options.load, cell.units, "--load");
  if (!options.measurements.empty()) {
    const auto made = measurementsMade(options.measurements, cell, 0, options.assume);
    checks = made.checks;
    const auto estimate =
        estimateOf(cell, made.measurements, {cell.identify, !cell.base_known}, cell.path + " (identify)");
    if (!estimate.note.empty())
      throw InputError::problem(options.measurements, estimate.note, "give readings that determine the parameters");
    cell = cellAsEstimated(cell, estimate);
    report.sigmas = posteriorSigmas(estimate, cell.arm);
  }
  report.has_sheet = cell.sheet.has_value();
  if (report.has_sheet)
    findSheetWork(cell, options, report, task);
  else
    task.work = clearPostures(armAndScene(cell), {task.load}, options.postures, options.seed);
  report.work = static_cast<int>(task.work.size());
  // Reason why there is no result. Touches are not needed if the cell has no sheet and a known base.
  std::string reason;
  if (!task.work.empty() && (report.has_sheet || !cell.base_known))
    reason = chooseBaseTouches(cell, options.seed + 1, report, task);
  if (reason.empty()) report.figures = calibration::findSensitivities(cell.arm, cell.X_WB, task);
  if (reason.empty()) reason = report.figures.reason;
  if (!reason.empty()) {
    remark("no sensitivities: {}\n", reason);
    return kNegativeAnswer;
  }
  nlohmann::json json = sensitivityJson(report, cell);
  if (!options.measurements.empty()) addChecks(checks, cell.units, json);
  showFigures(options.figures, json, checksText(checks, cell.units) + sensitivityText(json));
  return answerOver(checks, true);
}

}  // namespace

Run configureSensitivity(CLI::App& cli) {
  const auto options = std::make_shared<SensitivityOptions>();
  addCell(cli, options->cell);
  cli.add_option("--tubes", options->tubes, "tubes at which the accuracy is wanted, as for plan (spread:60)");
  addListColumns(cli, options->columns);
  cli.add_option("--load", options->load, "load hung on the tip at work, in the cell's unit of force")
      ->type_name("FORCE");
  cli.add_option("--readings", options->measurements,
                 "readings (CSV) that determine the parameters listed under `identify`: errors are then those of one "
                 "standard deviation of each");
  addAssumeOption(cli, options->assume);
  cli.add_option("--postures", options->postures, "number of random postures, if there is no tube sheet")
      ->check(within(3, 10000))
      ->capture_default_str();
  addSeed(cli, options->seed, "seed of the random postures");
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
