#include "app/workbench/routes.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "app/storage/input_error.hpp"
#include "app/storage/json_value.hpp"
#include "app/workbench/shown_units.hpp"

namespace tubeplan::app {

namespace {

using RouteTable = std::span<const Route> (*)();
constexpr RouteTable kTables[] = {stateRoutes,     geometryRoutes, fileRoutes,   measurementRoutes, loopRoutes,
                                  calibrateRoutes, planRoutes,     exportRoutes, liveRoutes,        outageRoutes};

bool fits(std::string_view path, const std::vector<std::string>& words) {
  std::size_t k = 0;
  for (std::size_t from = 0; from <= path.size(); ++k) {
    const std::size_t to = std::min(path.find('/', from), path.size());
    const std::string_view word = path.substr(from, to - from);
    if (k >= words.size() || (word != "*" && word != words[k])) return false;
    from = to + 1;
  }
  return k == words.size();
}

/// Finds the route of a request; null if there is none. `known_path` is set to true if the path exists, possibly for
/// another method, which distinguishes status 405 from 404.
const Route* findRoute(const Request& request, bool& known_path) {
  known_path = false;
  for (const RouteTable table : kTables)
    for (const Route& route : table()) {
      if (!fits(route.path, request.words)) continue;
      known_path = true;
      if (route.method == request.method) return &route;
    }
  return nullptr;
}

/// Calls a handler. Its figures are converted from and to the units that the request names.
Answer answerBy(const Route& route, Workbench& workbench, const Request& request) {
  const auto units = ShownUnits::of(request);
  if (!units) return route.answer(workbench, request);
  Answer answer = route.answer(workbench, units->inFileUnits(request, workbench.session()));
  return route.is_of_file ? answer : units->shown(std::move(answer), workbench.session());
}

std::string pathOf(const Request& request) {
  std::string path = "/api";
  for (const auto& word : request.words) path += "/" + word;
  return path;
}

}  // namespace

Answer answer(Workbench& workbench, const Request& request) {
  try {
    bool known_path = false;
    const Route* route = findRoute(request, known_path);
    if (route) return answerBy(*route, workbench, request);
    if (known_path)
      return refusal(405, InputError::problem(pathOf(request), "this address does not accept " + request.method,
                                              "docs/workbench_api.md lists the methods of every address"));
    return refusal(404, InputError::problem(pathOf(request), "the workbench has no such address",
                                            "docs/workbench_api.md lists the valid addresses"));
  } catch (const NotJson& error) {
    return refusal(400, error);
  } catch (const InputError& error) {
    return refusal(422, error);
  } catch (const nlohmann::json::exception&) {
    return refusal(400, InputError::problem("request body", "a value is not of the kind that this address expects",
                                            "docs/workbench_api.md describes the values that it expects"));
  } catch (const std::filesystem::filesystem_error& error) {
    return refusal(422, inputErrorOf(error));
  } catch (const std::exception& error) {
    fmt::print(stderr, "tubeplan: {} {}: internal error: {}\n", request.method, pathOf(request), error.what());
    return refusal(500, InputError::problem(pathOf(request), "the program has failed (an internal error)",
                                            "the terminal in which it runs shows the reason"));
  }
}

}  // namespace tubeplan::app
