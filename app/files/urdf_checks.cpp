#include "app/files/urdf_checks.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <limits>
#include <set>
#include <span>

#include "app/files/input_error.hpp"
#include "app/files/suggestion.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using tinyxml2::XMLElement;

constexpr double kAnyNumber = -std::numeric_limits<double>::infinity();

/// So many numbers of an attribute, none below `least`.
struct NumberRule {
  const char *element, *attribute;
  std::size_t count;
  double least;
  const char* expected;
  bool is_required = false;  ///< else URDF has numbers where the attribute is not there
};

constexpr NumberRule kPlaceNumbers[] = {{"origin", "xyz", 3, kAnyNumber, "three numbers in m"},
                                        {"origin", "rpy", 3, kAnyNumber, "three numbers in rad"}};
constexpr NumberRule kJointNumbers[] = {{"axis", "xyz", 3, kAnyNumber, "three numbers, a direction"},
                                        {"limit", "lower", 1, kAnyNumber, "a number in rad or m"},
                                        {"limit", "upper", 1, kAnyNumber, "a number in rad or m"},
                                        {"limit", "velocity", 1, 0, "a number, 0 or more"},
                                        {"mimic", "multiplier", 1, kAnyNumber, "a number"},
                                        {"mimic", "offset", 1, kAnyNumber, "a number in rad or m"}};
constexpr NumberRule kSolidNumbers[] = {{"box", "size", 3, 0, "three lengths in m", true},
                                        {"cylinder", "radius", 1, 0, "a length in m", true},
                                        {"cylinder", "length", 1, 0, "a length in m", true},
                                        {"sphere", "radius", 1, 0, "a length in m", true}};

/// Why a text may be no number.
const char* adviceOn(std::string_view text) {
  if (text.find('$') != std::string_view::npos) return "convert xacro files first: xacro FILE > robot.urdf";
  if (text.find(',') != std::string_view::npos) return "numbers have a decimal point and stand apart by blanks";
  const auto begin_unit = [](char before, char c) { return before >= '0' && before <= '9' && (c == 'm' || c == 'd'); };
  if (std::ranges::adjacent_find(text, begin_unit) != text.end()) return "URDF has metres and radians, without units";
  return "";
}

/// Of the first element of each name within `parent`.
void checkNumbers(const XMLElement& parent, std::span<const NumberRule> rules, const std::string& where) {
  for (const auto& rule : rules) {
    const XMLElement* element = parent.FirstChildElement(rule.element);
    if (!element || (!rule.is_required && !element->Attribute(rule.attribute))) continue;
    const std::string text = attributeOf(element, rule.attribute);
    const auto numbers = numbersIn(text);
    if (!numbers || numbers->size() != rule.count || std::ranges::min(*numbers) < rule.least)
      throw InputError(where, fmt::format("{} {}={}", rule.element, rule.attribute, inQuotes(text)), rule.expected,
                       adviceOn(text));
  }
}

/// Texts without which an element says nothing.
void requireText(const XMLElement* element, const char* attribute, const std::string& where) {
  if (element && attributeOf(element, attribute).empty())
    throw InputError(where, fmt::format("a {} without a {}", element->Name(), attribute),
                     fmt::format("<{} {}=\"...\"/>", element->Name(), attribute));
}

/// A word that is mistyped there would leave a zero in its place.
void checkAttributes(const XMLElement* element, const std::vector<std::string>& known, const std::string& where) {
  for (const auto* attribute = element ? element->FirstAttribute() : nullptr; attribute; attribute = attribute->Next())
    if (std::ranges::find(known, attribute->Name()) == known.end())
      throw InputError(where, fmt::format("{} {}", element->Name(), inQuotes(attribute->Name())), alternatives(known),
                       suggestion(attribute->Name(), known));
}

void checkPlace(const XMLElement& parent, const std::string& where) {
  checkAttributes(parent.FirstChildElement("origin"), {"xyz", "rpy"}, where);
  checkNumbers(parent, kPlaceNumbers, where);
}

