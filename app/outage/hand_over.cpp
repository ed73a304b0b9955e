#include "app/outage/hand_over.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "app/storage/input_error.hpp"
#include "app/storage/named_entry.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

namespace {

using Zones = std::map<TubeAddress, std::string>;

void requireShift(const std::string& name, const std::vector<JobShift>& shifts) {
  if (name.empty()) return;
  if (shifts.empty())
    throw InputError::problem("--shift", "the job file names no shifts",
                              "leave the option out to report on a whole day");
  (void)entryNamed(shifts, name, "--shift");
}

/// Returns the requested shift; std::nullopt if the request does not determine one.
std::optional<ShiftOfDay> chosenShift(const std::vector<JobEvent>& events, const JobFile& job,
                                      const HandOverRequest& request) {
  requireShift(request.shift, job.shifts);
  if (!request.date.empty()) requireDate(request.date);
  std::optional<ShiftOfDay> latest;
  for (const JobEvent& event : events) {
    const ShiftOfDay shift = shiftAt(event.at, job.shifts);
    const bool fits =
        (request.shift.empty() || shift.name == request.shift) && (request.date.empty() || shift.date == request.date);
    if (fits && (!latest || startOf(*latest, job.shifts) < startOf(shift, job.shifts))) latest = shift;
  }
  if (!latest && !request.date.empty() && (!request.shift.empty() || job.shifts.empty()))
    latest = ShiftOfDay{request.date, request.shift};
  return latest;
}

/// Returns the zones that the lists of the packages state in a column of that name.
Zones zonesOf(JobStore& store) {
  Zones zones;
  for (const WorkPackage& package : store.job().packages)
    for (const JobSheet& sheet : store.sheets()) {
      const auto list = tubesheets::parseWorkListCsv(store.listOf(package.name, sheet.generator, sheet.leg.leg));
      const auto& columns = list.table.text.columns;
      const auto found = std::ranges::find(columns, "zone", tubesheets::plainName);
      if (list.problem || found == columns.end()) continue;
      const auto column = static_cast<std::size_t>(found - columns.begin());
      for (const auto& row : list.table.text.rows)
        if (const auto tube = tubesheets::tubeOf(list.table, row); !tube.problem && !row.fields[column].empty())
          zones[{sheet.generator, sheet.leg.leg, tube.tube.row, tube.tube.column}] = row.fields[column];
    }
  return zones;
}

std::string legOf(const JobItem& item) { return addressText(LegName{item.tube.generator, item.tube.leg}); }

/// Counts all items by a property, in the order in which its values first occur.
TotalsBy totalsBy(const std::string& by, const std::vector<JobItem>& items,
                  const std::function<std::string(const JobItem&)>& nameOf) {
  TotalsBy totals{by, {}};
  std::map<std::string, std::size_t> places;
  for (const JobItem& item : items) {
    const auto [place, is_new] = places.emplace(nameOf(item), totals.rows.size());
    if (is_new) totals.rows.emplace_back(place->first, ItemCounts{});
    totals.rows[place->second].second.add(item.standing());
  }
  return totals;
}

std::vector<TotalsBy> allTotals(const std::vector<JobItem>& items, const Zones& zones) {
  std::vector<TotalsBy> totals{
      totalsBy("package and leg", items, [](const JobItem& item) { return item.package + " " + legOf(item); }),
      totalsBy("package", items, [](const JobItem& item) { return item.package; }), totalsBy("leg", items, legOf)};
  if (!zones.empty())
    totals.push_back(totalsBy("zone", items, [&](const JobItem& item) {
      const auto found = zones.find(item.tube);
      return found == zones.end() ? std::string("no zone") : found->second;
    }));
  return totals;
}

/// Marks as undone only those events whose undo is among the events.
void withoutLaterUndos(std::vector<JobEvent>& events) {
  std::set<std::int64_t> undone;
  for (const JobEvent& event : events)
    if (event.undoes) undone.insert(*event.undoes);
  for (JobEvent& event : events) event.is_undone = undone.contains(event.id);
}

std::vector<PersonsWork> peopleOf(const std::vector<JobEvent>& events) {
  std::map<std::string, PersonsWork> people;
  for (const JobEvent& event : events) {
    PersonsWork& work = people[event.person];
    work.person = event.person;
    if (event.kind == "mark" && !event.is_undone) ++work.marks[event.value];
    if (event.kind == "confirm") ++(event.value == "same" ? work.confirmed : work.wrong);
    if (event.kind == "undo") ++work.undone;
  }
  std::vector<PersonsWork> list;
  for (const auto& [person, work] : people) list.push_back(work);
  return list;
}

std::vector<MarkedItem> itemsWith(ItemStanding standing, const std::vector<JobItem>& items,
                                  const std::vector<JobEvent>& events) {
  std::map<std::int64_t, const JobEvent*> latest;
  for (const JobEvent& event : events)
    if (event.kind == "mark" && !event.is_undone) latest[event.item] = &event;
  std::vector<MarkedItem> found;
  for (const JobItem& item : items) {
    if (item.standing() != standing) continue;
    const auto event = latest.find(item.id);
    found.push_back({item, event == latest.end() ? std::nullopt : std::optional(*event->second)});
  }
  std::ranges::stable_sort(found, {}, [](const MarkedItem& of) { return of.item.last_event; });
  return found;
}

}  // namespace

HandOver handOverOf(JobStore& store, const HandOverRequest& request) {
  std::vector<JobItem> items = store.items();
  std::vector<JobEvent> events = store.events();
  const JobFile& job = store.job();
  HandOver of;
  of.shift = chosenShift(events, job, request);
  of.shifts = balancesOf(items, events, job.shifts);
  if (of.shift) {  // later events are not part of this hand-over
    const std::string end = endOf(*of.shift, job.shifts);
    items = itemsAt(std::move(items), events, end);
    of.later_events = static_cast<int>(std::erase_if(events, [&](const JobEvent& event) { return event.at >= end; }));
    withoutLaterUndos(events);
  }
  for (const JobEvent& event : events)
    if (of.shift && shiftAt(event.at, job.shifts) == *of.shift) of.events.push_back(event);
  for (const JobEvent& event : of.events)
    if (event.kind == "confirm" && event.value != "same") of.wrong.push_back(event);
  of.people = peopleOf(of.events);
  of.total = countsOf(items);
  of.totals = allTotals(items, zonesOf(store));
  of.held = itemsWith(ItemStanding::kHeld, items, events);
  of.retests = itemsWith(ItemStanding::kQueued, items, events);
  return of;
}

}  // namespace tubeplan::app
