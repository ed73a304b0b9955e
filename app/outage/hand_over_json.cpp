#include "app/outage/hand_over_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/documents/figures_text.hpp"
#include "app/formats/units_json.hpp"
#include "app/outage/job_json.hpp"
#include "app/outage/leg_maps_json.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

/// Returns a shift as "2025-04-02 day", or as the date alone where no shift of the job is named.
std::string shiftWords(const std::string& date, const std::string& name) {
  return date.empty() || name.empty() ? date + name : date + " " + name;
}

json shiftJson(const std::optional<ShiftOfDay>& shift, const JobFile& job) {
  if (!shift) return nullptr;
  return {{"date", shift->date},
          {"name", shift->name},
          {"words", shiftWords(shift->date, shift->name)},
          {"from", startOf(*shift, job.shifts)},
          {"to", endOf(*shift, job.shifts)}};
}

json totalsByJson(const std::vector<TotalsBy>& totals) {
  json list = json::array();
  for (const TotalsBy& by : totals) {
    json rows = json::array();
    for (const auto& [name, counts] : by.rows) {
      rows.push_back(countsJson(counts));
      rows.back()["name"] = name;
    }
    list.push_back({{"by", by.by}, {"rows", rows}});
  }
  return list;
}

json balancesJson(const std::vector<ShiftBalance>& shifts) {
  json list = json::array();
  for (const ShiftBalance& balance : shifts) {
    json row = countsJson(balance.at_end);
    row["name"] = shiftWords(balance.shift.date, balance.shift.name);
    row["marks"] = balance.marks;
    row["done_in_shift"] = balance.done;
    row["reopened_in_shift"] = balance.reopened;
    list.push_back(std::move(row));
  }
  return list;
}

json peopleJson(const std::vector<PersonsWork>& people) {
  json list = json::array();
  for (const PersonsWork& work : people) {
    int marked = 0;
    for (const auto& [name, count] : work.marks) marked += count;
    list.push_back({{"who", work.person},
                    {"marked", marked},
                    {"marks", work.marks},
                    {"confirmed", work.confirmed},
                    {"wrong", work.wrong},
                    {"undone", work.undone}});
  }
  return list;
}

json marksJson() {
  json list = json::array();
  for (const Mark& mark : marks())
    list.push_back({{"name", mark.name}, {"words", mark.words}, {"standing", standingName(mark.standing)}});
  return list;
}

/// Returns the reason why an item is held: its mark and the reason of the mark, or the reason stated by the plan.
std::string heldReason(const MarkedItem& of) {
  if (!of.event) return fmt::format("out of reach of the plan: {}", of.item.unreachable);
  return of.event->reason.empty() ? fmt::format("{}, no reason stated", of.event->value)
                                  : fmt::format("{}: {}", of.event->value, of.event->reason);
}

/// Returns the first tubes of a list by name, and the number of the others: "A/hot/R1C2, A/hot/R1C3 and 7 more".
std::string namedText(const json& tubes) {
  constexpr std::size_t kNamed = 5;
  const std::size_t named = std::min(kNamed, tubes.size());
  const std::vector<std::string> first(tubes.begin(), tubes.begin() + static_cast<std::ptrdiff_t>(named));
  const std::string more = tubes.size() > named ? fmt::format(" and {} more", tubes.size() - named) : "";
  return fmt::format("{}{}", fmt::join(first, ", "), more);
}

json heldJson(const std::vector<MarkedItem>& held) {
  std::map<std::pair<bool, std::string>, json> by_reason;  // decisions come before tubes that the plan does not reach
  for (const MarkedItem& of : held)
    by_reason.try_emplace({!of.event, heldReason(of)}, json::array())
        .first->second.push_back(addressText(of.item.tube) + " " + of.item.package);
  json list = json::array();
  for (const auto& [key, tubes] : by_reason)
    list.push_back({{"reason", key.second}, {"is_by_plan", key.first}, {"tubes", tubes}, {"named", namedText(tubes)}});
  std::stable_sort(list.begin(), list.end(), [](const json& one, const json& other) {
    return std::pair(one["is_by_plan"], other["tubes"].size()) < std::pair(other["is_by_plan"], one["tubes"].size());
  });
  return list;
}

