// Routes for data from a running arm: encoder readings and new measurements.
#include "app/workbench/live.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/routes.hpp"

namespace tubeplan::app {

namespace {

/// Shows the posture {"joints", "load"?}, in the cell's units, in all browsers.
Answer encoders(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const Session session = workbench.session();
  const Cell& cell = currentModel(session).cell;
  return answerOf(showEncoders(workbench, jointsOf(body, cell), loadOf(body, cell), "POST"));
}

/// Queues the measurements in the text of a measurement file; their ids must be new.
Answer takeMeasurements(Workbench& workbench, const Request& request) {
  const std::size_t waiting = takeArrived(workbench, request.body, "request", false);
  joinArrived(workbench);
  return answerOf({{"waiting", workbench.arrivals().isEmpty() ? 0 : waiting}}, 202);
}

constexpr Route kLiveRoutes[] = {
    {"POST", "live/encoders", encoders},
    {"POST", "live/readings", takeMeasurements},
};

}  // namespace

std::span<const Route> liveRoutes() { return kLiveRoutes; }

}  // namespace tubeplan::app
