// Open table of the workbench's addresses: one row per address, the handlers by subject in *_routes.cpp.
#pragma once

#include <span>
#include <string_view>

#include "app/workbench/exchange.hpp"
#include "app/workbench/workbench.hpp"

namespace tubeplan::app {

/// Address with its handler. `path` is without "/api/"; a star matches one word of it. A handler throws InputError for
/// bad input (422) and nlohmann's exceptions for a body of another shape (400).
struct Route {
  std::string_view method, path;
  Answer (*answer)(Workbench& workbench, const Request& request);
};

[[nodiscard]] std::span<const Route> geometryRoutes();
[[nodiscard]] std::span<const Route> stateRoutes();
[[nodiscard]] std::span<const Route> fileRoutes();
[[nodiscard]] std::span<const Route> readingRoutes();
[[nodiscard]] std::span<const Route> loopRoutes();
[[nodiscard]] std::span<const Route> calibrateRoutes();
[[nodiscard]] std::span<const Route> planRoutes();
[[nodiscard]] std::span<const Route> exportRoutes();
[[nodiscard]] std::span<const Route> liveRoutes();

/// Finds the row and answers; every exception becomes an answer, and nothing is thrown.
[[nodiscard]] Answer answer(Workbench& workbench, const Request& request);

}  // namespace tubeplan::app
