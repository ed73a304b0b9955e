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

}  // namespace

void ItemCounts::add(ItemStanding standing) {
  ++planned;
  ++with[standing];
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
  std::set<std::int64_t> undone;
  for (const JobEvent& event : events)
    if (event.undoes && event.at < time) undone.insert(*event.undoes);
  std::map<std::int64_t, const Mark*> marks;
  for (const JobEvent& event : events)
    if (event.kind == "mark" && event.at < time && !undone.contains(event.id))
      marks[event.item] = findMark(event.value);
  for (JobItem& item : items) {
    const auto mark = marks.find(item.id);
    item.mark = mark == marks.end() ? nullptr : mark->second;
  }
  return items;
}

std::vector<ShiftBalance> balancesOf(const std::vector<JobItem>& items, const std::vector<JobEvent>& events,
                                     const std::vector<JobShift>& shifts) {
  std::map<std::string, ShiftBalance> balances;  // balances, keyed by the start of the shift
  for (const JobEvent& event : events) {
    const ShiftOfDay shift = shiftAt(event.at, shifts);
    ShiftBalance& balance = balances[startOf(shift, shifts) + shift.name];
    balance.shift = shift;
    balance.marks += event.kind == "mark" && !event.is_undone;
  }
  std::vector<ShiftBalance> in_order;
  std::vector<JobItem> before = itemsAt(items, events, "");
  for (auto& [start, balance] : balances) {
    std::vector<JobItem> after = itemsAt(items, events, endOf(balance.shift, shifts));
    for (std::size_t k = 0; k < items.size(); ++k) {
      const bool was = before[k].standing() == ItemStanding::kDone, is = after[k].standing() == ItemStanding::kDone;
      balance.done += is && !was;
      balance.reopened += was && !is;
    }
    balance.at_end = countsOf(after);
    in_order.push_back(balance);
    before = std::move(after);
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
