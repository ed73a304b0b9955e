#include "app/outage/job_json.hpp"

#include <nlohmann/json.hpp>

#include "app/documents/figures_text.hpp"
#include "app/formats/units_json.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

json eventJson(const JobEvent& event) {
  json result = {{"event", event.id},    {"at", event.at},           {"who", event.person},
                 {"kind", event.kind},   {"package", event.package}, {"tube", addressText(event.tube)},
                 {"value", event.value}, {"method", event.method},   {"reason", event.reason},
                 {"undoes", nullptr},    {"undone", event.is_undone}};
  if (event.undoes) result["undoes"] = *event.undoes;
  return result;
}

constexpr TextLine kReopenedWords[] = {{"reopened", ", {} no longer done"}, {"", "\n"}};

constexpr TextLine kTotalsWords[] = {
    {"", "{job}\npackage          sg       leg    planned    done  excluded  unresolved  (open, queued, held)\n"},
    {"packages",
     "{package:<16} {steam_generator:<8} {leg:<5} {planned:>8} {done:>7} {excluded:>9} {unresolved:>11}  ({open}, "
     "{queued}, "
     "{held})  {percent:.1f} %\n"},
    {"total",
     "{@:<31} {planned:>8} {done:>7} {excluded:>9} {unresolved:>11}  ({open}, {queued}, {held})  {percent:.1f} %\n",
     {},
     "all"},
    {"shifts", "{date} {shift}: {done} done", kReopenedWords},
    {"plugged_at_one_end",
     "warning: {} is plugged at this end only: plug the other end too, or check which tube it is\n"},
    {"plugged_in_the_meantime",
     "warning: {tube} is plugged, but the package {package} still plans to visit it: mark it excluded there\n"},
    {"wrong_tubes", "warning: at {tube} {who} found {found} ({at}): confirm the tube again before any tool enters\n"},
};

constexpr TextLine kNextWords[] = {
    {"", "next: {tube} at x {x:l units/length}, y {y:l units/length}\n"},
    {"", "package {package}, tool {tool}, {standing}; confirm by {confirm}\n"},
    {"extent", "extent {}\n"},
    {"history", "  {at} {who}: {kind} {value} {reason}\n"},
    {"", "{left} left\n"},
};

constexpr TextLine kLogWords[] = {
    {"events", "{event:>6} {at} {who:<12} {kind:<8} {tube:<16} {package:<12} {value} {method} {reason}\n"},
    {"!events", "no events yet\n"},
};

}  // namespace

json countsJson(const ItemCounts& counts) {
  json result = {{"planned", counts.planned},
                 {"done", counts.of(ItemStanding::kDone)},
                 {"excluded", counts.of(ItemStanding::kExcluded)},
                 {"unresolved", counts.unresolved()}};
  for (const ItemStanding standing : {ItemStanding::kOpen, ItemStanding::kQueued, ItemStanding::kHeld})
    result[std::string(standingName(standing))] = counts.of(standing);
  const int to_do = counts.planned - counts.of(ItemStanding::kExcluded);
  result["percent"] = to_do == 0 ? 100. : 100. * counts.of(ItemStanding::kDone) / to_do;
  return result;
}

json totalsJson(const JobTotals& totals, const JobFile& job) {
  json result = {{"job", job.name},
                 {"packages", json::array()},
                 {"total", countsJson(totals.all)},
                 {"shifts", json::array()},
                 {"plugged_at_one_end", json::array()},
                 {"plugged_in_the_meantime", json::array()},
                 {"wrong_tubes", json::array()}};
  for (const PackageTotal& total : totals.packages) {
    json row = countsJson(total.counts);
    row["package"] = total.package;
    row["steam_generator"] = total.generator;
    row["leg"] = tubesheets::legName(total.leg);
    result["packages"].push_back(std::move(row));
  }
  for (const ShiftBalance& of : totals.shifts)
    result["shifts"].push_back(
        {{"date", of.shift.date}, {"shift", of.shift.name}, {"done", of.done}, {"reopened", of.reopened}});
  for (const TubeAddress& tube : totals.plugged_at_one_end) result["plugged_at_one_end"].push_back(addressText(tube));
  for (const JobItem& item : totals.plugged_in_the_meantime)
    result["plugged_in_the_meantime"].push_back({{"tube", addressText(item.tube)}, {"package", item.package}});
  for (const JobEvent& event : totals.wrong_tubes)
    result["wrong_tubes"].push_back(
        {{"tube", addressText(event.tube)}, {"found", event.value}, {"who", event.person}, {"at", event.at}});
  return result;
}

std::string totalsText(const json& totals) { return textOf(totals, kTotalsWords); }

json nextJson(JobStore& store, const JobPart& part) {
  const std::vector<JobItem> items = store.items();
  const auto next = findNext(items, part);
  if (!next) return {{"tube", nullptr}, {"left", 0}};
  const JobItem& item = *next;
  const JobFile& job = store.job();
  const WorkPackage& package = job.packageOf(item.package);
  json result = {{"tube", addressText(item.tube)},
                 {"package", item.package},
                 {"steam_generator", item.tube.generator},
                 {"leg", tubesheets::legName(item.tube.leg)},
                 {"row", item.tube.row},
                 {"column", item.tube.column},
                 {"tool", package.tool},
                 {"extent", package.extent},
                 {"confirm", confirmationName(package.confirm)},
                 {"standing", standingName(item.standing())},
                 {"last_event", item.last_event},
                 {"left", itemsToVisit(items, part).size()},
                 {"history", json::array()},
                 {"units", unitsJson(job.units)}};
  const TubeEnd end = store.endOf(item.tube);
  result["x"] = lengthOf(end.x, job.units);
  result["y"] = lengthOf(end.y, job.units);
  for (const JobItem& other : store.itemsOf(item.tube))
    for (const JobEvent& event : store.eventsOf(other.id)) result["history"].push_back(eventJson(event));
  return result;
}

std::string nextText(const json& next) { return textOf(next, kNextWords); }

json findingJson(const TubeAddress& meant, const IdentityFinding& finding) {
  return {
      {"tube", addressText(meant)}, {"found", finding.found}, {"same", finding.is_same}, {"reason", finding.reason}};
}

json logJson(const std::vector<JobEvent>& events) {
  json result = {{"events", json::array()}};
  for (const JobEvent& event : events) result["events"].push_back(eventJson(event));
  return result;
}

std::string logText(const json& log) { return textOf(log, kLogWords); }

}  // namespace tubeplan::app
