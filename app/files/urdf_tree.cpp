#include "app/files/urdf_tree.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "app/files/input_error.hpp"
#include "app/files/suggestion.hpp"
#include "app/files/urdf_checks.hpp"
#include "app/files/utf8.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::app {

namespace {

using tinyxml2::XMLDocument, tinyxml2::XMLElement;

/// The child elements of this name.
template <typename Element>
std::vector<Element*> childrenOf(Element& element, const char* name) {
  std::vector<Element*> children;
  for (auto* child = element.FirstChildElement(name); child; child = child->NextSiblingElement(name))
    children.push_back(child);
  return children;
}

/// " offset 0.2" of an element with a text.
std::string wordsIn(const XMLElement* element) {
  return element && element->GetText() ? fmt::format(" {} {}", element->Name(), nameInLine(element->GetText())) : "";
}

/// What the `<transmission>`s of the robot say, by their joints' names.
std::map<std::string, std::string> transmissionsOf(XMLElement& robot) {
  std::map<std::string, std::string> words_by_joint;
  for (XMLElement* transmission : childrenOf(robot, "transmission")) {
    std::string words = wordsIn(transmission->FirstChildElement("mechanicalReduction"));
    for (const char* part : {"joint", "actuator"})
      for (XMLElement* element : childrenOf(*transmission, part))
        for (const char* number : {"mechanicalReduction", "offset"})
          words += wordsIn(element->FirstChildElement(number));
    for (XMLElement* joint : childrenOf(*transmission, "joint")) words_by_joint[attributeOf(joint, "name")] += words;
  }
  return words_by_joint;
}

UrdfTree::ControllerWords controllerWordsOf(const XMLElement& joint) {
  UrdfTree::ControllerWords words;
  const auto* soft = joint.FirstChildElement("safety_controller");
  const std::string lower = attributeOf(soft, "soft_lower_limit"), upper = attributeOf(soft, "soft_upper_limit");
  if (!lower.empty() || !upper.empty())
    words.soft_limits = fmt::format(" {} to {}", nameInLine(lower), nameInLine(upper));
  for (const char* edge : {"rising", "falling", "reference_position"})
    if (const auto at = attributeOf(joint.FirstChildElement("calibration"), edge); !at.empty())
      words.reference_marks += fmt::format(" {} {}", edge, nameInLine(at));
  return words;
}

std::string linkNamedBy(const XMLElement& joint, const char* element) {
  return attributeOf(joint.FirstChildElement(element), "link");
}

/// Takes breaks of lines within an attribute for blanks, and refuses characters, written by their numbers, that no name
/// has.
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

/// The numbers of an attribute that were checked before; `otherwise` where it is not there.
Eigen::Vector3d vectorIn(const XMLElement* element, const char* name, const Eigen::Vector3d& otherwise) {
  const auto numbers = numbersIn(attributeOf(element, name));
  return numbers ? Eigen::Vector3d(numbers->data()) : otherwise;
}
double numberIn(const XMLElement* element, const char* name, double otherwise) {
  const auto numbers = numbersIn(attributeOf(element, name));
  return numbers ? numbers->front() : otherwise;
}

UrdfTree::Origin originOf(const XMLElement& parent) {
  const XMLElement* origin = parent.FirstChildElement("origin");
  return {vectorIn(origin, "xyz", Eigen::Vector3d::Zero()), vectorIn(origin, "rpy", Eigen::Vector3d::Zero())};
}

UrdfTree::Solid solidOf(const XMLElement& collision, const XMLElement& solid) {
  UrdfTree::Solid read{solid.Name(), attributeOf(&solid, "filename"), originOf(collision)};
  const double radius = numberIn(&solid, "radius", 0);
  read.size = vectorIn(&solid, "size", {radius, numberIn(&solid, "length", 0), 0});
  return read;
}

class TreeReader {
 public:
  TreeReader(const std::string& text, const std::string& file) : file_(file) {
    if (document_.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS)
      throw InputError(
          fmt::format("{}:{}", file_, std::max(1, document_.ErrorLineNum())),
          text.find("<robot") == std::string::npos ? "no XML" : "XML that breaks off, or whose tags do not match",
          "a URDF robot");
    robot_ = document_.FirstChildElement("robot");
    const XMLElement* root = document_.FirstChildElement();
    if (!robot_)
      throw InputError(file_, "no robot" + (root ? ", but " + inQuotes(root->Name()) : ""), "a URDF robot",
                       "a file with another root, as SDF, is to be converted first");
    refuseXacro(*robot_);
    settleAttributes(*robot_, file_);
    checkNames(*robot_, file_);
    checkTree();
  }

  UrdfTree read() {
    tree_.name = attributeOf(robot_, "name");
    for (XMLElement* link : childrenOf(*robot_, "link")) readLink(*link);
    auto transmissions = transmissionsOf(*robot_);
    std::map<std::string, XMLElement*> joints;
    for (XMLElement* joint : childrenOf(*robot_, "joint")) joints.emplace(attributeOf(joint, "name"), joint);
    for (const auto& [name, joint] : joints) {
      auto &parent = tree_.links.at(linkNamedBy(*joint, "parent")),
           &child = tree_.links.at(linkNamedBy(*joint, "child"));
      child.joint = readJoint(*joint);
      child.joint->controller.transmission = transmissions[name];
      child.parent = &parent;
      parent.children.push_back(&child);
    }
    for (const auto& [name, link] : tree_.links)
      if (!link.joint) tree_.root = &link;
    return std::move(tree_);
  }

