// Hand-over of a shift: its work, the open issues for the next shift, and the remaining work.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/outage/job_totals.hpp"

namespace tubeplan::app {

/// Selects the shift of a hand-over: the latest shift with an event if no date is given, any shift if no name is given.
struct HandOverRequest {
  std::string shift, date;
};

/// Totals of all items by one of their properties.
struct TotalsBy {
  std::string by;  ///< "package and leg", "package", "leg" or "zone"
  std::vector<std::pair<std::string, ItemCounts>> rows;
};

/// Events of one person in the shift.
struct PersonsWork {
  std::string person;
  std::map<std::string, int> marks;  ///< number of marks that were not undone, by the name of the mark
  int confirmed = 0, wrong = 0;      ///< numbers of confirmations of the intended tube, and of another tube
  int undone = 0;                    ///< number of marks, of any person, that this person undid
};

/// An item with its latest mark that was not undone; the event is null for items without one.
struct MarkedItem {
  JobItem item;
  std::optional<JobEvent> event;
};

struct HandOver {
  std::optional<ShiftOfDay> shift;  ///< the shift; std::nullopt if no shift of the request has an event
  std::vector<JobEvent> events;     ///< events of the shift
  std::vector<PersonsWork> people;
  int later_events = 0;  ///< number of events after the end of the shift
  ItemCounts total;      ///< counts of all items at the end of the shift, like all later members except `shifts`
  std::vector<TotalsBy> totals;
  std::vector<ShiftBalance> shifts;  ///< all shifts with an event, in order of their start
  std::vector<MarkedItem> held;      ///< items held by decision, or because the plan does not reach them
  std::vector<MarkedItem> retests;   ///< queued items, in descending order of waiting time
  std::vector<JobEvent> wrong;       ///< confirmations of the shift that found another tube
};

/// Returns the hand-over of a shift. Throws InputError for a shift that the job does not have, and for a malformed
/// date.
[[nodiscard]] HandOver handOverOf(JobStore& store, const HandOverRequest& request);

}  // namespace tubeplan::app
