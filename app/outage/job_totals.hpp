// Totals of a job: planned = done + excluded + unresolved, for every package on every leg, and the work of every shift.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/outage/job_shifts.hpp"
#include "app/outage/job_store.hpp"

namespace tubeplan::app {

struct ItemCounts {
  int planned = 0;                   ///< number of all items
  std::map<ItemStanding, int> with;  ///< number of items in each standing (open, queued, held, done, excluded)

  void add(ItemStanding standing);
  void move(ItemStanding from, ItemStanding to);  ///< counts an item whose standing has changed
  [[nodiscard]] int of(ItemStanding standing) const;
  [[nodiscard]] int unresolved() const;
};

/// Counts of one package on one leg.
struct PackageTotal {
  std::string package, generator;
  tubesheets::Leg leg = tubesheets::Leg::kHot;
  ItemCounts counts;
};

/// Work of one shift, and the standing of all items at its end. Over all shifts, `done` less `reopened` is the number
/// of items that are done.
struct ShiftBalance {
  ShiftOfDay shift;
  int marks = 0;     ///< marks recorded in the shift that were not undone
  int done = 0;      ///< items done at the end of the shift, but not at its start
  int reopened = 0;  ///< items done at the start of the shift, but not at its end
  ItemCounts at_end;
};

struct JobTotals {
  std::vector<PackageTotal> packages;
  ItemCounts all;
  std::vector<ShiftBalance> shifts;  ///< every shift with an event, in the order of their beginnings
  /// Tubes plugged at only one end: the other end is not yet plugged, or the wrong tube was plugged.
  std::vector<TubeAddress> plugged_at_one_end;
  /// Items to be visited whose tube end has been plugged in the meantime, so that no visit is possible.
  std::vector<JobItem> plugged_in_the_meantime;
  /// Items whose latest confirmation found another tube.
  std::vector<JobEvent> wrong_tubes;
};

[[nodiscard]] JobTotals totalsOf(JobStore& store);

[[nodiscard]] ItemCounts countsOf(const std::vector<JobItem>& items);

/// Returns the items as they stood at a time: later marks and undos are left out. Tubes that the plan does not reach
/// have no time; their current state is used.
[[nodiscard]] std::vector<JobItem> itemsAt(std::vector<JobItem> items, const std::vector<JobEvent>& events,
                                           const std::string& time);

[[nodiscard]] std::vector<ShiftBalance> balancesOf(const std::vector<JobItem>& items,
                                                   const std::vector<JobEvent>& events,
                                                   const std::vector<JobShift>& shifts);

}  // namespace tubeplan::app
