// Table of the workbench's addresses, one row for each. The handlers are in *_routes.cpp, by subject.
#pragma once

#include <span>
#include <string_view>

#include "app/workbench/exchange.hpp"
#include "app/workbench/workbench.hpp"

namespace tubeplan::app {

/// Address with its handler. `path` omits "/api/"; a star in it matches one path segment. A handler throws InputError
/// for bad input (status 422) and nlohmann's exceptions for a body of the wrong structure (status 400).
struct Route {
  std::string_view method, path;
  Answer (*answer)(Workbench& workbench, const Request& request);
  bool is_of_file =
      false;  ///< true if the units in the answer are those of a file of the user, which are not converted
};

[[nodiscard]] std::span<const Route> geometryRoutes();
[[nodiscard]] std::span<const Route> stateRoutes();
[[nodiscard]] std::span<const Route> fileRoutes();
[[nodiscard]] std::span<const Route> measurementRoutes();
[[nodiscard]] std::span<const Route> loopRoutes();
[[nodiscard]] std::span<const Route> calibrateRoutes();
[[nodiscard]] std::span<const Route> planRoutes();
[[nodiscard]] std::span<const Route> exportRoutes();
[[nodiscard]] std::span<const Route> liveRoutes();
[[nodiscard]] std::span<const Route> outageRoutes();

/// Calls the handler of a request. Figures are in the units that the request names, otherwise in those of the cell's
/// file. Converts every exception to an answer; throws nothing.
[[nodiscard]] Answer answer(Workbench& workbench, const Request& request);

}  // namespace tubeplan::app
