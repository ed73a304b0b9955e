#include "app/formats/urdf/urdf_tree.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tinyxml2.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string_view>

#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "app/storage/utf8.hpp"
#include "deflection/rotation.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using tinyxml2::XMLDocument, tinyxml2::XMLElement;

constexpr double kAnyNumber = -std::numeric_limits<double>::infinity();

/// Returns the text of an attribute; empty if the element or the attribute does not exist.
std::string attributeOf(const XMLElement* element, const char* name) {
  const char* value = element ? element->Attribute(name) : nullptr;
  return value ? value : "";
}

/// Returns the finite numbers in the text, separated by blanks; nothing if there are none or a word is not a number.
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

/// Returns the location of a named element for messages: "robot.urdf:12 (joint elbow)".
std::string placeOf(const XMLElement& named, const std::string& file) {
  return fmt::format("{}:{} ({} {})", file, named.GetLineNum(), named.Name(), nameInLine(attributeOf(&named, "name")));
}

/// Returns advice on text that should be numbers but is not; empty if the cause is unknown.
const char* adviceOn(std::string_view text) {
  if (text.find('$') != std::string_view::npos) return "convert xacro files first: xacro FILE > robot.urdf";
  if (text.find(',') != std::string_view::npos) return "numbers have a decimal point and stand apart by blanks";
  const auto begin_unit = [](char before, char c) { return before >= '0' && before <= '9' && (c == 'm' || c == 'd'); };
  if (std::ranges::adjacent_find(text, begin_unit) != text.end()) return "URDF has metres and radians, without units";
  return "";
}

/// Returns the text of a required attribute. Throws InputError if the attribute is missing or empty.
std::string requiredText(const XMLElement* element, const char* attribute, const std::string& where) {
  std::string text = attributeOf(element, attribute);
  if (text.empty())
    throw InputError::saying(where, fmt::format("the element {} has no {}", element->Name(), attribute),
                             fmt::format("write <{} {}=\"...\"/>", element->Name(), attribute));
  return text;
}

/// Throws InputError for unknown attributes: if an attribute were mistyped, the intended value would silently be zero.
void checkAttributes(const XMLElement* element, const std::vector<std::string>& known, const std::string& where) {
  for (const auto* attribute = element ? element->FirstAttribute() : nullptr; attribute; attribute = attribute->Next())
    if (std::ranges::find(known, attribute->Name()) == known.end())
      throw InputError(where,
                       fmt::format("the unknown attribute {} of {}", inQuotes(attribute->Name()), element->Name()),
                       alternatives(known), suggestion(attribute->Name(), known));
}

/// Returns the child elements with the given name.
template <typename Element>
std::vector<Element*> childrenOf(Element& element, const char* name) {
  std::vector<Element*> children;
  for (auto* child = element.FirstChildElement(name); child; child = child->NextSiblingElement(name))
    children.push_back(child);
  return children;
}

/// Returns the name and text of an element, such as " offset 0.2"; empty if the element has no text.
std::string wordsIn(const XMLElement* element) {
  return element && element->GetText() ? fmt::format(" {} {}", element->Name(), nameInLine(element->GetText())) : "";
}

/// Returns descriptions of the robot's `<transmission>` elements, keyed by joint name.
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

/// Reader of numbers in the child elements of an element. Throws InputError for invalid numbers.
class UrdfNumbers {
 public:
  UrdfNumbers(const XMLElement& parent, std::string where) : parent_(parent), where_(std::move(where)) {}

  double number(const char* element, const char* attribute, const char* expected, double otherwise,
                double least = kAnyNumber) const {
    const auto numbers = find(element, attribute, 1, expected, least, false);
    return numbers ? numbers->front() : otherwise;
  }

  Eigen::Vector3d vector(const char* element, const char* attribute, const char* expected,
                         const Eigen::Vector3d& otherwise) const {
    const auto numbers = find(element, attribute, 3, expected, kAnyNumber, false);
    return numbers ? Eigen::Vector3d(numbers->data()) : otherwise;
  }

  /// Returns a required length [m], zero or more.
  double length(const char* element, const char* attribute) const {
    return find(element, attribute, 1, "a length in m", 0, true)->front();
  }
  Eigen::Vector3d lengths(const char* element, const char* attribute) const {
    return Eigen::Vector3d(find(element, attribute, 3, "three lengths in m", 0, true)->data());
  }

  UrdfTree::Origin origin() const {
    checkAttributes(parent_.FirstChildElement("origin"), {"xyz", "rpy"}, where_);
    const Eigen::Vector3d xyz = vector("origin", "xyz", "three numbers in m", Eigen::Vector3d::Zero());
    return {xyz, vector("origin", "rpy", "three numbers in rad", Eigen::Vector3d::Zero())};
  }

