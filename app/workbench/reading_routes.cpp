// Routes for readings: opening, upload, import of tables from other programs, assumptions, marks, and removal of added
// readings.
#include <fmt/format.h>

#include <sstream>

#include "app/documents/foreign_json.hpp"
#include "app/documents/leverage_json.hpp"
#include "app/documents/moments_json.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/formats/foreign/foreign_readings.hpp"
#include "app/formats/measurements/reading_input.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/text_file.hpp"
#include "app/workbench/job_routes.hpp"
#include "app/workbench/reading_sets.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/routes.hpp"
#include "app/workbench/state_json.hpp"

namespace tubeplan::app {

namespace {

// Largest number of loaded readings; it is limited because each check solves the arm's shape once per reading.
constexpr std::size_t kMostLoaded = Arrivals::kMost;

Answer noReadings() { return refusal(404, withoutReadings()); }

Answer jobRuns() {
  return refusal(409, InputError::saying("readings", "they cannot be changed while a job is running",
                                         "wait until it finishes, or stop it"));
}

Answer readings(Workbench& workbench, const Request&) {
  const Session session = workbench.session();
  return session.readings ? answerOf(readingsJson(currentModel(session), *session.readings)) : noReadings();
}

Answer moments(Workbench& workbench, const Request&) {
  const Session session = workbench.session();
  return session.readings ? answerOf(momentsJson(currentModel(session).cell, session.readings->readings))
                          : noReadings();
}

/// Returns the names in the query parameter "at", such as "theta3,forearm.z".
std::vector<std::string> namesAt(const Request& request) {
  std::vector<std::string> names;
  std::stringstream text(request.asked("at"));
  for (std::string name; std::getline(text, name, ',');) names.push_back(name);
  return names;
}

Answer leverage(Workbench& workbench, const Request& request) {
  const Session session = workbench.session();
  if (!session.readings) return noReadings();
  return answerOf(leverageJson(currentModel(session).cell, session.readings->readings, namesAt(request)));
}

void take(Workbench& workbench, std::shared_ptr<ReadingSet> set) {
  if (set->readings.size() > kMostLoaded)
    throw InputError(set->name, fmt::format("{} readings", set->readings.size()),
                     fmt::format("at most {} in the workbench", kMostLoaded), "use the command line for more");
  workbench.change([&](Session& session) {
    putReadings(session, std::move(set));
    return true;
  });
}

std::string shortName(const std::string& name) { return name.empty() ? "readings.csv" : name.substr(0, 200); }

Answer takeText(Workbench& workbench, const std::string& text, const std::string& name, double sigma = 0) {
  Cell cell = currentModel(workbench.session()).cell;
  take(workbench, readSet({{}, text, sigma, {}}, shortName(name), cell));
  return answerOf(stateJson(workbench));
}

/// Reads the readings again under assumptions that correct suspected mistakes, for the request {"assume":
/// ["coordinates=in"]}, like the option --assume of the commands. `as-is` states that the readings are correct; an
/// empty list revokes all assumptions.
Answer assume(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  (void)requiredOf(body, "assume", "a list of NAME=VALUE, as the option --assume takes");
  const auto names = textsOf(body, "assume");
  if (workbench.jobs().isBusy()) return jobRuns();
  const Session session = workbench.session();
  if (!session.readings) return noReadings();
  if (!session.readings->source)
    return refusal(
        409, InputError::saying("readings", "the file of the readings is no longer available", "open the file again"));
  ReadingSource source = *session.readings->source;
  if (names.empty()) source.assumed.clear();
  source.assumed.insert(source.assumed.end(), names.begin(), names.end());
  Cell cell = currentModel(session).cell;
  const bool was_known = cell.base_known;
  const auto set = readSet(std::move(source), session.readings->name, cell);
  keepMarks(*session.readings, *set);
  set->joined = session.readings->joined;
  take(workbench, set);
  if (was_known && !cell.base_known) {
    const Cell& known = currentModel(session).cell;
    const BaseChange unknown{known.X_WB, std::nullopt, false};
    const Cell open = rereadCell(known, cellTextWithBase(known, unknown, known.path));
    workbench.change([&](Session& now) {
      (void)pushModel(now, "base not known", "assumption", open);
      return true;
    });
  }
  return answerOf(stateJson(workbench));
}

Answer uploadReadings(Workbench& workbench, const Request& request) {
  return takeText(workbench, request.body, request.asked("name"));
}

/// Returns the tables of {"tables": [{"name", "text"}]}, written by other programs.
std::vector<ForeignTable> foreignTablesOf(const nlohmann::json& body) {
  std::vector<ForeignTable> tables;
  for (const auto& table : requiredOf(body, "tables", "tables of text")) {
    const std::string name = shortName(textOf(table, "name"));
    const std::string text = textOf(table, "text");
    checkText(name, text);
    tables.push_back(parseForeignTable(text, name));
  }
  if (tables.empty())
    throw InputError::saying("request (tables)", "the list is empty", "send at least one table, as text");
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

/// Converts foreign tables to readings and loads them; {"sigma"?} is the noise if no column states it.
Answer takeForeign(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const ForeignRequest foreign = foreignOf(body);
  const auto readings = readForeign(foreign, currentModel(workbench.session()).cell.arm);
  return takeText(workbench, readings.text, foreign.tables.front().file, numberOf(body, "sigma", 0));
}

Answer openReadingsFile(Workbench& workbench, const Request& request) {
  const auto path = workbench.folder().fileToRead(textOf(objectOf(request), "file"));
  take(workbench, openReadings({path.string()}, currentModel(workbench.session()).cell));
  return answerOf(stateJson(workbench));
}

std::set<std::string> idsOf(const ReadingSet& set) {
  std::set<std::string> ids;
  for (const auto& reading : set.readings) ids.insert(reading.id);
  return ids;
}

void requireIds(const ReadingSet& set, const std::vector<std::string>& ids) {
  const auto known = idsOf(set);
  for (const auto& id : ids)
    if (!known.contains(id)) throw InputError("ids", inQuotes(id), "the id of a reading");
}

/// Returns the set with the readings `ids` set aside, or in use again. Throws InputError if no reading would remain in
/// use.
ReadingSet withSetAside(ReadingSet set, const std::vector<std::string>& ids, bool aside) {
  for (const auto& id : ids) {
    if (aside)
      set.set_aside.insert(id);
    else
      set.set_aside.erase(id);
  }
  if (set.set_aside.size() >= set.readings.size())
    throw InputError::saying("ids", "all readings would be set aside", "leave some in use");
  return set;
}

/// Returns the set with the readings `ids` held out of fits, or fitted again. Throws InputError if no reading would
/// remain to fit.
ReadingSet withHeldOut(ReadingSet set, const std::vector<std::string>& ids, bool held_out) {
  const std::set<std::string> chosen(ids.begin(), ids.end());
  std::size_t fitted = 0;
  for (auto& reading : set.readings) {
    if (chosen.contains(reading.id)) reading.is_held_out = held_out;
    fitted += !reading.is_held_out && !set.set_aside.contains(reading.id) ? 1 : 0;
  }
  if (fitted == 0) throw InputError::saying("ids", "no reading would be left to fit", "hold out fewer");
  return set;
}

/// Marks readings, for the request {"ids", and `word`: true or false}, and deletes the results obtained with the former
/// marks.
Answer mark(Workbench& workbench, const Request& request, const char* word,
            ReadingSet (*marked)(ReadingSet, const std::vector<std::string>&, bool)) {
  const auto body = objectOf(request);
  const auto ids = textsOf(body, "ids");
  const bool is_on = booleanOf(body, word, true);
  if (workbench.jobs().isBusy()) return jobRuns();
  bool has_readings = false;
  workbench.change([&](Session& session) {
    has_readings = session.readings != nullptr;
    if (!has_readings) return false;
    requireIds(*session.readings, ids);
    putReadings(session, std::make_shared<ReadingSet>(marked(*session.readings, ids, is_on)));
    return true;
  });
  return has_readings ? answerOf(stateJson(workbench)) : noReadings();
}

Answer setAside(Workbench& workbench, const Request& request) {
  return mark(workbench, request, "aside", withSetAside);
}

Answer holdOut(Workbench& workbench, const Request& request) {
  return mark(workbench, request, "held_out", withHeldOut);
}

/// Removes the readings that were added last; the marks on the remaining readings are kept.
Answer part(Workbench& workbench, const Request&) {
  if (workbench.jobs().isBusy()) return jobRuns();
  const Session session = workbench.session();
  if (!session.readings) return noReadings();
  if (joinedCount(*session.readings) == 0)
    return refusal(409, InputError::saying("readings", "there are no added readings to remove", "add readings first"));
  take(workbench, partedSet(*session.readings, currentModel(session).cell));
  return answerOf(stateJson(workbench));
}

constexpr Route kReadingRoutes[] = {
    {"GET", "measurements", readings},
    {"GET", "moments", moments},
    {"GET", "leverage", leverage},
    {"POST", "measurements", uploadReadings},
    {"POST", "measurements/columns", foreignColumns},
    {"POST", "measurements/foreign", takeForeign},
    {"POST", "measurements/open", openReadingsFile},
    {"POST", "measurements/set-aside", setAside},
    {"POST", "measurements/hold-out", holdOut},
    {"POST", "measurements/assume", assume},
    {"POST", "measurements/part", part},
};

}  // namespace

std::span<const Route> readingRoutes() { return kReadingRoutes; }

}  // namespace tubeplan::app
