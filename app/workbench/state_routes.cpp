// The shared state, its results, undo and the jobs.
#include "app/input_error.hpp"
#include "app/workbench/routes.hpp"
#include "app/workbench/state_json.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

Answer state(Workbench& workbench, const Request&) { return answerOf(stateJson(workbench)); }

Answer result(Workbench& workbench, const Request& request) {
  const auto found = findResult(workbench.situation(), request.words[1]);
  if (!found)
    return refusal(404, InputError(inQuotes(request.words[1]), "no such result yet", "one that was asked for"));
  nlohmann::json document = found->document;
  document["model"] = found->model;
  document["revision"] = found->revision;
  return answerOf(document);
}

Answer step(Workbench& workbench, bool back) {
  const bool done = workbench.change([&](Situation& situation) {
    if (back ? situation.current == 0 : situation.current + 1 >= situation.models.size()) return false;
    situation.current += back ? std::size_t(-1) : 1;
    return true;
  });
  if (!done) return refusal(409, InputError("models", back ? "nothing to undo" : "nothing to redo", "a step"));
  return answerOf(stateJson(workbench));
}

Answer undo(Workbench& workbench, const Request&) { return step(workbench, true); }
Answer redo(Workbench& workbench, const Request&) { return step(workbench, false); }

Answer cancel(Workbench& workbench, const Request& request) {
  const auto id = tubesheets::parseNumber(request.words[1]);
  const bool is_id = id && *id >= 0 && *id < 1e9;
  const auto job = is_id ? workbench.jobs().cancel(static_cast<int>(*id)) : std::nullopt;
  if (!job) return refusal(404, InputError("job", inQuotes(request.words[1]), "the number of a job"));
  return answerOf(*job);
}

constexpr Route kRoutes[] = {
    {"GET", "state", state}, {"GET", "results/*", result},      {"POST", "undo", undo},
    {"POST", "redo", redo},  {"POST", "jobs/*/cancel", cancel},
};

}  // namespace

std::span<const Route> stateRoutes() { return kRoutes; }

}  // namespace tubeplan::app