 private:
  /// Returns the `count` numbers in an attribute of the first child element called `name`; nothing if the attribute is
  /// missing and not required. Throws InputError for invalid numbers and for a number below `least`.
  [[nodiscard]] std::optional<std::vector<double>> find(const char* name, const char* attribute, std::size_t count,
                                                        const char* expected, double least, bool is_required) const {
    const XMLElement* element = parent_.FirstChildElement(name);
    if (!element || (!is_required && !element->Attribute(attribute))) return {};
    const std::string text = attributeOf(element, attribute);
    auto numbers = writtenNumbers(text);
    if (!numbers || numbers->size() != count || std::ranges::min(*numbers) < least)
      throw InputError(where_, fmt::format("{} {}={}", name, attribute, inQuotes(text)), expected, adviceOn(text));
    return numbers;
  }

  const XMLElement& parent_;
  std::string where_;
};

/// Returns the solid of a link: box, cylinder, sphere or mesh.
UrdfTree::Solid solidOf(const XMLElement& geometry, const std::string& kind, const UrdfTree::Origin& origin,
                        const std::string& where) {
  const UrdfNumbers numbers(geometry, where);
  UrdfTree::Solid solid{kind, "", origin};
  if (kind == "box") solid.size = numbers.lengths("box", "size");
  if (kind == "sphere") solid.size.x() = numbers.length("sphere", "radius");
  if (kind == "cylinder")
    solid.size = Eigen::Vector3d(numbers.length("cylinder", "radius"), numbers.length("cylinder", "length"), 0);
  if (kind == "mesh") solid.file = requiredText(geometry.FirstChildElement("mesh"), "filename", where);
  return solid;
}

