// Creates the record of a job: reads the cells and lists of the job file, and selects the tubes of every package.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/formats/cell/command_inputs.hpp"
#include "app/outage/job_schema.hpp"
#include "app/outage/job_store.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/origin.hpp"
#include "app/storage/suggestion.hpp"
#include "app/storage/text_file.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

namespace {

using tubesheets::Leg, tubesheets::Sheet;

/// The sheet of one leg, with the tube states from the job file's table for its steam generator.
struct ReadLeg {
  std::string generator;
  JobLeg leg;
  Sheet sheet;
};

/// Returns the drawing data of a sheet: {viewed_from, hole_diameter_m, manway: direction [x, y] or null}.
nlohmann::json sheetLookJson(const Sheet& sheet) {
  nlohmann::json manway;
  if (sheet.manway) manway = {sheet.manway->direction().x(), sheet.manway->direction().y()};
  return {{"viewed_from", tubesheets::viewedFromName(sheet.viewed_from)},
          {"hole_diameter_m", sheet.hole_diameter},
          {"manway", manway}};
}

/// One package on one leg: the tubes to visit, and those that are left out with the reason.
struct PackageOnLeg {
  std::int64_t package = 0;  ///< key of the package
  const ReadLeg* leg = nullptr;
  tubesheets::Selection selection;
};

Sheet sheetOf(const JobLeg& leg) {
  const Cell cell = readCellOf(leg);
  const Sheet& sheet = requireSheet(cell, "plan an outage");
  if (sheet.leg != leg.leg)
    throw InputError::problem(leg.cell,
                              fmt::format("its sheet is of the {} leg, but the job names it for the {} leg",
                                          tubesheets::legName(sheet.leg), tubesheets::legName(leg.leg)),
                              "exchange the cells of the legs, or write `mirrored` for the other leg");
  return sheet;
}

/// Throws InputError for a table without tube states, or of another steam generator.
void requireStates(const std::string& path, const tubesheets::WorkList& list, const std::string& generator) {
  if (list.problem) refuseText(path, *list.problem);
  for (const auto& item : list.items)
    if (!item.steam_generator.empty() && item.steam_generator != generator)
      throw InputError::problem(
          fmt::format("{}:{}", path, item.line),
          fmt::format("{} is of steam generator {}, but the job names the table for {}",
                      tubesheets::tubeName(item.row, item.column), item.steam_generator, generator),
          "name the table under its own steam generator");
  std::vector<std::string> states;
  for (const auto state : tubesheets::tubeStates()) states.emplace_back(tubesheets::tubeStateName(state));
  if (std::ranges::none_of(list.items, [](const auto& item) { return item.state.has_value(); }))
    throw InputError::problem(path, "the table has no state of any tube",
                              "write each tube's state in a column named `state`: " + alternatives(states));
}

/// Sets the states of tubes that a table states. Throws InputError for a tube that the sheet does not have.
void applyStates(const tubesheets::WorkList& list, const std::string& path, Sheet& sheet) {
  for (const auto& item : list.items) {
    const auto tube = sheet.indexOf(item.row, item.column);
    if (!tube)
      throw InputError::problem(fmt::format("{}:{}", path, item.line),
                                tubesheets::tubeName(item.row, item.column) + " is not on the sheet",
                                "correct the tube's row and column, or name the states of this steam generator");
    if (item.state) sheet.tubes[static_cast<std::size_t>(*tube)].state = *item.state;
  }
}

/// Throws InputError unless both legs have tubes of the same names: each tube has two ends.
void requireSameTubes(const ReadLeg& one, const ReadLeg& other) {
  const auto lacking = [](const Sheet& in, const Sheet& of) -> const tubesheets::Tube* {
    for (const auto& tube : of.tubes)
      if (!in.indexOf(tube.row, tube.column)) return &tube;
    return nullptr;
  };
  for (const auto& [has, lacks] : {std::pair(&one, &other), std::pair(&other, &one)})
    if (const auto* tube = lacking(lacks->sheet, has->sheet))
      throw InputError::problem(
          fmt::format("steam generator {}", one.generator),
          fmt::format("the {} leg has {}, but the {} leg does not", tubesheets::legName(has->leg.leg),
                      tubesheets::tubeName(tube->row, tube->column), tubesheets::legName(lacks->leg.leg)),
          "give both legs sheets with the same rows and columns");
}

std::vector<ReadLeg> readLegsOf(const JobFile& job, std::vector<std::string>& notes) {
  std::vector<ReadLeg> legs;
  for (const SteamGenerator& generator : job.generators) {
    const std::size_t first = legs.size();
    tubesheets::WorkList states;
    if (!generator.states.empty()) {
      states = tubesheets::parseWorkListCsv(readTextFile(generator.states));
      requireStates(generator.states, states, generator.name);
      for (const std::string& note : states.notes) notes.push_back(generator.states + ": " + note);
    }
    for (const JobLeg& leg : generator.legs) {
      legs.push_back({generator.name, leg, sheetOf(leg)});
      applyStates(states, generator.states, legs.back().sheet);
      if (legs.size() > first + 1) requireSameTubes(legs[first], legs.back());
    }
  }
  return legs;
}

/// Returns true if a work list is meant for the leg: it names the leg and its steam generator, or neither.
bool isMeantFor(const tubesheets::WorkList& list, const ReadLeg& leg) {
  if (list.items.empty()) return true;
  const auto& first = list.items.front();
  return (!first.leg || *first.leg == leg.leg.leg) &&
         (first.steam_generator.empty() || first.steam_generator == leg.generator);
}

/// Throws InputError for a tube that a work list opens although it is plugged or stabilised according to the sheet: one
/// of the two is wrong, and a tool must not enter a plugged tube.
void requireNoneReopened(const tubesheets::WorkList& list, const ReadLeg& leg, const std::string& path) {
  for (const auto& item : list.items) {
    const auto tube = leg.sheet.indexOf(item.row, item.column);
    if (!tube || !item.state) continue;
    const auto on_sheet = leg.sheet.tubes[static_cast<std::size_t>(*tube)].state;
    if (tubesheets::takesNoTool(on_sheet) && !tubesheets::takesNoTool(*item.state))
      throw InputError::problem(
          fmt::format("{}:{}", path, item.line),
          fmt::format("{} is {} according to the list, but {} before the job",
                      tubesheets::tubeName(item.row, item.column), tubesheets::tubeStateName(*item.state),
                      tubesheets::tubeStateName(on_sheet)),
          "correct the list, or the states of the steam generator");
  }
}

bool contains(const auto& values, const auto& value) { return std::ranges::find(values, value) != values.end(); }

std::vector<std::string> addressesOf(const std::vector<ReadLeg>& legs) {
  std::vector<std::string> addresses;
  for (const ReadLeg& leg : legs) addresses.push_back(addressText(LegName{leg.generator, leg.leg.leg}));
  return addresses;
}

/// Returns ", whose list is of B/hot" for a list that names its steam generator or leg; empty for any other.
std::string placeOf(const std::optional<tubesheets::WorkList>& list) {
  if (!list || list->items.empty()) return "";
  const auto& first = list->items.front();
  const std::string leg = first.leg ? fmt::format(" ({} leg)", tubesheets::legName(*first.leg)) : "";
  if (first.steam_generator.empty() && leg.empty()) return "";
  return fmt::format(", whose list is of {}{}",
                     first.steam_generator.empty() ? "any steam generator" : first.steam_generator, leg);
}

/// Selects the tubes of one package on all legs to which it applies.
std::vector<PackageOnLeg> selectPackage(const WorkPackage& package, std::int64_t key, const JobFile& job,
                                        const std::vector<ReadLeg>& legs) {
  const bool is_list = package.tubes.ends_with(".csv");
  std::optional<tubesheets::WorkList> list;
  if (is_list) list = tubesheets::parseWorkListCsv(readTextFile(package.tubes));
  std::vector<PackageOnLeg> selected;
  for (const ReadLeg& leg : legs) {
    if (!contains(package.generators, leg.generator) || !contains(package.legs, leg.leg.leg)) continue;
    if (list && !isMeantFor(*list, leg)) continue;
    if (list) requireNoneReopened(*list, leg, package.tubes);
    selected.push_back(
        {key, &leg, readTubes(package.tubes, leg.sheet, {}, fmt::format("{} (package {})", job.path, package.name))});
  }
  if (selected.empty())
    throw InputError::problem(
        fmt::format("{} (package {})", job.path, package.name),
        "no leg of the job belongs to this package" + placeOf(list),
        fmt::format(
            "the job has {}: check `steam_generators` and `legs` of the package, and the columns `sg` and `leg` "
            "of its list",
            enumeration(addressesOf(legs))));
  return selected;
}

std::string legText(const ReadLeg& leg) { return std::string(tubesheets::legName(leg.leg.leg)); }

void insertLeg(Database& database, const ReadLeg& leg) {
  database.query("INSERT INTO job VALUES (?1, ?2)",
                 {"look " + addressText(LegName{leg.generator, leg.leg.leg}), sheetLookJson(leg.sheet).dump()});
  database.query("INSERT INTO sheet VALUES (?1, ?2, ?3, ?4, ?5, ?6)",
                 {leg.generator, legText(leg), leg.leg.cell, std::int64_t{leg.leg.is_mirrored}, leg.sheet.fingerprint(),
                  leg.sheet.pitch});
  for (const auto& tube : leg.sheet.tubes)
    database.query("INSERT INTO tube VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)",
                   {leg.generator, legText(leg), std::int64_t{tube.row}, std::int64_t{tube.column}, tube.x, tube.y,
                    std::string(tubesheets::tubeStateName(tube.state))});
}

void insertItem(Database& database, const PackageOnLeg& of, int index, const std::string& excluded) {
  const auto& tube = of.leg->sheet.tubes[static_cast<std::size_t>(index)];
  database.query(
      "INSERT INTO item (package, generator, leg, tube_row, tube_column, excluded) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6)",
      {of.package, of.leg->generator, legText(*of.leg), std::int64_t{tube.row}, std::int64_t{tube.column}, excluded});
}

void insertPackage(Database& database, const PackageOnLeg& of) {
  if (of.selection.list)
    database.query("INSERT INTO list VALUES (?1, ?2, ?3, ?4)",
                   {of.package, of.leg->generator, legText(*of.leg), of.selection.list->text});
  for (const int tube : of.selection.tube_indices) insertItem(database, of, tube, "");
  for (const auto& left_out : of.selection.left_out)
    insertItem(database, of, left_out.tube,
               fmt::format("{}{}", left_out.word, left_out.is_by_list ? " according to the list" : ""));
}

void fill(Database& database, const JobFile& job, const std::vector<ReadLeg>& legs,
          const std::vector<std::vector<PackageOnLeg>>& packages) {
  for (const auto& [key, value] : {std::pair<std::string, std::string>{"format", std::to_string(kJobFormat)},
                                   {"path", job.path},
                                   {"file", job.text}})
    database.query("INSERT INTO job VALUES (?1, ?2)", {key, value});
  for (const ReadLeg& leg : legs) insertLeg(database, leg);
  for (std::size_t k = 0; k < packages.size(); ++k) {
    database.query("INSERT INTO package VALUES (?1, ?2)", {static_cast<std::int64_t>(k) + 1, job.packages[k].name});
    for (const PackageOnLeg& of : packages[k]) insertPackage(database, of);
  }
}

}  // namespace

