#include "app/commands/campaign/outage_figures.hpp"

#include <fmt/format.h>

#include <array>

#include "app/commands/campaign/campaign_json.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/pose_json.hpp"
#include "app/formats/units_json.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

std::uint64_t detectedOf(const ChangeTally& tally) { return tally.alarms - tally.early; }

json stepSharesJson(const RunSums& visits) {
  json share = probabilityJson(visits.probability());
  share["visits"] = visits.count();
  return share;
}

json histogramJson(const CountHistogram& counts) {
  return {{"mean", finiteJson(counts.mean())},
          {"50", finiteJson(counts.quantile(0.5))},
          {"90", finiteJson(counts.quantile(0.9))}};
}

/// A figure of the outages with one change: key and description in documents, heading and value in the text's table.
struct OutageFigure {
  const char *name, *words, *heading, *text;
  json (*value)(const ChangeTally& tally);
};

constexpr std::array kOutageFigures{
    OutageFigure{"runs", "outages with this change", "  runs", "{runs:>6}",
                 [](const ChangeTally& t) { return json(t.runs); }},
    OutageFigure{"too_early", "alarms before the change", " early", "{too_early:>6}",
                 [](const ChangeTally& t) { return json(t.early); }},
    OutageFigure{"detected", "alarms after the change, of the outages that were quiet until then", "  found %",
                 "{detected/value:>9.1%}",
                 [](const ChangeTally& t) { return shareJson(detectedOf(t), t.runs - t.early); }},
    OutageFigure{"delay", "visits from the change to the alarm, both counted", "  delay 50, 90 %",
                 "{delay/50:>11.0f}{delay/90:>5.0f}", [](const ChangeTally& t) { return histogramJson(t.delays); }},
    OutageFigure{"named", "true cause with its course among the answers, of the alarms after the change", "  named %",
                 "{named/value:>9.1%}", [](const ChangeTally& t) { return shareJson(t.named, detectedOf(t)); }},
    OutageFigure{"alone", "true cause as the only answer, of the alarms after the change", "  alone %",
                 "{alone/value:>9.1%}", [](const ChangeTally& t) { return shareJson(t.alone, detectedOf(t)); }},
    OutageFigure{"all_steps_before", "visits before the change in which all steps entered", "  before %",
                 "{all_steps_before/value:>10.1%}", [](const ChangeTally& t) { return stepSharesJson(t.before); }},
    OutageFigure{"all_steps_after", "visits since the change and up to the alarm in which all steps entered",
                 "  after %", "{all_steps_after/value:>9.1%}",
                 [](const ChangeTally& t) { return stepSharesJson(t.after); }},
    OutageFigure{"lost", "visits since the change and up to the alarm in which not all steps entered, in each outage",
                 "  lost 50, 90 %", "{lost/50:>10.0f}{lost/90:>5.0f}",
                 [](const ChangeTally& t) { return histogramJson(t.lost); }}};

json changeJson(const ChangeTally& tally) {
  json entry;
  for (const auto& figure : kOutageFigures) entry[figure.name] = figure.value(tally);
  return entry;
}

json unchangedJson(const ChangeTally& tally) {
  return {{"runs", tally.runs},
          {"false_alarms", shareJson(tally.alarms, tally.runs)},
          {"all_steps", stepSharesJson(tally.before)}};
}

json changesJson(const OutageTask& task, const OutageTally& tally) {
  json list = json::array();
  for (const int change : task.options.changes) {
    const auto k = static_cast<std::size_t>(change);
    const auto& row = calibration::hiddenChanges()[k];
    json entry = changeJson(tally.changes()[k]);
    entry["name"] = row.name;
    entry["words"] = row.words;
    entry["at"] = row.at(task.centring.truth.arm);
    list.push_back(entry);
  }
  return list;
}

