// `tubeplan watch`: detects changes of a calibrated arm from measurements taken during operation.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/formats/units_json.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/positioning/base_standing.hpp"
#include "app/studies/positioning/step_chances.hpp"
#include "calibration/watch/change_watch.hpp"

namespace tubeplan::app {

namespace {

struct WatchRequest {
  std::string cell;
  MeasurementFiles measurement_files;
  MeasurementOptions given;
  calibration::WatchOptions options;
  FiguresTarget figures;
};

/// Throws InputError unless the cell's base was calibrated, because the watch compares with that calibration.
void requirePlaced(const Cell& cell) {
  if (!isPlaced(standingOf(cell)))
    throw InputError::saying(cell.path, "its base has not been calibrated, so there is nothing to watch",
                             "calibrate first: `tubeplan calibrate`, or `identify` with touches");
}

const char* kindName(calibration::ChangeKind kind) {
  switch (kind) {
    case calibration::ChangeKind::kUndecided:
      return "undecided";
    case calibration::ChangeKind::kBaseStep:
      return "base-step";
    case calibration::ChangeKind::kOther:
      return "other";
  }
  return "";
}

nlohmann::json alarmJson(const calibration::WatchAlarm& alarm,
                         const std::vector<calibration::Measurement>& measurements, const Units& units) {
  const auto idOf = [&](int k) { return measurements[static_cast<std::size_t>(k)].id; };
  return {{"reading", idOf(alarm.measurement)},
          {"since", idOf(alarm.since)},
          {"after_readings", alarm.measurement - alarm.since + 1},
          {"kind", kindName(alarm.kind)},
          {"judged_to", idOf(alarm.judged_to)},
          {"chi2", finiteJson(alarm.chi2)},
          {"degrees_of_freedom", alarm.degrees_of_freedom},
          {"base_step",
           {{"shift", vectorJson(alarm.step.head<3>(), units, dimension::kLength)},
            {"turn", vectorJson(alarm.step.tail<3>(), units, dimension::kAngle)},
            {"shift_sigma", vectorJson(alarm.step_sigma.head<3>(), units, dimension::kLength)},
            {"turn_sigma", vectorJson(alarm.step_sigma.tail<3>(), units, dimension::kAngle)}}}};
}

constexpr TextLine kBaseWords[] = {
    {"",
     "the base has moved by {base_step/shift:.3r} {units/length} (sigma {base_step/shift_sigma:.3r}) and turned by "
     "{base_step/turn:.3r} "
     "{units/angle}: stop, touch three holes again and calibrate\n"},
};
constexpr TextLine kWatchWords[] = {
    {"quiet", "{tested} readings: nothing has changed; the last one is at {level:.0%} % of the limit\n"},
    {"alarm",
     "ALARM at reading {reading}: the model ceased to hold since reading {since} (chi-square {chi2:.4r} on "
     "{degrees_of_freedom})\n"},
    {"base_moved", "", kBaseWords},
    {"other_change",
     "a step of the base alone does not explain it: stop, and run `tubeplan diagnose` on the readings since then\n"},
    {"undecided",
     "too few readings since then tell what has changed: stop, and touch four holes or more to find out\n"},
};

int run(const WatchRequest& request) {
  const CellMeasurements input = readCellMeasurements(request.cell, request.measurement_files, request.given);
  requirePlaced(input.cell);
  checkFigures(request.figures);
  const planner::Workcell work = workcellOf(input.cell, "watch its visits");
  const auto uncertainty = jointUncertaintyOf(input.cell, work, nullptr);
  const double model_error = input.cell.model_error ? input.cell.model_error->sigma : 0;
  noteStopSignals();
  calibration::WatchOptions options = request.options;
  options.stop = stopCondition();
  const auto watch =
      calibration::watchForChange({work.arm, work.X_WB, uncertainty, model_error}, input.measurements, options);
  if (watch.status == calibration::WatchStatus::kStopped) return kStoppedExitCode;
  if (watch.status == calibration::WatchStatus::kNotComputed)
    throw InputError::saying(input.file, watch.reason, "watch touches of holes, positions, offsets or steps");
  using calibration::ChangeKind;
  const auto isKind = [&](ChangeKind kind) { return watch.alarm && watch.alarm->kind == kind; };
  nlohmann::json figures = {{"status", watch.alarm ? "alarm" : "quiet"},
                            {"quiet", !watch.alarm},
                            {"base_moved", isKind(ChangeKind::kBaseStep)},
                            {"other_change", isKind(ChangeKind::kOther)},
                            {"undecided", isKind(ChangeKind::kUndecided)},
                            {"alarm", nullptr},
                            {"tested", watch.tested},
                            {"readings", input.measurements.size()},
                            {"level", finiteJson(watch.level.back())},
                            {"false_alarms", options.false_alarms},
                            {"units", unitsJson(input.cell.units)}};
  if (watch.alarm) {
    figures["alarm"] = alarmJson(*watch.alarm, input.measurements, input.cell.units);
    figures["base_step"] = figures["alarm"]["base_step"];
  }
  showFigures(request.figures, figures, textOf(figures, kWatchWords));
  return watch.alarm ? kNegativeAnswer : kDone;
}

}  // namespace

Run configureWatch(CLI::App& cli) {
  const auto request = std::make_shared<WatchRequest>();
  addCell(cli, request->cell);
  addMeasurements(cli, request->measurement_files);
  addMeasurementOptions(cli, request->given);
  cli.add_option("--false-alarms", request->options.false_alarms,
                 "largest probability of an alarm over all planned readings if nothing changes")
      ->check(within(1e-6, 0.5))
      ->capture_default_str();
  cli.add_option("--planned", request->options.planned, "number of readings planned (those given)")
      ->check(within(0, 1000000));
  addFigures(cli, request->figures);
  return [request] { return run(*request); };
}

}  // namespace tubeplan::app
