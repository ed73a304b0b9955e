#include "app/commands/campaign/centring_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/commands/campaign/campaign_json.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/pose_json.hpp"
#include "app/formats/units_json.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

constexpr std::array kQuantiles{0.5, 0.9, 0.95, 0.99};
constexpr std::size_t kWorstHoles = 10;
constexpr std::size_t kCurvePoints = 120;

json quantilesJson(const ErrorSketch& errors, const Units& units) {
  json quantiles;
  for (const double share : kQuantiles)
    quantiles[fmt::format("{:.0f}", 100 * share)] =
        errors.count() ? lengthJson(errors.quantile(share), units) : json(nullptr);
  return quantiles;
}

/// Returns a subset of the points of the cumulative error distribution, as pairs of an error and the fraction of visits
/// with at most this error.
json curveJson(const ErrorSketch& errors, const Units& units) {
  const auto points = errors.distribution();
  json curve = json::array();
  double last = -1;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double share = static_cast<double>(points[k].count) / static_cast<double>(errors.count());
    if (share - last < 1. / kCurvePoints && share < 0.98 && k + 1 < points.size()) continue;
    last = share;
    curve.push_back({lengthJson(points[k].error, units), finiteJson(share)});
  }
  return curve;
}

/// Returns the holes with the largest mean errors among holes visited at least ten times.
json worstHoles(const CentringResults& results, const WayTally& way) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < way.holes.size(); ++k)
    if (way.holes[k].errors.count() >= 10) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return way.holes[a].errors.mean() > way.holes[b].errors.mean();
  });
  order.resize(std::min(order.size(), kWorstHoles));
  json list = json::array();
  for (const std::size_t k : order) {
    const auto& hole = way.holes[k];
    json at_least = json::array();
    for (const auto count : hole.at_least)
      at_least.push_back(
          probabilityJson(wilsonInterval(static_cast<double>(count), static_cast<double>(hole.errors.count()))));
    list.push_back({{"hole", results.task.holes.visited[k].hole},
                    {"visits", hole.errors.count()},
                    {"mean", lengthJson(hole.errors.mean(), results.task.cell.units)},
                    {"at_least", at_least}});
  }
  return list;
}

json wayJson(const CentringResults& results, const SettingTally& setting, const WayTally& way) {
  const Units& units = results.task.cell.units;
  const ErrorSketch all = way.allErrors();
  json steps = json::array();
  for (std::size_t k = 0; k < way.at_least.size(); ++k)
    steps.push_back({{"at_least", k + 1},
                     {"probability", probabilityJson(way.at_least[k].probability())},
                     {"in_all_holes", probabilityJson(wilsonInterval(static_cast<double>(way.all_holes[k]),
                                                                     static_cast<double>(setting.failures[0].runs)))}});
  return {{"visits", all.count()},
          {"missed", way.missed()},
          {"mean",
           {{"value", lengthJson(all.mean(), units)},
            {"sigma", lengthJson(way.errors.standardError() * ErrorSketch::kUnit, units)}}},
          {"rms", lengthJson(all.rms(), units)},
          {"quantiles", quantilesJson(all, units)},
          {"max", lengthJson(all.max(), units)},
          {"steps", steps},
          {"curve", curveJson(all, units)},
          {"worst_holes", worstHoles(results, way)}};
}

json waysJson() {
  json ways = json::array();
  for (std::size_t w = 0; w < kWays.size(); ++w) ways.push_back({{"name", kWays[w]}, {"words", kWayWords[w]}});
  return ways;
}

/// Returns the origin of the base poses of all settings: each run calibrates its own base. The number of touches is
/// stated only if it is the same in all settings.
BaseStanding standingOf(const std::vector<CentringSetting>& settings) {
  const int touches = settings.front().touches;
  const bool is_one = std::ranges::all_of(settings, [&](const auto& other) { return other.touches == touches; });
  return standingOfEachRun(is_one ? touches : 0);
}

