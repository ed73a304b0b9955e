#include "app/formats/sheet/sheet_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "app/formats/quantities.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/named_entry.hpp"
#include "app/storage/text_file.hpp"
#include "tubesheets/hole_lattice.hpp"
#include "tubesheets/hole_map_csv.hpp"
#include "tubesheets/hole_names.hpp"
#include "tubesheets/layouts.hpp"

namespace tubeplan::app {

namespace {

using tubesheets::Problem;
using tubesheets::SheetDescription;

// Throws InputError for a problem, at the value that the problem names if the file contains that value. The message
// then quotes the value as the user wrote it.
[[noreturn]] void failAt(const YamlNode& node, const Problem& problem) {
  const YamlNode* named = findNode(node, node.path + "." + problem.what);
  if (!named) named = findNode(node, node.path + ".layout." + problem.what);
  const bool is_scalar = named && named->kind == YamlNode::Kind::kScalar;
  const std::string written =
      is_scalar && problem.found.find(named->scalar) == std::string::npos ? " (written " + named->scalar + ")" : "";
  throw InputError(named ? named->where() : node.where(node.path + ": " + problem.what), problem.found + written,
                   problem.expected, problem.advice);
}

void refuseProblems(const YamlNode& node, const std::vector<Problem>& problems) {
  if (!problems.empty()) failAt(node, problems.front());
}

tubesheets::Leg readLeg(const YamlNode& node) {
  const std::string name = node.text();
  if (const auto leg = tubesheets::findLeg(name)) return *leg;
  node.fail(tubesheets::legNames());
}

tubesheets::ViewedFrom readViewedFrom(const YamlNode& node) {
  const std::string name = node.text();
  if (const auto side = tubesheets::findViewedFrom(name)) return *side;
  node.fail(tubesheets::viewedFromNames());
}

const tubesheets::LayoutType& readLayoutType(const YamlNode& node) {
  return entryNamed(tubesheets::layoutTypes(), node.text(), node.where());
}

tubesheets::Layout readLayout(const YamlNode& node, const Units& units) {
  const tubesheets::LayoutType& type = readLayoutType(node.at("type"));
  std::vector<std::string> required{"type"}, optional;
  for (const auto& key : type.keys) (key.required ? required : optional).emplace_back(key.name);
  node.expectKeys(required, optional);
  tubesheets::Layout layout;
  layout.type = type.name;
  constexpr int kMost = 100000;
  for (const auto& key : type.keys) {
    const YamlNode* value = node.find(key.name);
    if (!value) continue;
    if (const auto* length = std::get_if<double tubesheets::Layout::*>(&key.field))
      layout.*(*length) = readQuantity(*value, units, dimension::kLength);
    else
      layout.*std::get<int tubesheets::Layout::*>(key.field) = value->integer(0, kMost);
  }
  return layout;
}

tubesheets::Manway readManway(const YamlNode& node, const Units& units) {
  node.expectKeys({"center", "diameter"}, {});
  return {readVector(node.at("center"), units, dimension::kLength),
          readQuantity(node.at("diameter"), units, dimension::kLength)};
}

void readCommon(const YamlNode& node, const Units& units, SheetDescription& description) {
  description.hole_diameter = readQuantity(node.at("hole_diameter"), units, dimension::kLength);
  description.leg = readLeg(node.at("leg"));
  if (const YamlNode* side = node.find("viewed_from")) description.viewed_from = readViewedFrom(*side);
  if (const YamlNode* name = node.find("name")) description.name = name->text();
  if (const YamlNode* manway = node.find("manway")) description.manway = readManway(*manway, units);
}

tubesheets::Sheet readDrilledSheet(const YamlNode& node, const Units& units) {
  node.expectKeys({"layout", "hole_diameter", "leg"}, {"viewed_from", "name", "manway"});
  SheetDescription description;
  description.layout = readLayout(node.at("layout"), units);
  readCommon(node, units, description);
  refuseProblems(node, tubesheets::findDescriptionProblems(description));
  return tubesheets::makeSheet(description);
}

tubesheets::Sheet readMappedSheet(const YamlNode& node, const Units& units, const std::filesystem::path& folder) {
  node.expectKeys({"map", "pitch", "hole_diameter", "leg"}, {"viewed_from", "name", "manway"});
  SheetDescription description;
  description.layout.type = "map";
  description.layout.pitch = readQuantity(node.at("pitch"), units, dimension::kLength);
  readCommon(node, units, description);
  const std::string path = (folder / node.at("map").text()).lexically_normal().string();
  auto map = std::make_shared<tubesheets::HoleMap>(tubesheets::parseHoleMap(readTextFile(path)));
  if (map->problem) refuseText(path, *map->problem);
  if (map->leg && *map->leg != description.leg)
    node.at("leg").failWithProblem(
        fmt::format("the leg is {}, but the map is of the {} leg", legName(description.leg), legName(*map->leg)),
        "check which map belongs to this cell");
  tubesheets::Sheet sheet = tubesheets::makeSheet(description, map->tubes);
  sheet.map = std::move(map);
  return sheet;
}

}  // namespace

tubesheets::Sheet readSheet(const YamlNode& node, const Units& units, const std::filesystem::path& folder) {
  tubesheets::Sheet sheet = node.find("map") ? readMappedSheet(node, units, folder) : readDrilledSheet(node, units);
  refuseProblems(node, tubesheets::findSheetProblems(sheet));
  return sheet;
}

namespace {

void warnOfMisnamedHoles(const tubesheets::Sheet& sheet, std::vector<std::string>& warnings) {
  for (const auto& hole : tubesheets::findMisnamedHoles(sheet)) {
    const auto& tube = sheet.tubes[static_cast<std::size_t>(hole.tube)];
    const auto* tube_at_position =
        hole.tube_at_position < 0 ? nullptr : &sheet.tubes[static_cast<std::size_t>(hole.tube_at_position)];
    warnings.push_back(fmt::format(
        "hole map: {} is not at the position that its row gives for column {}{}: check its name",
        tubesheets::tubeName(tube.row, tube.column), tube.column,
        tube_at_position ? fmt::format(", {} is", tubesheets::tubeName(tube_at_position->row, tube_at_position->column))
                         : ""));
  }
}

void warnOfHolesOffLattice(const tubesheets::Sheet& sheet, const Units& units, std::vector<std::string>& warnings) {
  constexpr std::size_t kShown = 5;
  const auto off = tubesheets::findHolesOffLattice(sheet);
  const auto inUnits = [&](double length) { return length / units.factor(dimension::kLength); };
  for (std::size_t k = 0; k < std::min(off.size(), kShown); ++k) {
    const auto& tube = sheet.tubes[static_cast<std::size_t>(off[k].tube)];
    warnings.push_back(fmt::format(
        "hole map: {} at ({:.6g}, {:.6g}) {} is {:.3g} {} off the lattice of the holes about it, which has a place at "
        "({:.6g}, {:.6g}): correct its coordinates, unless it was drilled there",
        tubesheets::tubeName(tube.row, tube.column), inUnits(tube.x), inUnits(tube.y), units.length().name,
        inUnits(off[k].distance), units.length().name, inUnits(off[k].x), inUnits(off[k].y)));
  }
  if (off.size() > kShown)
    warnings.push_back(
        fmt::format("hole map: {} more holes lie off the lattice of those about them", off.size() - kShown));
}

}  // namespace

void warnOfHoles(const tubesheets::Sheet& sheet, const Units& units, std::vector<std::string>& warnings) {
  if (sheet.map)
    for (const std::string& note : sheet.map->notes) warnings.push_back("hole map: " + note);
  warnOfMisnamedHoles(sheet, warnings);
  warnOfHolesOffLattice(sheet, units, warnings);
}

tubesheets::SteppedTool readSteppedTool(const YamlNode& node, const Units& units, double hole_diameter) {
  node.expectKeys({"steps"}, {"lengths"});
  tubesheets::SteppedTool tool;
  for (const YamlNode& step : node.at("steps").list()) {
    step.expectKeys({"diameter", "tolerance"}, {});
    tool.steps.push_back({readQuantity(step.at("diameter"), units, dimension::kLength),
                          readQuantity(step.at("tolerance"), units, dimension::kLength)});
  }
  if (const YamlNode* lengths = node.find("lengths"))
    for (const YamlNode& length : lengths->list())
      tool.lengths.push_back(readQuantity(length, units, dimension::kLength));
  refuseProblems(node, tubesheets::findToolProblems(tool, hole_diameter));
  return tool;
}

}  // namespace tubeplan::app
