#include "app/formats/urdf/urdf_document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "app/formats/urdf/urdf_elements.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "app/storage/utf8.hpp"

namespace tubeplan::app {

namespace {

using tinyxml2::XMLElement;

/// Replaces line breaks and tabs in attributes by blanks. Throws InputError for control characters, which XML can
/// encode as numeric references.
void settleAttributes(XMLElement& element, const std::string& file) {
  for (auto* attribute = element.FirstAttribute(); attribute; attribute = attribute->Next()) {
    std::string value = attribute->Value();
    if (!isPlainText(value))
      throw InputError(fmt::format("{}:{}", file, element.GetLineNum()), "a control character in " + inQuotes(value),
                       "plain text");
    const auto isBreak = [](char c) { return c == '\n' || c == '\r' || c == '\t'; };
    if (std::none_of(value.begin(), value.end(), isBreak)) continue;
    std::replace_if(value.begin(), value.end(), isBreak, ' ');
    element.SetAttribute(attribute->Name(), value.c_str());
  }
  for (auto* child = element.FirstChildElement(); child; child = child->NextSiblingElement())
    settleAttributes(*child, file);
}

/// Returns the names of all elements of a kind, in file order. Throws InputError for a missing or duplicate name.
std::vector<std::string> namesOfKind(const XMLElement& robot, const char* kind, const std::string& file) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const XMLElement* element : childrenOf(robot, kind)) {
    const std::string name = attributeOf(element, "name");
    if (name.empty())
      throw InputError::problem(fmt::format("{}:{}", file, element->GetLineNum()),
                                fmt::format("the {} has no name", kind), fmt::format("write <{} name=\"...\">", kind));
    if (!seen.insert(name).second)
      throw InputError::problem(placeOf(*element, file), fmt::format("there is a second {} {}", kind, inQuotes(name)),
                                "give each a name of its own");
    names.push_back(name);
  }
  return names;
}

void checkJointWords(const XMLElement& joint, const std::string& file) {
  static const std::vector<std::string> kTypes{"revolute", "continuous", "prismatic", "fixed", "floating", "planar"};
  const std::string type = attributeOf(&joint, "type");
  if (std::ranges::find(kTypes, type) == kTypes.end())
    throw InputError(placeOf(joint, file), type.empty() ? "no type" : "the type " + inQuotes(type),
                     alternatives(kTypes), suggestion(type, kTypes));
  for (const char* end : {"parent", "child"})
    if (attributeOf(joint.FirstChildElement(end), "link").empty())
      throw InputError::problem(placeOf(joint, file), fmt::format("the joint has no {} link", end),
                                fmt::format("write <{} link=\"...\"/>", end));
}

[[noreturn]] void refuseAsXacro(const XMLElement& element, const char* found, const std::string& file) {
  throw InputError(fmt::format("{}:{}", file, element.GetLineNum()), inQuotes(found), "plain URDF",
                   "convert xacro files first: xacro FILE > robot.urdf");
}

void refuseXacro(const XMLElement& element, const std::string& file) {
  if (std::string_view(element.Name()).starts_with("xacro:")) refuseAsXacro(element, element.Name(), file);
  for (const auto* attribute = element.FirstAttribute(); attribute; attribute = attribute->Next())
    if (std::string_view(attribute->Value()).find("${") != std::string_view::npos)
      refuseAsXacro(element, attribute->Value(), file);
  for (auto* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) refuseXacro(*child, file);
}

void checkRobot(const XMLElement& robot, const std::string& file) {
  const std::string where = fmt::format("{}:{}", file, robot.GetLineNum());
  if (attributeOf(&robot, "name").empty())
    throw InputError::problem(where, "the robot has no name", "write <robot name=\"...\">");
  if (const char* version = robot.Attribute("version"); version && std::string_view(version) != "1.0")
    throw InputError(where, "URDF version " + inQuotes(version), "1.0", "convert the file to URDF 1.0");
  if (!robot.FirstChildElement("link"))
    throw InputError::problem(file, "the robot has no links", "check that the file describes links and joints");
}

/// Throws InputError unless the links form a tree: one root, and exactly one joint to a parent for every other link.
void checkTree(XMLElement& robot, const std::vector<std::string>& links, const std::string& file) {
  const std::set<std::string> known(links.begin(), links.end());
  std::map<std::string, std::string> carrier;
  for (XMLElement* joint : childrenOf(robot, "joint")) {
    const std::string name = attributeOf(joint, "name"), child = linkNamedBy(*joint, "child");
    for (const auto& link : {linkNamedBy(*joint, "parent"), child})
      if (!known.contains(link))
        throw InputError::problem(placeOf(*joint, file),
                                  fmt::format("the robot has no link {}, which this joint names", inQuotes(link)),
                                  suggestion(link, links));
    if (const auto [first, is_new] = carrier.emplace(child, name); !is_new)
      throw InputError::problem(
          placeOf(*joint, file),
          fmt::format("the link {} is also the child of the joint {}", inQuotes(child), inQuotes(first->second)),
          "make each link the child of one joint: closed chains are not supported");
  }
  std::vector<std::string> roots;
  for (const auto& link : links)
    if (!carrier.contains(link)) roots.push_back(link);
  if (roots.empty())
    throw InputError::problem(file, "the links form a closed loop: each is the child of a joint",
                              "arrange the links as a tree with one root");
  if (roots.size() > 1)
    throw InputError::problem(
        file, fmt::format("{} links are not the child of any joint: {}", roots.size(), fmt::join(roots, ", ")),
        "only the root may have no parent joint");
}

}  // namespace

XMLElement& readUrdfDocument(const std::string& text, const std::string& file, tinyxml2::XMLDocument& document) {
  if (document.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS)
    throw InputError::problem(fmt::format("{}:{}", file, std::max(1, document.ErrorLineNum())),
                              text.find("<robot") == std::string::npos
                                  ? "the file is not XML, the format of a URDF robot"
                                  : "the XML of the robot breaks off here, or its tags do not match",
                              "check the file up to this line");
  XMLElement* robot = document.FirstChildElement("robot");
  const XMLElement* root = document.FirstChildElement();
  if (!robot)
    throw InputError(file, root ? fmt::format("the root element <{}>", nameInLine(root->Name())) : "no root element",
                     "<robot>, the root element of a URDF file", "convert other formats, such as SDF, to URDF first");
  refuseXacro(*robot, file);
  settleAttributes(*robot, file);
  checkRobot(*robot, file);
  const auto links = namesOfKind(*robot, "link", file);
  (void)namesOfKind(*robot, "joint", file);
  for (const XMLElement* joint : childrenOf(*robot, "joint")) checkJointWords(*joint, file);
  checkTree(*robot, links, file);
  return *robot;
}

}  // namespace tubeplan::app