 private:
  [[noreturn]] void refuseAsXacro(const XMLElement& element, const char* found) const {
    throw InputError(fmt::format("{}:{}", file_, element.GetLineNum()), inQuotes(found), "plain URDF",
                     "convert xacro files first: xacro FILE > robot.urdf");
  }

  void refuseXacro(const XMLElement& element) const {
    if (std::string_view(element.Name()).starts_with("xacro:")) refuseAsXacro(element, element.Name());
    for (const auto* attribute = element.FirstAttribute(); attribute; attribute = attribute->Next())
      if (std::string_view(attribute->Value()).find("${") != std::string_view::npos)
        refuseAsXacro(element, attribute->Value());
    for (auto* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) refuseXacro(*child);
  }

  /// One root, and every other link behind one joint.
  void checkTree() const {
    std::vector<std::string> links;
    for (XMLElement* link : childrenOf(*robot_, "link")) links.push_back(attributeOf(link, "name"));
    const std::set<std::string> known(links.begin(), links.end());
    std::map<std::string, std::string> carrier;
    for (XMLElement* joint : childrenOf(*robot_, "joint")) {
      const std::string name = attributeOf(joint, "name"), child = linkNamedBy(*joint, "child");
      for (const auto& link : {linkNamedBy(*joint, "parent"), child})
        if (!known.contains(link))
          throw InputError(placeOf(*joint, file_), "no link " + inQuotes(link),
                           "links of the robot as parent and child", suggestion(link, links));
      if (const auto [first, is_new] = carrier.emplace(child, name); !is_new)
        throw InputError(placeOf(*joint, file_),
                         fmt::format("the link {} behind the joint {} too", inQuotes(child), inQuotes(first->second)),
                         "a tree: each link behind one joint", "closed chains cannot be taken");
    }
    std::vector<std::string> roots;
    for (const auto& link : links)
      if (!carrier.contains(link)) roots.push_back(link);
    if (roots.empty())
      throw InputError(file_, "links that form a closed loop, each behind a joint", "a tree of links with one root");
    if (roots.size() > 1)
      throw InputError(file_, fmt::format("{} links behind no joint: {}", roots.size(), alternatives(roots)),
                       "one root, with all other links behind it");
  }

  void readLink(const XMLElement& element) {
    const std::string name = attributeOf(&element, "name");
    auto& link = tree_.links[name];
    link.name = name;
    for (const XMLElement* inertial : childrenOf(element, "inertial")) checkInertial(*inertial, element);
    if (const XMLElement* inertial = element.FirstChildElement("inertial")) {
      link.mass = numberIn(inertial->FirstChildElement("mass"), "value", 0);
      link.centre = originOf(*inertial).xyz;
      link.has_inertia = numberIn(inertial->FirstChildElement("inertia"), "ixx", 0) > 0;
    }
    for (const XMLElement* collision : childrenOf(element, "collision")) {
      checkLinkNumbers(*collision, element, file_);
      const XMLElement* geometry = collision->FirstChildElement("geometry");
      const XMLElement* solid = geometry ? geometry->FirstChildElement() : nullptr;
      if (solid && std::set<std::string_view>{"box", "cylinder", "sphere", "mesh"}.contains(solid->Name()))
        link.solids.push_back(solidOf(*collision, *solid));
      else
        tree_.left_out.push_back(solid ? fmt::format("the {} of link {}: write it into the cell's link_shapes",
                                                     nameInLine(solid->Name()), name)
                                       : fmt::format("a collision of link {}: it has no solid", name));
    }
  }

  /// Masses count, and where they are; what turns them does not, and need not be there.
  void checkInertial(const XMLElement& inertial, const XMLElement& link) const {
    checkLinkNumbers(inertial, link, file_);
    const std::string mass = attributeOf(inertial.FirstChildElement("mass"), "value");
    const auto number = numbersIn(mass);
    if (!number || number->size() != 1 || number->front() < 0)
      throw InputError(placeOf(link, file_), mass.empty() ? "an inertial without mass" : "the mass " + inQuotes(mass),
                       "<mass value=\"...\"/>, 0 kg or more");
  }

  [[nodiscard]] UrdfTree::Joint readJoint(const XMLElement& element) const {
    checkJointNumbers(element, file_);
    UrdfTree::Joint joint;
    joint.name = attributeOf(&element, "name");
    joint.type = attributeOf(&element, "type");
    joint.origin = originOf(element);
    joint.controller = controllerWordsOf(element);
    if (const XMLElement* axis = element.FirstChildElement("axis"))
      joint.axis = vectorIn(axis, "xyz", Eigen::Vector3d::Zero());
    const XMLElement* limit = element.FirstChildElement("limit");
    if (limit)
      joint.limits = {numberIn(limit, "lower", 0), numberIn(limit, "upper", 0), numberIn(limit, "velocity", 0)};
    else if (joint.type == "revolute" || joint.type == "prismatic")
      throw InputError(placeOf(element, file_), "no <limit>", "the limits of a " + joint.type + " joint",
                       joint.type == "revolute" ? "a joint that turns without end is continuous" : "");
    if (const XMLElement* mimic = element.FirstChildElement("mimic"))
      joint.mimic = {attributeOf(mimic, "joint"), numberIn(mimic, "multiplier", 1), numberIn(mimic, "offset", 0)};
    return joint;
  }

  const std::string& file_;
  XMLDocument document_;
  XMLElement* robot_ = nullptr;
  UrdfTree tree_;
};

}  // namespace

Eigen::Isometry3d UrdfTree::Origin::pose() const {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = deflection::rotationFromFixedAngles<double>(rpy);
  X.translation() = xyz;
  return X;
}

UrdfTree readUrdfTree(const std::string& text, const std::string& file) { return TreeReader(text, file).read(); }

}  // namespace tubeplan::app
