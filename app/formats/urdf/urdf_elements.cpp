#include "app/formats/urdf/urdf_elements.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

using tinyxml2::XMLElement;

namespace {

/// Returns advice on text that should be numbers but is not; empty if the cause is unknown.
const char* adviceOn(std::string_view text) {
  if (text.find('$') != std::string_view::npos) return "convert xacro files first: xacro FILE > robot.urdf";
  if (text.find(',') != std::string_view::npos) return "numbers have a decimal point and are separated by blanks";
  const auto begin_unit = [](char before, char c) { return before >= '0' && before <= '9' && (c == 'm' || c == 'd'); };
  if (std::ranges::adjacent_find(text, begin_unit) != text.end()) return "URDF has metres and radians, without units";
  return "";
}

}  // namespace

std::string attributeOf(const XMLElement* element, const char* name) {
  const char* value = element ? element->Attribute(name) : nullptr;
  return value ? value : "";
}

std::string requiredText(const XMLElement* element, const char* attribute, const std::string& where) {
  std::string text = attributeOf(element, attribute);
  if (text.empty())
    throw InputError::problem(where, fmt::format("the element {} has no {}", element->Name(), attribute),
                              fmt::format("write <{} {}=\"...\"/>", element->Name(), attribute));
  return text;
}

std::string linkNamedBy(const XMLElement& joint, const char* element) {
  return attributeOf(joint.FirstChildElement(element), "link");
}

std::string placeOf(const XMLElement& named, const std::string& file) {
  return fmt::format("{}:{} ({} {})", file, named.GetLineNum(), named.Name(), nameInLine(attributeOf(&named, "name")));
}

void checkAttributes(const XMLElement* element, const std::vector<std::string>& known, const std::string& where) {
  for (const auto* attribute = element ? element->FirstAttribute() : nullptr; attribute; attribute = attribute->Next())
    if (std::ranges::find(known, attribute->Name()) == known.end())
      throw InputError(where,
                       fmt::format("the unknown attribute {} of {}", inQuotes(attribute->Name()), element->Name()),
                       alternatives(known), suggestion(attribute->Name(), known));
}

std::optional<std::vector<double>> writtenNumbers(std::string_view text) {
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

double UrdfNumbers::number(const char* element, const char* attribute, const char* expected, double otherwise,
                           std::optional<double> least) const {
  const auto numbers = find(element, attribute, 1, expected, least, false);
  return numbers ? numbers->front() : otherwise;
}

Eigen::Vector3d UrdfNumbers::vector(const char* element, const char* attribute, const char* expected,
                                    const Eigen::Vector3d& otherwise) const {
  const auto numbers = find(element, attribute, 3, expected, {}, false);
  return numbers ? Eigen::Vector3d(numbers->data()) : otherwise;
}

double UrdfNumbers::length(const char* element, const char* attribute) const {
  return find(element, attribute, 1, "a length in m", 0, true)->front();
}

Eigen::Vector3d UrdfNumbers::lengths(const char* element, const char* attribute) const {
  return Eigen::Vector3d(find(element, attribute, 3, "three lengths in m", 0, true)->data());
}

UrdfTree::Origin UrdfNumbers::origin() const {
  checkAttributes(parent_.FirstChildElement("origin"), {"xyz", "rpy"}, where_);
  const Eigen::Vector3d xyz = vector("origin", "xyz", "three numbers in m", Eigen::Vector3d::Zero());
  return {xyz, vector("origin", "rpy", "three numbers in rad", Eigen::Vector3d::Zero())};
}

/// Returns the `count` numbers in an attribute of the first child element called `name`; nothing if the attribute is
/// missing and not required. Throws InputError for invalid numbers and for a number below `least`.
std::optional<std::vector<double>> UrdfNumbers::find(const char* name, const char* attribute, std::size_t count,
                                                     const char* expected, std::optional<double> least,
                                                     bool is_required) const {
  const XMLElement* element = parent_.FirstChildElement(name);
  if (!element || (!is_required && !element->Attribute(attribute))) return {};
  const std::string text = attributeOf(element, attribute);
  auto numbers = writtenNumbers(text);
  if (!numbers || numbers->size() != count || (least && std::ranges::min(*numbers) < *least))
    throw InputError(where_, fmt::format("{} {}={}", name, attribute, inQuotes(text)), expected, adviceOn(text));
  return numbers;
}

}  // namespace tubeplan::app
