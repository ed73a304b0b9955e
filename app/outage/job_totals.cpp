#include "app/outage/job_totals.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace tubeplan::app {

namespace {

using tubesheets::Leg, tubesheets::TubeState;

using TubeKey = std::tuple<std::string, int, int>;

/// Returns the legs at which each tube is plugged, by the state that the job began with or by a mark.
std::map<TubeKey, std::set<Leg>> pluggedLegs(JobStore& store, const std::vector<JobItem>& items) {
  std::map<TubeKey, std::set<Leg>> plugged;
  for (const JobItem& item : items)
    if (item.isPlugged()) plugged[{item.tube.generator, item.tube.row, item.tube.column}].insert(item.tube.leg);
  if (plugged.empty()) return plugged;
  for (const JobSheet& sheet : store.sheets())
    for (const TubeEnd& end : store.endsOf(sheet.generator, sheet.leg.leg))
      if (const auto found = plugged.find({end.tube.generator, end.tube.row, end.tube.column});
          found != plugged.end() && end.state == tubesheets::tubeStateName(TubeState::kPlugged))
        found->second.insert(end.tube.leg);
  return plugged;
}

std::vector<TubeAddress> pluggedAtOneEnd(JobStore& store, const std::vector<JobItem>& items) {
  std::map<std::string, std::size_t> legs;
  for (const JobSheet& sheet : store.sheets()) ++legs[sheet.generator];
  std::vector<TubeAddress> found;
  for (const auto& [tube, ends] : pluggedLegs(store, items))
    if (ends.size() < legs[std::get<0>(tube)])
      found.push_back({std::get<0>(tube), *ends.begin(), std::get<1>(tube), std::get<2>(tube)});
  return found;
}

/// Returns the latest confirmation of every item whose latest confirmation found another tube.
std::vector<JobEvent> wrongTubes(const std::vector<JobEvent>& events) {
  std::map<std::int64_t, const JobEvent*> latest;
  for (const JobEvent& event : events)
    if (event.kind == "confirm") latest[event.item] = &event;
  std::vector<JobEvent> wrong;
  for (const auto& [item, event] : latest)
    if (event->value != "same") wrong.push_back(*event);
  return wrong;
}

using EventsByItem = std::map<std::int64_t, std::vector<const JobEvent*>>;

/// Returns the events of every item that has any, in the order of the log.
EventsByItem eventsByItem(const std::vector<JobEvent>& events) {
  EventsByItem by_item;
  for (const JobEvent& event : events) by_item[event.item].push_back(&event);
  return by_item;
}

/// Returns the latest mark of an item before a time that no undo before this time undid; null if there is none.
const Mark* markAt(const std::vector<const JobEvent*>& events_of_item, const std::string& time) {
  std::set<std::int64_t> undone;
  for (const JobEvent* event : events_of_item)
    if (event->undoes && event->at < time) undone.insert(*event->undoes);
  const Mark* mark = nullptr;
  for (const JobEvent* event : events_of_item)
    if (event->kind == "mark" && event->at < time && !undone.contains(event->id)) mark = findMark(event->value);
  return mark;
}

}  // namespace

void ItemCounts::add(ItemStanding standing) {
  ++planned;
  ++with[standing];
}

void ItemCounts::move(ItemStanding from, ItemStanding to) {
  --with[from];
  ++with[to];
}

int ItemCounts::of(ItemStanding standing) const {
  const auto found = with.find(standing);
  return found == with.end() ? 0 : found->second;
}

int ItemCounts::unresolved() const { return planned - of(ItemStanding::kDone) - of(ItemStanding::kExcluded); }

ItemCounts countsOf(const std::vector<JobItem>& items) {
  ItemCounts counts;
  for (const JobItem& item : items) counts.add(item.standing());
  return counts;
}

std::vector<JobItem> itemsAt(std::vector<JobItem> items, const std::vector<JobEvent>& events, const std::string& time) {
  const EventsByItem by_item = eventsByItem(events);
  for (JobItem& item : items) {
    const auto of = by_item.find(item.id);
    item.mark = of == by_item.end() ? nullptr : markAt(of->second, time);
  }
  return items;
}

std::vector<ShiftBalance> balancesOf(const std::vector<JobItem>& items, const std::vector<JobEvent>& events,
                                     const std::vector<JobShift>& shifts) {
  const EventsByItem by_item = eventsByItem(events);
  std::map<std::string, ShiftBalance> balances;                     // keyed by the start of the shift
  std::map<std::string, std::set<std::int64_t>> items_with_events;  // keys of items, by the same key
  for (const JobEvent& event : events) {
    const ShiftOfDay shift = shiftAt(event.at, shifts);
    const std::string start = startOf(shift, shifts) + shift.name;
    balances[start].shift = shift;
    balances[start].marks += event.kind == "mark" && !event.is_undone;
    items_with_events[start].insert(event.item);
  }
  std::vector<JobItem> now = itemsAt(items, {}, "");
  ItemCounts counts = countsOf(now);
  std::map<std::int64_t, JobItem*> by_key;
  for (JobItem& item : now) by_key[item.id] = &item;
  std::vector<ShiftBalance> in_order;
  for (auto& [start, balance] : balances) {
    const std::string end = endOf(balance.shift, shifts);
    for (const std::int64_t key : items_with_events.at(start)) {  // no other item changes in the shift
      JobItem& item = *by_key.at(key);
      const ItemStanding before = item.standing();
      item.mark = markAt(by_item.at(key), end);
      const ItemStanding after = item.standing();
      counts.move(before, after);
      balance.done += after == ItemStanding::kDone && before != ItemStanding::kDone;
      balance.reopened += before == ItemStanding::kDone && after != ItemStanding::kDone;
    }
    balance.at_end = counts;
    in_order.push_back(balance);
  }
  return in_order;
}

JobTotals totalsOf(JobStore& store) {
  JobTotals totals;
  const std::vector<JobItem> items = store.items();
  for (const JobItem& item : items) {
    const bool is_new = totals.packages.empty() || totals.packages.back().package != item.package ||
                        totals.packages.back().generator != item.tube.generator ||
                        totals.packages.back().leg != item.tube.leg;
    if (is_new) totals.packages.push_back({item.package, item.tube.generator, item.tube.leg, {}});
    totals.packages.back().counts.add(item.standing());
    totals.all.add(item.standing());
  }
  const std::vector<JobEvent> events = store.events();
  totals.shifts = balancesOf(items, events, store.job().shifts);
  totals.plugged_at_one_end = pluggedAtOneEnd(store, items);
  const std::set<TubeAddress> plugged = pluggedEnds(items);
  for (const JobItem& item : items)
    if (item.isDue() && plugged.contains(item.tube)) totals.plugged_in_the_meantime.push_back(item);
  totals.wrong_tubes = wrongTubes(events);
  return totals;
}

}  // namespace tubeplan::app
