// Routes for data of a running arm: its encoders, and single readings.
#include "app/workbench/live.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/routes.hpp"

namespace tubeplan::app {

namespace {

/// Shows {"joints", "load"?}, in the cell's units.
Answer encoders(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const Session session = workbench.session();
  const Cell& cell = currentModel(session).cell;
  return answerOf(showEncoders(workbench, jointsOf(body, cell), loadOf(body, cell), "POST"));
}

/// Takes the text of a measurement file with readings of new ids.
Answer takeReadings(Workbench& workbench, const Request& request) {
  const std::size_t waiting = takeArrived(workbench, request.body, "request", false);
  joinArrived(workbench);
  return answerOf({{"waiting", workbench.arrivals().isEmpty() ? 0 : waiting}}, 202);
}

constexpr Route kLiveRoutes[] = {
    {"POST", "live/encoders", encoders},
    {"POST", "live/readings", takeReadings},
};

}  // namespace

std::span<const Route> liveRoutes() { return kLiveRoutes; }

}  // namespace tubeplan::app
