// `tubeplan watch`: detects changes of a calibrated arm from measurements taken during operation.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
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
#include "app/documents/measurement_checks_json.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/formats/units_json.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/positioning/base_standing.hpp"
#include "app/studies/positioning/step_chances.hpp"
#include "calibration/diagnosis/causes/cause.hpp"
#include "calibration/watch/change_watch.hpp"

namespace tubeplan::app {

namespace {

using calibration::ChangeAnswer, calibration::ChangeKind, calibration::Measurement, calibration::Remedy;

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
    throw InputError::problem(cell.path, "its base has not been calibrated, so there is nothing to watch",
                              "calibrate first: `tubeplan calibrate`, or `identify` with touches");
}

/// Throws InputError for readings that state times which do not ascend, because a change is searched in their order.
void requireOrder(const std::vector<Measurement>& measurements, const std::string& file) {
  double latest = -std::numeric_limits<double>::infinity();
  for (const Measurement& measurement : measurements) {
    if (!measurement.conditions.states(deflection::Condition::kTime)) continue;
    const double time = measurement.conditions[deflection::Condition::kTime];
    if (time < latest)
      throw InputError::problem(fmt::format("{}:{} (time)", file, measurement.line),
                                "the reading is earlier than the one above it", "sort the readings by time");
    latest = time;
  }
}

struct KindRow {
  ChangeKind kind;
  const char* name;
};
constexpr KindRow kKinds[] = {{ChangeKind::kBaseStep, "base-step"},
                              {ChangeKind::kNamed, "named"},
                              {ChangeKind::kSeveral, "several"},
                              {ChangeKind::kOther, "other"}};

/// Instruction for a change, by the remedy of all its answers.
struct RemedyRow {
  Remedy remedy;
  const char *name, *words;
};
constexpr RemedyRow kRemedies[] = {
    {Remedy::kCalibrateBase, "calibrate-base", "stop, touch three holes again and calibrate"},
    {Remedy::kReferenceJoint, "reference-joint", "stop, reference the joint again, touch three holes and calibrate"},
    {Remedy::kInspectJoint, "inspect-joint",
     "stop, look for play or looseness there, then touch four holes or more and `identify`"},
    {Remedy::kRemeasureArm, "remeasure-arm",
     "stop, check the part named, then touch four holes or more and `identify`"},
    {Remedy::kAwaitWarmth, "await-warmth",
     "wait until the temperature is steady, state it with the readings, then touch three holes and calibrate"},
};
constexpr RemedyRow kOther = {Remedy::kRemeasureArm, "diagnose",
                              "stop, and run `tubeplan diagnose` on the readings since then"};

/// Returns the remedy that all answers share; nullptr if they differ.
const RemedyRow* sharedRemedy(const std::vector<ChangeAnswer>& answers) {
  if (answers.empty()) return &kOther;
  for (const ChangeAnswer& answer : answers)
    if (answer.remedy != answers.front().remedy) return nullptr;
  return std::ranges::find(kRemedies, answers.front().remedy, &RemedyRow::remedy);
}

nlohmann::json numberJson(const calibration::AnsweredNumber& number, const Units& units) {
  const Dimension unit = dimensionOf(number.quantity);
  return {{"name", number.name},
          {"change", finiteJson(number.value / units.factor(unit))},
          {"sigma", finiteJson(number.sigma / units.factor(unit))},
          {"unit", units.nameOf(unit)}};
}

std::string wordsOf(const ChangeAnswer& answer) {
  if (answer.effect == calibration::kBaseMoved) return "the base has moved";
  return calibration::causeWords(answer.effect, answer.at);
}

nlohmann::json answerJson(const ChangeAnswer& answer, const std::string& since, const Units& units) {
  nlohmann::json numbers = nlohmann::json::array();
  for (const auto& number : answer.numbers) numbers.push_back(numberJson(number, units));
  const auto remedy = std::ranges::find(kRemedies, answer.remedy, &RemedyRow::remedy);
  return {{"effect", answer.effect},
          {"at", answer.at},
          {"words", wordsOf(answer)},
          {"course", !answer.may_be_ramp   ? "sudden"
                     : !answer.may_be_step ? "growing"
                                           : "sudden or growing"},
          {"since", since},
          {"probability", finiteJson(answer.probability)},
          {"gain", finiteJson(answer.gain)},
          {"numbers", numbers},
          {"most_shift", lengthJson(answer.most_shift, units)},
          {"assumes_change_of", answer.assumed},
          {"remedy", remedy->name}};
}

/// Returns the displacement of the base as three shifts and three turns with their standard deviations; null if none
/// was fitted.
nlohmann::json baseJson(const std::vector<calibration::AnsweredNumber>& base, const Units& units) {
  if (base.size() != 6) return nullptr;
  calibration::BaseStep step, sigma;
  for (Eigen::Index k = 0; k < 6; ++k) {
    step[k] = base[static_cast<std::size_t>(k)].value;
    sigma[k] = base[static_cast<std::size_t>(k)].sigma;
  }
  return {{"shift", vectorJson(step.head<3>(), units, dimension::kLength)},
          {"turn", vectorJson(step.tail<3>(), units, dimension::kAngle)},
          {"shift_sigma", vectorJson(sigma.head<3>(), units, dimension::kLength)},
          {"turn_sigma", vectorJson(sigma.tail<3>(), units, dimension::kAngle)}};
}

nlohmann::json adviceJson(const calibration::WatchAlarm& alarm) {
  if (const RemedyRow* remedy = sharedRemedy(alarm.judgement.answers))
    return {{"name", remedy->name}, {"words", remedy->words}, {"pairs", nullptr}, {"of_pairs", nullptr}};
  if (!alarm.means)
    return {{"name", "diagnose"},
            {"words", "stop: no further measurement of this kind distinguishes the causes; inspect the parts named"},
            {"pairs", 0},
            {"of_pairs", nullptr}};
  return {{"name", alarm.means->name},
          {"words", std::string("stop, and distinguish them: ") + alarm.means->words},
          {"pairs", alarm.means->pairs},
          {"of_pairs", alarm.means->of_pairs}};
}

nlohmann::json alarmJson(const calibration::WatchAlarm& alarm, const std::vector<Measurement>& measurements,
                         const Units& units) {
  const auto idOf = [&](int k) { return measurements[static_cast<std::size_t>(k)].id; };
  nlohmann::json answers = nlohmann::json::array();
  for (const ChangeAnswer& answer : alarm.judgement.answers)
    answers.push_back(answerJson(answer, idOf(answer.since), units));
  return {{"reading", idOf(alarm.measurement)},
          {"since", idOf(alarm.since)},
          {"after_readings", alarm.measurement - alarm.since + 1},
          {"test", alarm.test},
          {"kind", std::ranges::find(kKinds, alarm.kind, &KindRow::kind)->name},
          {"judged_to", idOf(alarm.judged_to)},
          {"chi2", finiteJson(alarm.chi2)},
          {"degrees_of_freedom", alarm.degrees_of_freedom},
          {"candidates", alarm.judgement.tried},
          {"answers", answers},
          {"advice", adviceJson(alarm)},
          {"base_step", baseJson(alarm.judgement.base, units)}};
}

constexpr TextLine kDeterminedNumber[] = {
    {"sigma", "      {name}: {change:+.3r} {unit} (sigma {sigma:.2r})\n"},
};
constexpr TextLine kNumberWords[] = {
    {"numbers", "", kDeterminedNumber},
};
constexpr TextLine kAnswerWords[] = {
    {"answers",
     "  {effect}@{at}: {words}, {course}, since {since}; probability {probability:.0%} %, moves the tip by up to "
     "{most_shift:l} {units/length}\n",
     kNumberWords, "", 12},
};
constexpr TextLine kBaseWords[] = {
    {"",
     "the base has moved by {base_step/shift:.3r} {units/length} (sigma {base_step/shift_sigma:.3r}) and turned by "
     "{base_step/turn:.3r} {units/angle}\n"},
};
constexpr TextLine kWatchWords[] = {
    {"quiet",
     "{tested} reading(|s): no change found; the last one is at {level:.0%} % of the limit\n"
     "a sudden shift of the base by {detectable_shift:.2r} {units/length} along x, y, z would probably have shown "
     "within "
     "{within} readings (none: not at all)\n"},
    {"not_seen_count", "{not_seen_count} of the changes that are looked for cannot be detected in these readings\n"},
    {"alarm", "ALARM at reading {reading}: the model is wrong since about reading {since} (test {test})\n"},
    {"base_moved", "", kBaseWords},
    {"other_change", "none of the {alarm/candidates} changes that are looked for explains it\n"},
    {"several", "{#alarm/answers} changes explain it, which these readings cannot distinguish:\n"},
    {"alarm", "", kAnswerWords},
    {"alarm/advice", "{words}\n"},
    {"alarm/advice/of_pairs", "(this would probably distinguish {alarm/advice/pairs} of {} pairs)\n"},
};

nlohmann::json figuresOf(const calibration::Watch& watch, const CellMeasurements& input, double false_alarms) {
  const Units& units = input.cell.units;
  const auto isKind = [&](ChangeKind kind) { return watch.alarm && watch.alarm->kind == kind; };
  nlohmann::json figures = {{"status", watch.alarm ? "alarm" : "quiet"},
                            {"quiet", !watch.alarm},
                            {"base_moved", isKind(ChangeKind::kBaseStep)},
                            {"named", isKind(ChangeKind::kNamed)},
                            {"several", isKind(ChangeKind::kSeveral)},
                            {"other_change", isKind(ChangeKind::kOther)},
                            {"alarm", nullptr},
                            {"tested", watch.tested},
                            {"readings", input.measurements.size()},
                            {"level", finiteJson(watch.level.back())},
                            {"detectable_shift", vectorJson(watch.detectable, units, dimension::kLength)},
                            {"within", calibration::kMeasurementsToFind},
                            {"candidates", watch.candidates},
                            {"not_seen", watch.not_seen},
                            {"not_seen_count", watch.alarm ? 0 : watch.not_seen.size()},
                            {"false_alarms", false_alarms},
                            {"units", unitsJson(units)}};
  if (watch.alarm) {
    figures["alarm"] = alarmJson(*watch.alarm, input.measurements, units);
    figures["base_step"] = figures["alarm"]["base_step"];
  }
  return figures;
}

int run(const WatchRequest& request) {
  const CellMeasurements input = readCellMeasurements(request.cell, request.measurement_files, request.given);
  requirePlaced(input.cell);
  requireOrder(input.measurements, input.file);
  if (const int given = static_cast<int>(input.measurements.size());
      request.options.planned != 0 && request.options.planned < given)
    throw InputError::problem("--planned",
                              fmt::format("{} readings are planned, but {} are given", request.options.planned, given),
                              "state how many are planned in all, or leave the option out");
  checkFigures(request.figures);
  const planner::Workcell work = workcellOf(input.cell, "watch its visits");
  const auto uncertainty = jointUncertaintyOf(input.cell, work, nullptr);
  const double model_error = input.cell.model_error ? input.cell.model_error->sigma : 0;
  noteStopSignals();
  calibration::WatchOptions options = request.options;
  options.stop = stopCondition();
  const auto watch = calibration::watchForChange({work.arm, work.X_WB, uncertainty, model_error, work.tool},
                                                 input.measurements, options);
  if (watch.status == calibration::WatchStatus::kStopped) return kStoppedExitCode;
  if (watch.status == calibration::WatchStatus::kNotComputed)
    throw InputError::problem(input.file, watch.reason, "watch touches of holes, positions, offsets or steps");
  nlohmann::json figures = figuresOf(watch, input, options.false_alarms);
  addChecks(input.checks, input.cell.units, figures);
  showFigures(request.figures, figures, checksText(input.checks, input.cell.units) + textOf(figures, kWatchWords));
  return watch.alarm ? kNegativeAnswer : kDone;
}

}  // namespace

Run configureWatch(CLI::App& cli) {
  const auto request = std::make_shared<WatchRequest>();
  request->given.takes_no_steps = true;
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
