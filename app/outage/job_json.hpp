// Contents of a job's record as JSON documents and as text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/outage/job_desk.hpp"
#include "app/outage/job_totals.hpp"

namespace tubeplan::app {

/// Returns {planned, done, excluded, unresolved, open, queued, held, percent}; `percent` refers to the items that are
/// not excluded.
[[nodiscard]] nlohmann::json countsJson(const ItemCounts& counts);

/// Returns {job, packages: [{package, steam_generator, leg, planned, done, excluded, unresolved, open, queued, held,
/// percent}], total, shifts: [{date, shift, done}], plugged_at_one_end: [ADDRESS],
/// plugged_in_the_meantime: [{tube, package}], wrong_tubes: [{tube, found, who, at}]}.
[[nodiscard]] nlohmann::json totalsJson(const JobTotals& totals, const JobFile& job);
[[nodiscard]] std::string totalsText(const nlohmann::json& totals);

/// Returns {tube, package, steam_generator, leg, row, column, x, y, tool, extent, confirm, standing, last_event, left,
/// history: [EVENT], units}, with lengths in the job's units. `left` counts the items of the part that are to be
/// visited. If nothing is left, `tube` is null and only `left` follows.
[[nodiscard]] nlohmann::json nextJson(JobStore& store, const JobPart& part);
[[nodiscard]] std::string nextText(const nlohmann::json& next);

/// Returns {tube, found, same, reason} for a confirmation of the intended tube.
[[nodiscard]] nlohmann::json findingJson(const TubeAddress& meant, const IdentityFinding& finding);

/// Returns {events: [{event, at, who, kind, package, tube, value, method, reason, undoes, undone}]}.
[[nodiscard]] nlohmann::json logJson(const std::vector<JobEvent>& events);
[[nodiscard]] std::string logText(const nlohmann::json& log);

}  // namespace tubeplan::app
