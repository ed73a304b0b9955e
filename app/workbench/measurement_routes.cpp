// Routes for measurements: opening, upload, import of tables from other programs, assumptions, marks, and removal of
// added measurements.
#include <fmt/format.h>

#include <functional>
#include <sstream>

#include "app/documents/foreign_json.hpp"
#include "app/documents/leverage_json.hpp"
#include "app/documents/moments_json.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/formats/foreign/foreign_measurements.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/formats/other_file.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/text_file.hpp"
#include "app/workbench/job_routes.hpp"
#include "app/workbench/measurement_sets.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/routes.hpp"
#include "app/workbench/state_json.hpp"

namespace tubeplan::app {

namespace {

// Largest number of loaded measurements; it is limited because each check solves the arm's shape once per measurement.
constexpr std::size_t kMostLoaded = Arrivals::kMost;

Answer noMeasurements() { return refusal(404, withoutMeasurements()); }

Answer jobRuns() {
  return refusal(409, InputError::problem("readings", "they cannot be changed while a job is running",
                                          "wait until it finishes, or stop it"));
}

Answer measurements(Workbench& workbench, const Request&) {
  const Session session = workbench.session();
  return session.measurements ? answerOf(measurementsJson(currentModel(session), *session.measurements))
                              : noMeasurements();
}

Answer moments(Workbench& workbench, const Request&) {
  const Session session = workbench.session();
  return session.measurements ? answerOf(momentsJson(currentModel(session).cell, session.measurements->measurements))
                              : noMeasurements();
}

/// Returns the names in the query parameter "at", such as "theta3,forearm.z".
std::vector<std::string> namesAt(const Request& request) {
  std::vector<std::string> names;
  std::stringstream text(request.parameter("at"));
  for (std::string name; std::getline(text, name, ',');) names.push_back(name);
  return names;
}

Answer leverage(Workbench& workbench, const Request& request) {
  const Session session = workbench.session();
  if (!session.measurements) return noMeasurements();
  return answerOf(leverageJson(currentModel(session).cell, session.measurements->measurements, namesAt(request)));
}

/// Loads the measurements; `changeSession` applies further changes in the same undoable step.
void take(
    Workbench& workbench, std::shared_ptr<MeasurementSet> set,
    const std::function<void(Session&)>& changeSession = [](Session&) {}) {
  if (set->measurements.size() > kMostLoaded)
    throw InputError(set->name, fmt::format("{} readings", set->measurements.size()),
                     fmt::format("at most {} in the workbench", kMostLoaded), "use the command line for more");
  workbench.change([&](Session& session) {
    putMeasurements(session, set);
    changeSession(session);
    return true;
  });
}

std::string shortName(const std::string& name) { return name.empty() ? "readings.csv" : name.substr(0, 200); }

Answer takeText(Workbench& workbench, const std::string& text, const std::string& name, double sigma = 0) {
  Cell cell = currentModel(workbench.session()).cell;
  take(workbench, readSet({{}, text, sigma, {}}, shortName(name), cell));
  return answerOf(stateJson(workbench));
}

/// Reads the measurements again under assumptions that correct suspected mistakes, for the request {"assume":
/// ["coordinates=in"]}, like the option --assume of the commands. `as-is` states that the measurements are correct; an
/// empty list revokes all assumptions.
Answer assume(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  (void)requiredOf(body, "assume", "a list of NAME=VALUE, as for the option --assume");
  const auto names = textsOf(body, "assume");
  if (workbench.jobs().isBusy()) return jobRuns();
  const Session session = workbench.session();
  if (!session.measurements) return noMeasurements();
  if (!session.measurements->source)
    return refusal(
        409, InputError::problem("readings", "the file of the readings is no longer available", "open the file again"));
  MeasurementSource source = *session.measurements->source;
  if (names.empty()) source.assumed.clear();
  source.assumed.insert(source.assumed.end(), names.begin(), names.end());
  Cell cell = currentModel(session).cell;
  const bool was_known = cell.base_known;
  const auto set = readSet(std::move(source), session.measurements->name, cell);
  keepMarks(*session.measurements, *set);
  set->joined = session.measurements->joined;
  take(workbench, set, [&](Session& now) {
    if (!was_known || cell.base_known) return;
    const Cell& known = currentModel(session).cell;
    const BaseChange unknown{known.X_WB, std::nullopt, false};
    (void)pushModel(now, "base not known", "assumption",
                    rereadCell(known, cellTextWithBase(known, unknown, known.path)));
  });
  return answerOf(stateJson(workbench));
}

Answer uploadMeasurements(Workbench& workbench, const Request& request) {
  return takeText(workbench, request.body, request.parameter("name"));
}

/// Returns the tables of {"tables": [{"name", "text"}]}, written by other programs.
std::vector<ForeignTable> foreignTablesOf(const nlohmann::json& body) {
  std::vector<ForeignTable> tables;
  for (const auto& table : requiredOf(body, "tables", "tables of text")) {
    const std::string name = shortName(textOf(table, "name"));
    const std::string text = textOf(table, "text");
    requireTable(name, text);
    checkText(name, text);
    tables.push_back(parseForeignTable(text, name));
  }
  if (tables.empty())
    throw InputError::problem("request (tables)", "the list is empty", "send at least one table, as text");
  return tables;
}

/// Returns the import request {"tables", "columns"?: ["x_mm=points.txt:X"], "kind"?, "orientation"?, "points"?,
/// "dates"?}, which corresponds to the options of `readings`.
ForeignRequest foreignOf(const nlohmann::json& body) {
  return {foreignTablesOf(body),
          {textsOf(body, "columns"), {}, textOf(body, "orientation"), textOf(body, "points"), textOf(body, "dates")},
          textOf(body, "kind")};
}

/// Returns the likely meanings of the columns of foreign tables.
Answer foreignColumns(Workbench& workbench, const Request& request) {
  return answerOf(foreignColumnsJson(foreignOf(objectOf(request)), currentModel(workbench.session()).cell));
}

/// Converts foreign tables to measurements and loads them; {"sigma"?} is the noise if no column states it.
Answer takeForeign(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const ForeignRequest foreign = foreignOf(body);
  const auto measurements = readForeign(foreign, currentModel(workbench.session()).cell.arm);
  return takeText(workbench, measurements.text, foreign.tables.front().file, numberOf(body, "sigma", 0));
}

Answer openMeasurementsFile(Workbench& workbench, const Request& request) {
  const auto path = workbench.folder().fileToRead(textOf(objectOf(request), "file"));
  take(workbench, openMeasurements({path.string()}, currentModel(workbench.session()).cell));
  return answerOf(stateJson(workbench));
}

std::set<std::string> idsOf(const MeasurementSet& set) {
  std::set<std::string> ids;
  for (const auto& measurement : set.measurements) ids.insert(measurement.id);
  return ids;
}

void requireIds(const MeasurementSet& set, const std::vector<std::string>& ids) {
  const auto known = idsOf(set);
  for (const auto& id : ids)
    if (!known.contains(id)) throw InputError("ids", inQuotes(id), "the id of a reading");
}

/// Returns the set with the measurements `ids` set aside, or in use again. Throws InputError if no measurement would
/// remain in use.
MeasurementSet withSetAside(MeasurementSet set, const std::vector<std::string>& ids, bool aside) {
  for (const auto& id : ids) {
    if (aside)
      set.set_aside.insert(id);
    else
      set.set_aside.erase(id);
  }
  if (set.set_aside.size() >= set.measurements.size())
    throw InputError::problem("ids", "all readings would be set aside", "leave some in use");
  return set;
}

/// Returns the set with the measurements `ids` held out of fits, or fitted again. Throws InputError if no measurement
/// would remain to fit.
MeasurementSet withHeldOut(MeasurementSet set, const std::vector<std::string>& ids, bool held_out) {
  const std::set<std::string> chosen(ids.begin(), ids.end());
  std::size_t fitted = 0;
  for (auto& measurement : set.measurements) {
    if (chosen.contains(measurement.id)) measurement.is_held_out = held_out;
    fitted += !measurement.is_held_out && !set.set_aside.contains(measurement.id) ? 1 : 0;
  }
  if (fitted == 0) throw InputError::problem("ids", "no reading would be left to fit", "hold out fewer");
  return set;
}

/// Marks measurements, for the request {"ids", and `word`: true or false}, and deletes the results obtained with the
/// previous marks.
Answer mark(Workbench& workbench, const Request& request, const char* word,
            MeasurementSet (*marked)(MeasurementSet, const std::vector<std::string>&, bool)) {
  const auto body = objectOf(request);
  const auto ids = textsOf(body, "ids");
  const bool is_on = booleanOf(body, word, true);
  if (workbench.jobs().isBusy()) return jobRuns();
  bool has_measurements = false;
  workbench.change([&](Session& session) {
    has_measurements = session.measurements != nullptr;
    if (!has_measurements) return false;
    requireIds(*session.measurements, ids);
    putMeasurements(session, std::make_shared<MeasurementSet>(marked(*session.measurements, ids, is_on)));
    return true;
  });
  return has_measurements ? answerOf(stateJson(workbench)) : noMeasurements();
}

Answer setAside(Workbench& workbench, const Request& request) {
  return mark(workbench, request, "aside", withSetAside);
}

Answer holdOut(Workbench& workbench, const Request& request) {
  return mark(workbench, request, "held_out", withHeldOut);
}

/// Removes the measurements that were added last; the marks on the remaining measurements are kept.
Answer part(Workbench& workbench, const Request&) {
  if (workbench.jobs().isBusy()) return jobRuns();
  const Session session = workbench.session();
  if (!session.measurements) return noMeasurements();
  if (joinedCount(*session.measurements) == 0)
    return refusal(409, InputError::problem("readings", "there are no added readings to remove", "add readings first"));
  take(workbench, partedSet(*session.measurements, currentModel(session).cell));
  return answerOf(stateJson(workbench));
}

constexpr Route kMeasurementRoutes[] = {
    {"GET", "measurements", measurements},
    {"GET", "moments", moments},
    {"GET", "leverage", leverage},
    {"POST", "measurements", uploadMeasurements},
    {"POST", "measurements/columns", foreignColumns, true},
    {"POST", "measurements/foreign", takeForeign},
    {"POST", "measurements/open", openMeasurementsFile},
    {"POST", "measurements/set-aside", setAside},
    {"POST", "measurements/hold-out", holdOut},
    {"POST", "measurements/assume", assume},
    {"POST", "measurements/part", part},
};

}  // namespace

std::span<const Route> measurementRoutes() { return kMeasurementRoutes; }

}  // namespace tubeplan::app
