#include "app/formats/urdf/urdf_tree.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string_view>

#include "app/formats/urdf/urdf_document.hpp"
#include "app/formats/urdf/urdf_elements.hpp"
#include "app/storage/input_error.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::app {

namespace {

using tinyxml2::XMLElement;

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

class TreeReader {
 public:
  TreeReader(const std::string& text, const std::string& file)
      : file_(file), robot_(readUrdfDocument(text, file, document_)) {}

  UrdfTree read() {
    tree_.name = attributeOf(&robot_, "name");
    for (XMLElement* link : childrenOf(robot_, "link")) readLink(*link);
    auto transmissions = transmissionsOf(robot_);
    std::map<std::string, XMLElement*> joints;
    for (XMLElement* joint : childrenOf(robot_, "joint")) joints.emplace(attributeOf(joint, "name"), joint);
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
      throw InputError::problem(where, "the " + joint.type + " joint has no <limit>",
                                joint.type == "revolute"
                                    ? "add its limits; a joint that turns without end is of type continuous"
                                    : "add its limits");
    return joint;
  }

  const std::string& file_;
  tinyxml2::XMLDocument document_;
  XMLElement& robot_;
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