json settingJson(const CentringResults& results, std::size_t index) {
  const auto& setting = results.task.options.settings[index];
  const auto& tally = results.tally.settings()[index];
  const std::uint64_t scored = tally.failures[0].runs;
  json figures = {
      {"base", eachRunJson(setting.touches, tally.misfits.runs)},
      {"warnings", misfitWarnings(tally.misfits.runs, scored)},
      {"touches", setting.touches},
      {"choice", touchRules()[static_cast<std::size_t>(setting.rule)].name},
      {"touch_sigma", lengthJson(setting.touch_sigma, results.task.cell.units)},
      {"touched_holes", results.trials.touchedHoles(index)},
      {"runs", tally.runs},
      {"scored", scored},
      {"calibrated", probabilityJson(wilsonInterval(static_cast<double>(scored), static_cast<double>(tally.runs)))},
      {"refused", failuresJson(tally.failures)}};
  for (std::size_t w = 0; w < kWays.size(); ++w) figures[kWays[w]] = wayJson(results, tally, tally.ways[w]);
  return figures;
}

constexpr TextLine kVisitStepWords[] = {
    {"steps", "  {probability/value:>5.1%} ({probability/low:.1%}-{probability/high:.1%})"}, {"", "\n"}};
constexpr std::string_view kWayRow =
    "  {@:<12}{mean/value:>9.4r} +-{mean/sigma:>9.4r}  {quantiles/50:>9.4r}  {quantiles/90:>9.4r}  "
    "{quantiles/95:>9.4r}  "
    "{quantiles/99:>9.4r}";
constexpr TextLine kSettingWords[] = {{"refused", "  {runs} run(|s): {reason} (first: run {first_run})\n"},
                                      {"warnings", "  warning: {}\n"},
                                      {"none", kWayRow, kVisitStepWords, "without"},
                                      {"compensated", kWayRow, kVisitStepWords, "compensated"}};

constexpr TextLine kCentringWords[] = {
    {"",
     "{runs_done} of {runs} run(|s), {holes_in_a_run} hole(|s) in each of {tubes/in_reach} in reach of {tubes/asked}, "
     "{base/words}\n"
     "error, {units/length:<7}     mean                   50 %       90 %       95 %       99 %  % of the visits by so "
     "many steps or more: 1, 2, ...\n"},
    {"settings",
     "{touches} touch(|es), {choice}, touch sigma {touch_sigma:.4r units/length}: {scored} of {runs} run(|s) scored\n",
     kSettingWords}};

}  // namespace

json centringJson(const CentringResults& results) {
  const auto& [task, request, trials, tally, progress] = results;
  json tolerances = json::array();
  for (const auto& step : task.model.tool.steps) tolerances.push_back(lengthJson(step.tolerance, task.cell.units));
  json figures = {{"kind", "centre"},
                  {"cell", task.cell.name},
                  {"truth", request.truth.empty() ? request.cell : request.truth},
                  {"seed", request.seed},
                  {"status", progress.done == progress.runs ? "done" : "stopped"},
                  {"runs", progress.runs},
                  {"runs_done", progress.done},
                  {"units", unitsJson(task.cell.units)},
                  {"base", standingJson(standingOf(task.options.settings))},
                  {"drawn", drawnJson(task.options.spread, task.truth.arm, task.cell.units)},
                  {"holes_in_a_run", task.options.holes},
                  {"tubes", {{"asked", task.tubes}, {"in_reach", task.holes.visited.size()}}},
                  {"step_tolerances", tolerances},
                  {"ways", waysJson()},
                  {"settings", json::array()}};
  for (std::size_t k = 0; k < task.options.settings.size(); ++k) figures["settings"].push_back(settingJson(results, k));
  return figures;
}

std::string centringText(const json& figures) { return textOf(figures, kCentringWords); }

}  // namespace tubeplan::app