/// All of a kind.
void checkNamesOf(const XMLElement& robot, const char* kind, const std::string& file) {
  std::set<std::string> names;
  for (const auto* one = robot.FirstChildElement(kind); one; one = one->NextSiblingElement(kind)) {
    const std::string name = attributeOf(one, "name");
    if (name.empty())
      throw InputError(fmt::format("{}:{}", file, one->GetLineNum()), fmt::format("a {} without a name", kind),
                       fmt::format("<{} name=\"...\">", kind));
    if (!names.insert(name).second)
      throw InputError(placeOf(*one, file), fmt::format("a second {} {}", kind, inQuotes(name)),
                       "a name of its own for each");
  }
}

void checkJointWords(const XMLElement& joint, const std::string& file) {
  static const std::vector<std::string> kTypes{"revolute", "continuous", "prismatic", "fixed", "floating", "planar"};
  const std::string type = attributeOf(&joint, "type");
  if (std::ranges::find(kTypes, type) == kTypes.end())
    throw InputError(placeOf(joint, file), type.empty() ? "a joint without a type" : "the type " + inQuotes(type),
                     alternatives(kTypes), suggestion(type, kTypes));
  for (const char* end : {"parent", "child"})
    if (attributeOf(joint.FirstChildElement(end), "link").empty())
      throw InputError(placeOf(joint, file), fmt::format("no {} link", end), fmt::format("<{} link=\"...\"/>", end));
}

}  // namespace

std::string attributeOf(const XMLElement* element, const char* name) {
  const char* value = element ? element->Attribute(name) : nullptr;
  return value ? value : "";
}

std::optional<std::vector<double>> numbersIn(std::string_view text) {
  std::vector<double> numbers;
  for (text = tubesheets::trimBlanks(text); !text.empty(); text = tubesheets::trimBlanks(text)) {
    const std::string_view piece = text.substr(0, text.find_first_of(" \t\r\n"));
    const bool has_plus = piece.starts_with('+') && !piece.starts_with("+-");
    const auto number = tubesheets::parseNumber(piece.substr(has_plus ? 1 : 0));
    if (!number) return {};
    numbers.push_back(*number);
    text.remove_prefix(piece.size());
  }
  if (numbers.empty()) return {};
  return numbers;
}

std::string placeOf(const XMLElement& named, const std::string& file) {
  return fmt::format("{}:{} ({} {})", file, named.GetLineNum(), named.Name(), nameInLine(attributeOf(&named, "name")));
}

void checkNames(const XMLElement& robot, const std::string& file) {
  if (attributeOf(&robot, "name").empty())
    throw InputError(fmt::format("{}:{}", file, robot.GetLineNum()), "a robot without a name", "<robot name=\"...\">");
  if (const char* version = robot.Attribute("version"); version && std::string_view(version) != "1.0")
    throw InputError(fmt::format("{}:{}", file, robot.GetLineNum()), "the version " + inQuotes(version), "1.0");
  if (!robot.FirstChildElement("link")) throw InputError(file, "a robot without links", "links and joints");
  for (const char* kind : {"link", "joint"}) checkNamesOf(robot, kind, file);
  for (const auto* joint = robot.FirstChildElement("joint"); joint; joint = joint->NextSiblingElement("joint"))
    checkJointWords(*joint, file);
}

void checkJointNumbers(const XMLElement& joint, const std::string& file) {
  const std::string where = placeOf(joint, file);
  checkPlace(joint, where);
  checkAttributes(joint.FirstChildElement("axis"), {"xyz"}, where);
  checkNumbers(joint, kJointNumbers, where);
  requireText(joint.FirstChildElement("mimic"), "joint", where);
}

void checkLinkNumbers(const XMLElement& part, const XMLElement& link, const std::string& file) {
  const std::string where = placeOf(link, file);
  checkPlace(part, where);
  const XMLElement* geometry = part.FirstChildElement("geometry");
  if (!geometry) return;
  checkNumbers(*geometry, kSolidNumbers, where);
  requireText(geometry->FirstChildElement("mesh"), "filename", where);
}

}  // namespace tubeplan::app