json retestsJson(const std::vector<MarkedItem>& retests) {
  json list = json::array();
  for (const MarkedItem& of : retests)
    list.push_back({{"tube", addressText(of.item.tube)},
                    {"package", of.item.package},
                    {"mark", of.event->value},
                    {"reason", of.event->reason},
                    {"who", of.event->person},
                    {"at", of.event->at}});
  return list;
}

json wrongJson(const std::vector<JobEvent>& wrong, const std::vector<JobEvent>& unresolved) {
  json list = json::array();
  for (const JobEvent& event : wrong)
    list.push_back({{"tube", addressText(event.tube)},
                    {"package", event.package},
                    {"found", event.value},
                    {"method", event.method},
                    {"who", event.person},
                    {"at", event.at},
                    {"is_resolved", std::ranges::find(unresolved, event.item, &JobEvent::item) == unresolved.end()}});
  return list;
}

constexpr TextLine kHandOverWords[] = {
    {"", "{title}\n"},
    {"shift", "shift {words}, from {from} to {to}\n"},
    {"!shift", "nothing is recorded yet for {asked}\n"},
    {"later_events", "its totals are of its end; warnings and maps are of the present, after {} later event(|s)\n"},
    {"!events", "no event is recorded in this shift\n"},
    {"people",
     "  {who}: marked {marked}, confirmed {confirmed}, found another tube {wrong} time(|s), undid {undone}\n"},
    {"wrong_tubes", "warning: at {tube} {who} found {found} ({at})\n"},
    {"plugged_at_one_end", "warning: {} is plugged at this end only\n"},
    {"plugged_in_the_meantime", "warning: {tube} is plugged, but still to be visited in the package {package}\n"},
    {"held", "held: {named}: {reason}\n"},
    {"", "{#retests} to be visited again; {total/done} of {total/planned} done, {total/unresolved} unresolved\n"},
};

}  // namespace

std::string handOverText(const json& hand_over) { return textOf(hand_over, kHandOverWords); }

json handOverJson(JobStore& store, const HandOver& of, const HandOverRequest& request, const std::string& made_at) {
  const JobFile& job = store.job();
  const JobTotals totals = totalsOf(store);
  const json warnings = totalsJson(totals, job);
  const std::string plan_text = store.plan();
  const json plan = plan_text.empty() ? json() : json::parse(plan_text);
  json result = {
      {"title", fmt::format("{}: hand-over", job.name)},
      {"job", job.name},
      {"units", unitsJson(job.units)},
      {"made_at", made_at},
      {"last_event", store.lastEvent()},
      {"shift", shiftJson(of.shift, job)},
      {"asked", request.shift.empty() && request.date.empty() ? "any shift" : shiftWords(request.date, request.shift)},
      {"later_events", of.later_events},
      {"total", countsJson(of.total)},
      {"totals", totalsByJson(of.totals)},
      {"shifts", balancesJson(of.shifts)},
      {"people", peopleJson(of.people)},
      {"marks", marksJson()},
      {"held", heldJson(of.held)},
      {"retests", retestsJson(of.retests)},
      {"wrong", wrongJson(of.wrong, totals.wrong_tubes)},
      {"legs", legMapsJson(store, plan)},
      {"letters", standingLettersJson()},
      {"plan", plan},
      {"planned_at", store.plannedAt()}};
  for (const char* key : {"wrong_tubes", "plugged_at_one_end", "plugged_in_the_meantime"}) result[key] = warnings[key];
  result.update(logJson(of.events));
  return result;
}

}  // namespace tubeplan::app
