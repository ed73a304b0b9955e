// Routes for the shared state, its results, undo and jobs.
#include <fmt/format.h>

#include <limits>

#include "app/storage/input_error.hpp"
#include "app/workbench/history.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/routes.hpp"
#include "app/workbench/state_json.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

Answer state(Workbench& workbench, const Request&) { return answerOf(stateJson(workbench)); }

/// Returns the result of the model given by "?model="; without this parameter, the result of findResult().
ResultPointer requestedResult(const Session& session, const Request& request) {
  const auto model_parameter = request.query.find("model");
  if (model_parameter == request.query.end()) return findResult(session, request.words[1]);
  const auto model = tubesheets::parseNumber(model_parameter->second);
  const bool is_id = model && *model >= 0 && *model < 1e9;
  return is_id ? findResult(session, request.words[1], static_cast<int>(*model)) : nullptr;
}

Answer result(Workbench& workbench, const Request& request) {
  const auto found = requestedResult(workbench.session(), request);
  if (!found)
    return refusal(404,
                   InputError::problem(inQuotes(request.words[1]), "there is no such result yet", "compute it first"));
  nlohmann::json document = found->document;
  document["model"] = found->model;
  document["revision"] = found->revision;
  return answerOf(document);
}

Answer undo(Workbench& workbench, const Request&) {
  if (!workbench.change(stepBack)) return refusal(409, InputError::problem("models", "there is nothing to undo"));
  return answerOf(stateJson(workbench));
}

Answer redo(Workbench& workbench, const Request&) {
  if (!workbench.change(stepForward)) return refusal(409, InputError::problem("models", "there is nothing to redo"));
  return answerOf(stateJson(workbench));
}

/// Renames a model of the stack, for the request {"model": id, "label"}.
Answer rename(Workbench& workbench, const Request& request) {
  constexpr std::size_t kLongest = 120;
  const auto body = objectOf(request);
  const int id = integerOf(body, "model", -1, 0, std::numeric_limits<int>::max());
  const std::string label = textOf(body, "label");
  if (label.find_first_not_of(' ') == std::string::npos || label.size() > kLongest)
    throw InputError("request (label)", inQuotes(label), fmt::format("a name of 1 to {} characters", kLongest));
  if (workbench.jobs().isBusy())
    return refusal(409, InputError::problem("models", "a model cannot be renamed while a job is running",
                                            "wait until it finishes, or stop it"));
  const auto give = [&](Session& session) {
    const auto at = findModel(session, id);
    if (!at) return false;
    auto renamed = std::make_shared<Model>(*session.models[*at]);
    renamed->label = label;
    session.models[*at] = std::move(renamed);
    return true;
  };
  const bool found = workbench.change(give, false);
  if (!found) return refusal(404, InputError("model", std::to_string(id), "the number of a model"));
  return answerOf(stateJson(workbench));
}

/// Makes the model {"model": id} of the stack current; the models above it are kept for redo.
Answer goTo(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const int id = integerOf(body, "model", -1, 0, std::numeric_limits<int>::max());
  const bool found = workbench.change([&](Session& session) {
    const auto at = findModel(session, id);
    if (at) session.current = *at;
    return at.has_value();
  });
  if (!found) return refusal(404, InputError("model", std::to_string(id), "the number of a model"));
  return answerOf(stateJson(workbench));
}

Answer cancel(Workbench& workbench, const Request& request) {
  const auto id = tubesheets::parseNumber(request.words[1]);
  const bool is_id = id && *id >= 0 && *id < 1e9;
  const auto job = is_id ? workbench.jobs().cancel(static_cast<int>(*id)) : std::nullopt;
  if (!job) return refusal(404, InputError("job", inQuotes(request.words[1]), "the number of a job"));
  return answerOf(*job);
}

constexpr Route kStateRoutes[] = {
    {"GET", "state", state},
    {"GET", "results/*", result},
    {"POST", "undo", undo},
    {"POST", "redo", redo},
    {"POST", "models/go", goTo},
    {"POST", "models/rename", rename},
    {"POST", "jobs/*/cancel", cancel},
};

}  // namespace

std::span<const Route> stateRoutes() { return kStateRoutes; }

}  // namespace tubeplan::app