/// Returns the names of all elements of a kind, in file order. Throws InputError for a missing or duplicate name.
std::vector<std::string> namesOfKind(const XMLElement& robot, const char* kind, const std::string& file) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const XMLElement* one : childrenOf(robot, kind)) {
    const std::string name = attributeOf(one, "name");
    if (name.empty())
      throw InputError::saying(fmt::format("{}:{}", file, one->GetLineNum()), fmt::format("the {} has no name", kind),
                               fmt::format("write <{} name=\"...\">", kind));
    if (!seen.insert(name).second)
      throw InputError::saying(placeOf(*one, file), fmt::format("there is a second {} {}", kind, inQuotes(name)),
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
      throw InputError::saying(placeOf(joint, file), fmt::format("the joint has no {} link", end),
                               fmt::format("write <{} link=\"...\"/>", end));
}

class TreeReader {
 public:
  TreeReader(const std::string& text, const std::string& file) : file_(file) {
    if (document_.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS)
      throw InputError::saying(fmt::format("{}:{}", file_, std::max(1, document_.ErrorLineNum())),
                               text.find("<robot") == std::string::npos
                                   ? "the file is not XML, the format of a URDF robot"
                                   : "the XML of the robot breaks off here, or its tags do not match",
                               "check the file up to this line");
    robot_ = document_.FirstChildElement("robot");
    const XMLElement* root = document_.FirstChildElement();
    if (!robot_)
      throw InputError(file_, root ? fmt::format("the root element <{}>", nameInLine(root->Name())) : "no root element",
                       "<robot>, the root element of a URDF file", "convert other formats, such as SDF, to URDF first");
    refuseXacro(*robot_);
    settleAttributes(*robot_, file_);
    checkRobot();
    const auto links = namesOfKind(*robot_, "link", file_);
    (void)namesOfKind(*robot_, "joint", file_);
    for (const XMLElement* joint : childrenOf(*robot_, "joint")) checkJointWords(*joint, file_);
    checkTree(links);
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

  void checkRobot() const {
    const std::string where = fmt::format("{}:{}", file_, robot_->GetLineNum());
    if (attributeOf(robot_, "name").empty())
      throw InputError::saying(where, "the robot has no name", "write <robot name=\"...\">");
    if (const char* version = robot_->Attribute("version"); version && std::string_view(version) != "1.0")
      throw InputError(where, "URDF version " + inQuotes(version), "1.0", "convert the file to URDF 1.0");
    if (!robot_->FirstChildElement("link"))
      throw InputError::saying(file_, "the robot has no links", "check that the file describes links and joints");
  }

  /// Throws InputError unless the links form a tree: one root, and exactly one joint to a parent for every other link.
  void checkTree(const std::vector<std::string>& links) const {
    const std::set<std::string> known(links.begin(), links.end());
    std::map<std::string, std::string> carrier;
    for (XMLElement* joint : childrenOf(*robot_, "joint")) {
      const std::string name = attributeOf(joint, "name"), child = linkNamedBy(*joint, "child");
      for (const auto& link : {linkNamedBy(*joint, "parent"), child})
        if (!known.contains(link))
          throw InputError::saying(placeOf(*joint, file_),
                                   fmt::format("the robot has no link {}, which this joint names", inQuotes(link)),
                                   suggestion(link, links));
      if (const auto [first, is_new] = carrier.emplace(child, name); !is_new)
        throw InputError::saying(
            placeOf(*joint, file_),
            fmt::format("the link {} is also the child of the joint {}", inQuotes(child), inQuotes(first->second)),
            "make each link the child of one joint: closed chains are not supported");
    }
    std::vector<std::string> roots;
    for (const auto& link : links)
      if (!carrier.contains(link)) roots.push_back(link);
    if (roots.empty())
      throw InputError::saying(file_, "the links form a closed loop: each is the child of a joint",
                               "arrange the links as a tree with one root");
    if (roots.size() > 1)
      throw InputError::saying(
          file_, fmt::format("{} links are not the child of any joint: {}", roots.size(), fmt::join(roots, ", ")),
          "only the root may have no parent joint");
  }

  void readLink(const XMLElement& element) {
    const std::string name = attributeOf(&element, "name");
    auto& link = tree_.links[name];
    link.name = name;
    for (const XMLElement* inertial : childrenOf(element, "inertial")) {
      const auto origin = UrdfNumbers(*inertial, placeOf(element, file_)).origin();
      const double mass = massOf(*inertial, element);
      if (inertial != element.FirstChildElement("inertial")) continue;
      link.mass = mass;
      link.centre = origin.xyz;
      const auto ixx = writtenNumbers(attributeOf(inertial->FirstChildElement("inertia"), "ixx"));
      link.has_inertia = ixx && ixx->front() > 0;
    }
    for (const XMLElement* collision : childrenOf(element, "collision")) readCollision(*collision, element, link);
  }

  void readCollision(const XMLElement& collision, const XMLElement& element, UrdfTree::Link& link) {
    const std::string where = placeOf(element, file_);
    const auto origin = UrdfNumbers(collision, where).origin();
    const XMLElement* geometry = collision.FirstChildElement("geometry");
    const XMLElement* solid = geometry ? geometry->FirstChildElement() : nullptr;
    if (solid && std::set<std::string_view>{"box", "cylinder", "sphere", "mesh"}.contains(solid->Name()))
      link.solids.push_back(solidOf(*geometry, solid->Name(), origin, where));
    else
      tree_.left_out.push_back(solid ? fmt::format("the {} of link {}: write it into the cell's link_shapes",
                                                   nameInLine(solid->Name()), link.name)
                                     : fmt::format("a collision of link {}: it has no solid", link.name));
  }

  /// Returns the mass of a link [kg]. The inertia tensor has no effect and may be missing.
  [[nodiscard]] double massOf(const XMLElement& inertial, const XMLElement& link) const {
    const std::string mass = attributeOf(inertial.FirstChildElement("mass"), "value");
    const auto number = writtenNumbers(mass);
    if (!number || number->size() != 1 || number->front() < 0)
      throw InputError(placeOf(link, file_), mass.empty() ? "no mass in <inertial>" : "the mass " + inQuotes(mass),
                       "<mass value=\"...\"/> of 0 kg or more");
    return number->front();
  }

  [[nodiscard]] UrdfTree::Joint readJoint(const XMLElement& element) const {
    const std::string where = placeOf(element, file_);
    const UrdfNumbers numbers(element, where);
    UrdfTree::Joint joint;
    joint.name = attributeOf(&element, "name");
    joint.type = attributeOf(&element, "type");
    joint.controller = controllerWordsOf(element);
    joint.origin = numbers.origin();
    const XMLElement *axis = element.FirstChildElement("axis"), *limit = element.FirstChildElement("limit"),
                     *mimic = element.FirstChildElement("mimic");
    checkAttributes(axis, {"xyz"}, where);
    if (axis)
      joint.axis = numbers.vector("axis", "xyz", "three numbers that form a direction", Eigen::Vector3d::Zero());
    if (limit)
      joint.limits = {numbers.number("limit", "lower", "a number in rad or m", 0),
                      numbers.number("limit", "upper", "a number in rad or m", 0),
                      numbers.number("limit", "velocity", "a number, 0 or more", 0, 0)};
    if (mimic)
      joint.mimic = {requiredText(mimic, "joint", where), numbers.number("mimic", "multiplier", "a number", 1),
                     numbers.number("mimic", "offset", "a number in rad or m", 0)};
    if (!limit && (joint.type == "revolute" || joint.type == "prismatic"))
      throw InputError::saying(where, "the " + joint.type + " joint has no <limit>",
                               joint.type == "revolute"
                                   ? "add its limits; a joint that turns without end is of type continuous"
                                   : "add its limits");
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
