#include "app/outage/job_desk.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "app/storage/input_error.hpp"
#include "app/storage/named_entry.hpp"

namespace tubeplan::app {

namespace {

/// Throws InputError, naming the option, for a name that no entry has; an empty name means all entries.
template <class Entry>
void requireName(const char* option, const std::string& name, const std::vector<Entry>& entries) {
  if (!name.empty()) (void)entryNamed(entries, name, option);
}

/// Throws InputError for a mark that contradicts the current standing of the item.
void requireFitting(const JobItem& item, const Mark& mark, const MarkRequest& request) {
  const std::string where = addressText(item.tube);
  const ItemStanding standing = item.standing();
  if (request.after && *request.after != item.last_event)
    throw InputError::problem(
        where,
        fmt::format("its state has changed since event {} (its last event is {})", *request.after, item.last_event),
        "look at `tubeplan job log`, then mark it again without --after");
  if (mark.needs_reason && request.entry.reason.empty())
    throw InputError::problem("--reason", fmt::format("the mark '{}' needs a reason", mark.name),
                              "write --reason TEXT");
  if (standing == ItemStanding::kExcluded && mark.standing != ItemStanding::kOpen)
    throw InputError::problem(where,
                              fmt::format("it is excluded from the package {}{}", item.package,
                                          item.excluded.empty() ? "" : " (" + item.excluded + ")"),
                              "mark it open first, with the reason why");
  if (standing == ItemStanding::kDone && request.entry.reason.empty())
    throw InputError::problem(where, fmt::format("it is already marked {}", item.mark->name),
                              "give --reason if it is to be marked again, or undo that mark");
}

std::string textOf(const std::vector<JobItem>& items) {
  std::vector<std::string> names;
  for (const JobItem& item : items) names.push_back(item.package);
  return enumeration(names);
}

}  // namespace

bool JobPart::has(const JobItem& item) const {
  return (package.empty() || item.package == package) && (generator.empty() || item.tube.generator == generator) &&
         (!leg || item.tube.leg == *leg);
}

void requirePart(const JobFile& job, const JobPart& part) {
  requireName("--package", part.package, job.packages);
  requireName("--sg", part.generator, job.generators);
  if (!part.leg) return;
  std::vector<std::string> legs;
  for (const SteamGenerator& generator : job.generators)
    for (const JobLeg& leg : generator.legs)
      if (part.generator.empty() || part.generator == generator.name) legs.emplace_back(tubesheets::legName(leg.leg));
  std::ranges::sort(legs);
  legs.erase(std::ranges::unique(legs).begin(), legs.end());
  const std::string leg(tubesheets::legName(*part.leg));
  if (std::ranges::find(legs, leg) == legs.end()) throw InputError("--leg", inQuotes(leg), alternatives(legs));
}

std::vector<const JobItem*> itemsToVisit(const std::vector<JobItem>& items, const JobPart& part) {
  const std::set<TubeAddress> plugged = pluggedEnds(items);
  std::vector<const JobItem*> to_visit;
  for (const JobItem& item : items)
    if (item.isDue() && part.has(item) && !plugged.contains(item.tube)) to_visit.push_back(&item);
  return to_visit;
}

std::optional<JobItem> findNext(const std::vector<JobItem>& items, const JobPart& part) {
  const JobItem* queued = nullptr;
  for (const JobItem* item : itemsToVisit(items, part)) {
    if (item->standing() == ItemStanding::kOpen) return *item;
    if (!queued || item->last_event < queued->last_event) queued = item;
  }
  return queued ? std::optional(*queued) : std::nullopt;
}

JobItem requireItem(JobStore& store, const TubeAddress& tube, const std::string& package) {
  requireName("--package", package, store.job().packages);
  std::vector<JobItem> items = store.itemsOf(tube);
  if (!package.empty()) std::erase_if(items, [&](const JobItem& item) { return item.package != package; });
  if (items.empty())
    throw InputError::problem(
        addressText(tube),
        package.empty() ? "no package of the job has this tube" : "the package " + package + " does not have this tube",
        "check its steam generator, leg, row and column");
  if (items.size() > 1)
    throw InputError::problem(addressText(tube), "the tube is in the packages " + textOf(items),
                              "name one of them with --package");
  return items.front();
}

std::int64_t markTube(JobStore& store, const MarkRequest& request) {
  const Mark& mark = entryNamed(marks(), request.mark, "--as");
  std::int64_t event = 0;
  store.transact([&] {
    const JobItem item = requireItem(store, request.tube, request.package);
    requireFitting(item, mark, request);
    const std::string missing = mark.needs_tool ? findMissingConfirmation(store.job().packageOf(item.package),
                                                                          store.eventsOf(item.id), request.entry.person)
                                                : "";
    if (!missing.empty())
      throw InputError::problem(addressText(item.tube), missing, "confirm it first: `tubeplan job confirm`");
    event = store.addMark(item, mark, request.entry);
  });
  return event;
}

IdentityFinding confirmTube(JobStore& store, const ConfirmationRequest& request) {
  IdentityFinding finding;
  store.transact([&] {
    const JobItem item = requireItem(store, request.tube, request.package);
    if (!request.read.empty()) {
      finding = compareRead(item.tube, parseAddress(request.read, "--read-back"));
    } else {
      std::vector<TubeEnd> ends;
      double pitch = 0;
      for (const JobSheet& sheet : store.sheets()) {
        if (sheet.generator != item.tube.generator) continue;
        if (sheet.leg.leg == item.tube.leg) pitch = sheet.pitch;
        const auto of_leg = store.endsOf(sheet.generator, sheet.leg.leg);
        ends.insert(ends.end(), of_leg.begin(), of_leg.end());
      }
      finding = comparePosition(item.tube, request.xy->first, request.xy->second, ends, pitch);
    }
    const auto method = request.read.empty() ? ConfirmationMethod::kPosition : ConfirmationMethod::kReadBack;
    const WorkPackage& package = store.job().packageOf(item.package);
    if (const std::string wrong = findWrongMethod(package, confirmationName(method)); finding.is_same && !wrong.empty())
      throw InputError::problem(addressText(item.tube), wrong,
                                fmt::format("confirm it by {}", confirmationName(package.confirm)));
    const std::string value = finding.is_same ? "same" : finding.found.empty() ? "no hole" : finding.found;
    store.addConfirmation(item, method, value, request.entry);
  });
  return finding;
}

std::int64_t undoMark(JobStore& store, std::int64_t event, const EventEntry& entry) {
  if (event == 0)
    throw InputError::problem("--event", "the event is missing", "`tubeplan job log` lists them with their numbers");
  if (entry.reason.empty()) throw InputError::problem("--reason", "an undo needs a reason", "write --reason TEXT");
  std::int64_t undo = 0;
  store.transact([&] {
    const auto events = store.events();
    const auto found = std::ranges::find(events, event, &JobEvent::id);
    const std::string where = fmt::format("event {}", event);
    if (found == events.end())
      throw InputError::problem(where, "there is no such event", "`tubeplan job log` lists them");
    if (found->kind != "mark") throw InputError::problem(where, "this event is not a mark", "undo a mark");
    if (found->is_undone)
      throw InputError::problem(where, "this event has already been undone", "there is nothing to do");
    for (const JobEvent& later : events)
      if (later.id > event && later.kind == "mark" && !later.is_undone && later.item == found->item)
        throw InputError::problem(where, fmt::format("the tube has a later mark, event {}", later.id),
                                  "undo that one first");
    undo = store.addUndo(*found, entry);
  });
  return undo;
}

}  // namespace tubeplan::app
