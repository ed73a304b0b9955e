// Files of the opened folder: cells and readings in, everything that was made out.
#include <fmt/format.h>

#include "app/input_error.hpp"
#include "app/reading_input.hpp"
#include "app/workbench/moments_json.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/routes.hpp"
#include "app/workbench/state_json.hpp"

namespace tubeplan::app {

namespace {

constexpr std::size_t kMostReadings = 20000;  // every look at them solves the arm's shape as often

Answer files(Workbench& workbench, const Request&) {
  const OpenedFolder& folder = workbench.folder();
  return answerOf(
      {{"folder", folder.path().string()}, {"cells", folder.names(".yaml")}, {"measurements", folder.names(".csv")}});
}

Answer noReadings() { return refusal(404, InputError("measurements", "none loaded", "some")); }

Answer readings(Workbench& workbench, const Request&) {
  const Situation situation = workbench.situation();
  return situation.readings ? answerOf(readingsJson(currentModel(situation), *situation.readings)) : noReadings();
}

Answer moments(Workbench& workbench, const Request&) {
  const Situation situation = workbench.situation();
  return situation.readings ? answerOf(momentsJson(currentModel(situation).cell, *situation.readings)) : noReadings();
}

void take(Workbench& workbench, std::shared_ptr<const ReadingSet> set) {
  if (set->readings.size() > kMostReadings)
    throw InputError(set->name, fmt::format("{} readings", set->readings.size()),
                     fmt::format("at most {} in the workbench", kMostReadings), "the commands take more");
  workbench.change([&](Situation& situation) {
    situation.readings = std::move(set);
    forgetResultsOfReadings(situation);
    return true;
  });
}

Answer uploadReadings(Workbench& workbench, const Request& request) {
  const auto name = request.query.find("name");
  auto set = std::make_shared<ReadingSet>();
  set->name = name == request.query.end() || name->second.empty() ? "readings.csv" : name->second.substr(0, 200);
  Cell cell = currentModel(workbench.situation()).cell;
  auto [readings, checks] = parseAndCheck(request.body, set->name, cell, {});
  set->readings = std::move(readings);
  set->checks = std::move(checks);
  take(workbench, set);
  return answerOf(stateJson(workbench));
}

Answer openReadingsFile(Workbench& workbench, const Request& request) {
  const auto path = workbench.folder().fileToRead(textOf(objectOf(request), "file"));
  take(workbench, openReadings({path.string()}, currentModel(workbench.situation()).cell));
  return answerOf(stateJson(workbench));
}

Answer openCellFile(Workbench& workbench, const Request& request) {
  const auto path = workbench.folder().fileToRead(textOf(objectOf(request), "file"));
  if (workbench.jobs().isBusy()) return refusal(409, InputError("cell", "a job that is not done yet", "none"));
  Situation opened = openCell(path.string(), "");
  workbench.change([&](Situation& situation) {
    opened.revision = situation.revision;
    situation = std::move(opened);
    return true;
  });
  return answerOf(stateJson(workbench));
}

constexpr Route kRoutes[] = {
    {"GET", "files", files},
    {"GET", "measurements", readings},
    {"GET", "moments", moments},
    {"POST", "measurements", uploadReadings},
    {"POST", "measurements/open", openReadingsFile},
    {"POST", "cell/open", openCellFile},
};

}  // namespace

std::span<const Route> fileRoutes() { return kRoutes; }

}  // namespace tubeplan::app
