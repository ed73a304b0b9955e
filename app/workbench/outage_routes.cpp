// Routes for the desk of a shift: totals, next tube, confirmation, marks, log, plan and hand-over of a job's record in
// the opened folder.
#include <fmt/format.h>

#include "app/outage/hand_over_json.hpp"
#include "app/outage/job_desk.hpp"
#include "app/outage/job_json.hpp"
#include "app/report/outage_report.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/origin.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/routes.hpp"
#include "app/workbench/shown_units.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

constexpr const char* kJobExtension = ".job";  // extension of records in the opened folder

/// Opens the record of a name in the opened folder. Throws InputError if there is none.
JobStore storeNamed(Workbench& workbench, const std::string& name, Database::Mode mode = Database::Mode::kOpen) {
  if (name.empty())
    throw InputError::problem("file", "the name of the job's record is missing", "GET /api/outage lists the records");
  return JobStore(workbench.folder().fileToRead(name).string(), mode);
}

/// Opens the record that a query names, to read it alone.
JobStore requestedStore(Workbench& workbench, const Request& request) {
  return storeNamed(workbench, request.parameter("file"), Database::Mode::kRead);
}

/// Returns the part of the job that query parameters name.
JobPart requestedPart(const Request& request, const JobFile& job) {
  JobPart part{request.parameter("package"), request.parameter("sg"), std::nullopt};
  if (const std::string leg = request.parameter("leg"); !leg.empty()) {
    part.leg = tubesheets::findLeg(leg);
    if (!part.leg) throw InputError("leg", inQuotes(leg), "one of " + tubesheets::legNames());
  }
  requirePart(job, part);
  return part;
}

EventEntry entryOf(const json& body) { return {textOf(body, "by"), textOf(body, "reason"), textOf(body, "at")}; }

TubeAddress tubeOf(const json& body) { return parseAddress(textOf(body, "tube"), "tube"); }

Answer records(Workbench& workbench, const Request&) {
  json words = json::array();
  for (const Mark& mark : marks())
    words.push_back({{"name", mark.name},
                     {"key", std::string(1, mark.key)},
                     {"words", mark.words},
                     {"standing", standingName(mark.standing)},
                     {"needs_tool", mark.needs_tool},
                     {"needs_reason", mark.needs_reason}});
  return answerOf({{"records", workbench.folder().names(kJobExtension)}, {"marks", words}});
}

Answer totals(Workbench& workbench, const Request& request) {
  JobStore store = requestedStore(workbench, request);
  return answerOf(totalsJson(totalsOf(store), store.job()));
}

Answer next(Workbench& workbench, const Request& request) {
  JobStore store = requestedStore(workbench, request);
  return answerOf(nextJson(store, requestedPart(request, store.job())));
}

/// Returns the number of an event in the query; 0 if it is missing.
std::int64_t requestedEvent(const Request& request, const std::string& key) {
  const std::string text = request.parameter(key);
  const auto event = text.empty() ? std::optional(0) : tubesheets::parseInteger(text);
  if (!event || *event < 0) throw InputError(key, inQuotes(text), "the number of an event, as the log lists it");
  return *event;
}

Answer events(Workbench& workbench, const Request& request) {
  JobStore store = requestedStore(workbench, request);
  json log = logJson(store.events(requestedEvent(request, "after")));
  log["planned_at"] = store.plannedAt();
  return answerOf(log);
}

Answer planOfRecord(Workbench& workbench, const Request& request) {
  JobStore store = requestedStore(workbench, request);
  const std::string plan = store.plan();
  return answerOf({{"plan", plan.empty() ? json() : json::parse(plan)}, {"planned_at", store.plannedAt()}});
}

Answer report(Workbench& workbench, const Request& request) {
  JobStore store = requestedStore(workbench, request);
  const HandOverRequest hand_over_request{request.parameter("shift"), request.parameter("date")};
  json report = handOverJson(store, handOverOf(store, hand_over_request), hand_over_request, presentTime());
  stateOrigin(report);
  return downloadOf("handover.html", "text/html", renderHandOverReport(report));
}

Answer confirm(Workbench& workbench, const Request& request) {
  const json body = objectOf(request);
  JobStore store = storeNamed(workbench, textOf(body, "file"));
  ConfirmationRequest confirmation_request{tubeOf(body), textOf(body, "package"), textOf(body, "read_back"),
                                           std::nullopt, entryOf(body)};
  if (confirmation_request.read.empty()) {
    const std::vector<double> position = numbersOf(body, "position");
    if (position.size() != 2) throw InputError("position", fmt::format("{} numbers", position.size()), "x and y");
    const auto units = ShownUnits::of(request);
    const double length = units ? units->lengthFactor(store.job().units) : store.job().units.factor(dimension::kLength);
    confirmation_request.xy = {position[0] * length, position[1] * length};
  }
  return answerOf(findingJson(confirmation_request.tube, confirmTube(store, confirmation_request)));
}

Answer mark(Workbench& workbench, const Request& request) {
  const json body = objectOf(request);
  JobStore store = storeNamed(workbench, textOf(body, "file"));
  MarkRequest mark_request{tubeOf(body), textOf(body, "package"), textOf(body, "as"), entryOf(body), std::nullopt};
  if (body.contains("after")) mark_request.after = integerOf(body, "after", 0, 0, std::numeric_limits<int>::max());
  return answerOf({{"event", markTube(store, mark_request)}});
}

Answer undoEvent(Workbench& workbench, const Request& request) {
  const json body = objectOf(request);
  JobStore store = storeNamed(workbench, textOf(body, "file"));
  const int event = integerOf(body, "event", 0, 0, std::numeric_limits<int>::max());
  return answerOf({{"event", undoMark(store, event, entryOf(body))}});
}

constexpr Route kRoutes[] = {
    {"GET", "outage", records},          {"GET", "outage/totals", totals},     {"GET", "outage/next", next},
    {"GET", "outage/log", events},       {"GET", "outage/plan", planOfRecord}, {"GET", "outage/report", report},
    {"POST", "outage/confirm", confirm}, {"POST", "outage/mark", mark},        {"POST", "outage/undo", undoEvent}};

}  // namespace

std::span<const Route> outageRoutes() { return kRoutes; }

}  // namespace tubeplan::app