std::vector<std::string> JobStore::create(const JobFile& job, const std::string& path) {
  std::vector<std::string> notes;
  const std::vector<ReadLeg> legs = readLegsOf(job, notes);
  std::vector<std::vector<PackageOnLeg>> packages;
  for (std::size_t k = 0; k < job.packages.size(); ++k)
    packages.push_back(selectPackage(job.packages[k], static_cast<std::int64_t>(k) + 1, job, legs));
  for (const WorkPackage& package : job.packages)
    if (const std::string note = untimedText(package, job); !note.empty()) notes.push_back(note);
  for (const auto& of_package : packages)
    for (const std::string& note : listNotes(of_package.front().selection)) notes.push_back(note);
  claimOutput(path, "--out");
  std::error_code none;
  if (std::filesystem::exists(path, none))
    throw InputError::problem(path, "the file already exists, and its record must not be lost", "choose another name");
  const std::string scratch = path + ".new";
  const auto removeScratch = [&] {
    for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(scratch + suffix, none);
  };
  removeScratch();
  try {
    Database database(scratch, Database::Mode::kCreate);
    database.execute(kJobSchema);
    database.transact([&] { fill(database, job, legs, packages); });
  } catch (...) {
    removeScratch();
    throw;
  }
  std::filesystem::rename(scratch, path);
  return notes;
}

}  // namespace tubeplan::app
