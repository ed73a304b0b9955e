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
  std::map<ItemStanding, int> with;  ///< number of items with each standing

  void add(ItemStanding standing);
  [[nodiscard]] int of(ItemStanding standing) const;
  [[nodiscard]] int unresolved() const;
};

/// Counts of one package on one leg.
struct PackageTotal {
  std::string package, generator;
  tubesheets::Leg leg = tubesheets::Leg::kHot;
  ItemCounts counts;
};

/// Marks that finished an item, recorded during one shift.
struct ShiftTotal {
  ShiftOfDay shift;
  int done = 0;
};

struct JobTotals {
  std::vector<PackageTotal> packages;
  ItemCounts all;
  std::vector<ShiftTotal> shifts;
  /// Tubes that are plugged at one end only: the other end is still to be plugged, or the wrong tube was.
  std::vector<TubeAddress> plugged_at_one_end;
  /// Items that are to be visited, at ends that were plugged in the meantime: nobody can visit them any more.
  std::vector<JobItem> plugged_in_the_meantime;
  /// Items whose latest confirmation found another tube.
  std::vector<JobEvent> wrong_tubes;
};

[[nodiscard]] JobTotals totalsOf(JobStore& store);

}  // namespace tubeplan::app