json refusedJson(const OutageTally& tally) {
  json list = failuresJson(tally.failures());
  if (const auto& unwatched = tally.unwatched(); unwatched.runs > 0)
    list.push_back({{"reason", "the watch could not judge the visits"},
                    {"runs", unwatched.runs},
                    {"first_run", unwatched.first_run}});
  return list;
}

constexpr TextLine kOutageWords[] = {
    {"",
     "{runs_done} of {runs} run(|s), {visits} visit(|s) in each of {tubes/in_reach} in reach of {tubes/asked}, "
     "{base/words}\n"},
    {"touch_every", "steps are counted, with a touch every {} visits\n"},
    {"refused", "  {runs} run(|s): {reason} (first: run {first_run})\n"},
    {"unchanged",
     "no change: {runs} run(|s), false alarms {false_alarms/count}, {false_alarms/value:.1%} % "
     "({false_alarms/low:.1%} to {false_alarms/high:.1%}); all steps entered in {all_steps/value:.1%} % of the "
     "visits\n"}};

std::string rowText(const json& entry, std::string_view name) {
  std::string text = fmt::format("{:<14}", name);
  for (const auto& figure : kOutageFigures) text += textOf(entry, figure.text);
  return text + "\n";
}

/// Calls `add` with the key and value of every number of an entry, in the order of the table.
template <class Add>
void forEachNumber(const json& entry, const Add& add) {
  for (const auto& figure : kOutageFigures) {
    const json& value = entry[figure.name];
    if (!value.is_object()) add(std::string(figure.name), value);
    if (value.is_object())
      for (const auto& [key, number] : value.items()) add(fmt::format("{}_{}", figure.name, key), number);
  }
}

}  // namespace

json outageJson(const OutageTask& task, const CampaignRequest& request, const OutageTally& tally,
                const CampaignProgress& progress) {
  const auto& centring = task.centring;
  const auto& setting = centring.options.settings.front();
  const Units& units = centring.cell.units;
  json meanings = json::array();
  for (const auto& figure : kOutageFigures) meanings.push_back({{"name", figure.name}, {"words", figure.words}});
  return {{"kind", "outage"},
          {"cell", centring.cell.name},
          {"truth", request.truth.empty() ? request.cell : request.truth},
          {"seed", request.seed},
          {"status", progress.done == progress.runs ? "done" : "stopped"},
          {"runs", progress.runs},
          {"runs_done", progress.done},
          {"units", unitsJson(units)},
          {"base", standingJson(standingOfEachRun(setting.touches))},
          {"drawn", drawnJson(centring.options.spread, centring.truth.arm, units)},
          {"touch_sigma", lengthJson(setting.touch_sigma, units)},
          {"visits", request.visits},
          {"touch_every", task.options.touch_every},
          {"allowed_false_alarms", task.options.false_alarms},
          {"nothing", task.options.nothing},
          {"tubes", {{"asked", centring.tubes}, {"in_reach", centring.holes.visited.size()}}},
          {"refused", refusedJson(tally)},
          {"unchanged", unchangedJson(tally.changes().front())},
          {"changed", changeJson(tally.changed())},
          {"changes", changesJson(task, tally)},
          {"meanings", meanings}};
}

std::string outageText(const json& figures) {
  std::string text = textOf(figures, kOutageWords) + fmt::format("{:<14}", "change");
  for (const auto& figure : kOutageFigures) text += figure.heading;
  text += "\n";
  for (const auto& entry : figures["changes"]) text += rowText(entry, entry["name"].get<std::string>());
  return text + rowText(figures["changed"], "all of these");
}

std::string changesCsv(const json& figures) {
  std::string text = "change";
  forEachNumber(figures["changed"], [&](const std::string& key, const json&) { text += "," + key; });
  for (const auto& entry : figures["changes"]) {
    text += "\n" + entry["name"].get<std::string>();
    forEachNumber(entry, [&](const std::string&, const json& number) {
      text += "," + (number.is_null() ? std::string() : number.dump());
    });
  }
  return text + "\n";
}

}  // namespace tubeplan::app
