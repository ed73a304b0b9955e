#include "app/outage/job_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <filesystem>

#include "app/formats/cell/mirrored_cell.hpp"
#include "app/formats/quantities.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "app/outage/job_shifts.hpp"
#include "app/storage/named_entry.hpp"
#include "app/storage/text_file.hpp"

namespace tubeplan::app {

namespace {

using tubesheets::Leg;

constexpr const char* kMirrored = "mirrored";

struct ConfirmationRow {
  std::string_view name;
  ConfirmationMethod method;
};
constexpr std::array<ConfirmationRow, 3> kConfirmations{{{"none", ConfirmationMethod::kNone},
                                                         {"read-back", ConfirmationMethod::kReadBack},
                                                         {"position", ConfirmationMethod::kPosition}}};

/// Reads a name of letters, digits, dots, dashes and underscores, which is valid in addresses and file names.
std::string readPlainName(const YamlNode& node) {
  const std::string name = node.text();
  const bool is_plain = std::ranges::all_of(
      name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.'; });
  if (!is_plain) node.fail("a name of letters, digits, dashes, dots and underscores");
  return name;
}

/// Throws InputError if the last entry has the name of an earlier one.
template <class Entry>
void requireNewName(const YamlNode& node, const std::vector<Entry>& entries) {
  const auto has_name = [&](const Entry& entry) { return entry.name == entries.back().name; };
  if (std::ranges::count_if(entries, has_name) > 1)
    node.failWithProblem(fmt::format("the name '{}' is given twice", entries.back().name),
                         "give each entry its own name");
}

/// Reads a name that must be one of `names`.
std::string readNameOf(const YamlNode& node, const std::vector<std::string>& names) {
  if (std::ranges::find(names, node.text()) == names.end())
    node.fail(alternatives(names), suggestion(node.text(), names));
  return node.text();
}

std::string pathFrom(const YamlNode& node, const std::string& folder) {
  return (std::filesystem::path(folder) / node.text()).lexically_normal().string();
}

/// Reads the legs of a steam generator: one cell each, or the word `mirrored` for the mirror image of the other.
std::vector<JobLeg> readLegs(const YamlNode& node, const std::string& folder) {
  std::vector<JobLeg> legs;
  for (const Leg leg : tubesheets::legs())
    if (const YamlNode* cell = node.find(tubesheets::legName(leg))) {
      const bool is_mirrored = cell->text() == kMirrored;
      legs.push_back({leg, is_mirrored ? "" : pathFrom(*cell, folder), is_mirrored});
    }
  if (legs.empty()) node.fail("no leg", "a cell for `hot`, `cold` or `full`", "");
  for (JobLeg& leg : legs) {
    if (!leg.is_mirrored) continue;
    const auto other = std::ranges::find_if(legs, [](const JobLeg& candidate) { return !candidate.is_mirrored; });
    if (leg.leg == Leg::kFull || other == legs.end() || other->leg == Leg::kFull)
      node.at(tubesheets::legName(leg.leg))
          .failWithProblem("there is no other leg with a cell to mirror", "give a cell to one of `hot` and `cold`");
    leg.cell = other->cell;
  }
  return legs;
}

SteamGenerator readGenerator(const YamlNode& node, const std::string& folder) {
  std::vector<std::string> keys{"states"};
  for (const Leg leg : tubesheets::legs()) keys.emplace_back(tubesheets::legName(leg));
  node.expectKeys({"name"}, keys);
  SteamGenerator generator{readPlainName(node.at("name")), readLegs(node, folder), ""};
  if (const YamlNode* states = node.find("states")) generator.states = pathFrom(*states, folder);
  return generator;
}

double readPositive(const YamlNode& node, double factor, const char* expected) {
  const double value = node.number();
  if (!(value >= 0)) node.fail(expected);
  return value * factor;
}

JobTool readTool(const YamlNode& node, const Units& units) {
  node.expectKeys({"name"}, {"speed", "change_s", "load"});
  JobTool tool{readPlainName(node.at("name"))};
  if (const YamlNode* speed = node.find("speed"))
    tool.speed = readPositive(*speed, units.factor(dimension::kLength),
                              "a speed of zero or more, in units of length per second");
  if (const YamlNode* change = node.find("change_s")) tool.change = readPositive(*change, 1, "seconds of zero or more");
  if (const YamlNode* load = node.find("load"))
    tool.load = readPositive(*load, units.factor(dimension::kForce), "a weight of zero or more");
  return tool;
}

std::vector<Leg> readLegNames(const YamlNode& node) {
  std::vector<Leg> legs;
  for (const YamlNode& item : node.list()) {
    const auto leg = tubesheets::findLeg(item.text());
    if (!leg) item.fail("one of " + tubesheets::legNames());
    legs.push_back(*leg);
  }
  return legs;
}

ConfirmationMethod readConfirmation(const YamlNode& node) {
  std::vector<std::string> names;
  for (const auto& row : kConfirmations) {
    if (node.text() == row.name) return row.method;
    names.emplace_back(row.name);
  }
  node.fail(alternatives(names), suggestion(node.text(), names));
}

/// Returns all legs that the steam generators have.
std::vector<Leg> allLegs(const std::vector<SteamGenerator>& generators) {
  std::vector<Leg> legs;
  for (const auto& generator : generators)
    for (const auto& leg : generator.legs)
      if (std::ranges::find(legs, leg.leg) == legs.end()) legs.push_back(leg.leg);
  return legs;
}

WorkPackage readPackage(const YamlNode& node, const JobFile& job) {
  node.expectKeys({"name", "tubes", "tool"}, {"steam_generators", "legs", "extent", "length", "dwell_s", "confirm"});
  WorkPackage package;
  package.name = readPlainName(node.at("name"));
  package.tubes = node.at("tubes").text();
  package.tool = readNameOf(node.at("tool"), namesOf(job.tools));
  package.generators = namesOf(job.generators);
  if (const YamlNode* generators = node.find("steam_generators")) {
    package.generators.clear();
    for (const YamlNode& item : generators->list())
      package.generators.push_back(readNameOf(item, namesOf(job.generators)));
  }
  package.legs = allLegs(job.generators);
  if (const YamlNode* legs = node.find("legs")) package.legs = readLegNames(*legs);
  if (const YamlNode* extent = node.find("extent")) package.extent = extent->text();
  if (const YamlNode* length = node.find("length"))
    package.length = readPositive(*length, job.units.factor(dimension::kLength), "a length of zero or more");
  if (const YamlNode* dwell = node.find("dwell_s")) package.dwell = readPositive(*dwell, 1, "seconds of zero or more");
  if (const YamlNode* confirm = node.find("confirm")) package.confirm = readConfirmation(*confirm);
  return package;
}

/// Reads a group of legs that must not have an arm at the same time.
std::vector<LegName> readExclusiveLegs(const YamlNode& node, const std::vector<SteamGenerator>& generators) {
  std::vector<std::string> names;
  std::vector<LegName> legs, group;
  for (const SteamGenerator& generator : generators)
    for (const JobLeg& leg : generator.legs) {
      legs.push_back({generator.name, leg.leg});
      names.push_back(addressText(legs.back()));
    }
  for (const YamlNode& item : node.list()) {
    const auto found = std::ranges::find(names, readNameOf(item, names));
    group.push_back(legs[static_cast<std::size_t>(found - names.begin())]);
    if (std::ranges::count(group, group.back()) > 1)
      item.failWithProblem(fmt::format("the leg {} is named twice", item.text()), "name each leg of a group once");
  }
  if (group.size() < 2) node.failWithProblem("the group has only one leg", "name two legs or more");
  return group;
}

/// Reads a time of day, "18:00", and returns the minutes after midnight.
int readMinutes(const YamlNode& node) {
  const std::string text = node.text();
  int hours = 0, minutes = 0;
  char colon = 0, more = 0;
  const int read = std::sscanf(text.c_str(), "%2d%c%2d%c", &hours, &colon, &minutes, &more);
  if (read != 3 || colon != ':' || hours < 0 || hours > 23 || minutes < 0 || minutes > 59)
    node.fail("a time of day in quotes, such as \"18:00\"");
  return 60 * hours + minutes;
}

}  // namespace

std::string addressText(const LegName& name) {
  return fmt::format("{}/{}", name.generator, tubesheets::legName(name.leg));
}

std::string_view confirmationName(ConfirmationMethod method) {
  return std::ranges::find(kConfirmations, method, &ConfirmationRow::method)->name;
}

const JobTool& JobFile::toolOf(const WorkPackage& package) const {
  const auto found = std::ranges::find(tools, package.tool, &JobTool::name);
  assert(found != tools.end());
  return *found;
}

const WorkPackage& JobFile::packageOf(const std::string& wanted) const {
  const auto found = std::ranges::find(packages, wanted, &WorkPackage::name);
  assert(found != packages.end());
  return *found;
}

JobFile parseJobFile(const std::string& text, const std::string& path) {
  const YamlNode root = parseYaml(text, path);
  root.expectKeys({"job", "units", "steam_generators", "tools", "packages"}, {"shifts", "arms", "mount_s", "apart"});
  const std::string folder = std::filesystem::path(path).parent_path().string();
  JobFile job{path, text, root.at("job").text(), Units(root.at("units"))};
  constexpr int kMostArms = 64;
  if (const YamlNode* arms = root.find("arms")) job.arms = arms->integer(1, kMostArms);
  if (const YamlNode* mount = root.find("mount_s")) job.mount = readPositive(*mount, 1, "seconds of zero or more");
  for (const YamlNode& node : root.at("steam_generators").list()) {
    job.generators.push_back(readGenerator(node, folder));
    requireNewName(node, job.generators);
  }
  for (const YamlNode& node : root.at("tools").list()) {
    job.tools.push_back(readTool(node, job.units));
    requireNewName(node, job.tools);
  }
  for (const YamlNode& node : root.at("packages").list()) {
    job.packages.push_back(readPackage(node, job));
    requireNewName(node, job.packages);
    if (job.packages.back().tubes.ends_with(".csv")) job.packages.back().tubes = pathFrom(node.at("tubes"), folder);
  }
  if (const YamlNode* exclusive_legs = root.find("apart"))
    for (const YamlNode& node : exclusive_legs->list())
      job.exclusive_legs.push_back(readExclusiveLegs(node, job.generators));
  if (const YamlNode* shifts = root.find("shifts"))
    for (const YamlNode& node : shifts->list()) {
      node.expectKeys({"name", "from", "to"}, {});
      job.shifts.push_back({readPlainName(node.at("name")), readMinutes(node.at("from")), readMinutes(node.at("to"))});
      requireNewName(node, job.shifts);
    }
  for (JobShift& gap : gapsBetween(job.shifts)) job.shifts.push_back(std::move(gap));
  return job;
}

Cell readCellOf(const JobLeg& leg) {
  Cell cell = readCell(leg.cell);
  return leg.is_mirrored ? mirroredCell(cell) : cell;
}

JobFile readJobFile(const std::string& path) {
  JobFile job = parseJobFile(readTextFile(path), path);
  if (const std::string overlap = overlapText(job.shifts); !overlap.empty())
    throw InputError::problem(path + ": shifts", overlap, "let each shift end when the next begins");
  return job;
}

std::string untimedText(const WorkPackage& package, const JobFile& job) {
  const JobTool& tool = job.toolOf(package);
  if ((tool.speed > 0) == (package.length > 0)) return "";
  return fmt::format("the time in the tubes is not counted for the package {}: {}", package.name,
                     tool.speed > 0 ? fmt::format("its tool {} has a speed, but the package has no length", tool.name)
                                    : fmt::format("it has a length, but its tool {} has no speed", tool.name));
}

}  // namespace tubeplan::app
