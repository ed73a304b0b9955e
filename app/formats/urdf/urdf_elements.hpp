// Attributes and numbers of the XML elements in a URDF file.
#pragma once

#include <tinyxml2.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/formats/urdf/urdf_tree.hpp"

namespace tubeplan::app {

/// Returns the text of an attribute; empty if the element or the attribute does not exist.
[[nodiscard]] std::string attributeOf(const tinyxml2::XMLElement* element, const char* name);

/// Returns the text of a required attribute. Throws InputError if the attribute is missing or empty.
[[nodiscard]] std::string requiredText(const tinyxml2::XMLElement* element, const char* attribute,
                                       const std::string& where);

/// Returns the link that the child element `element` of a joint names: its parent or its child.
[[nodiscard]] std::string linkNamedBy(const tinyxml2::XMLElement& joint, const char* element);

/// Returns the location of a named element for messages: "robot.urdf:12 (joint elbow)".
[[nodiscard]] std::string placeOf(const tinyxml2::XMLElement& named, const std::string& file);

/// Throws InputError for unknown attributes: if an attribute were mistyped, the intended value would silently be zero.
void checkAttributes(const tinyxml2::XMLElement* element, const std::vector<std::string>& known,
                     const std::string& where);

/// Returns the finite numbers in the text, separated by blanks; nothing if there are none or a word is not a number.
[[nodiscard]] std::optional<std::vector<double>> writtenNumbers(std::string_view text);

/// Returns the child elements with the given name.
template <typename Element>
std::vector<Element*> childrenOf(Element& element, const char* name) {
  std::vector<Element*> children;
  for (auto* child = element.FirstChildElement(name); child; child = child->NextSiblingElement(name))
    children.push_back(child);
  return children;
}

/// Reader of numbers in the child elements of an element. Throws InputError for invalid numbers.
class UrdfNumbers {
 public:
  UrdfNumbers(const tinyxml2::XMLElement& parent, std::string where) : parent_(parent), where_(std::move(where)) {}

  /// Returns an optional number. Throws InputError for a number below `least` unless `least` is empty.
  [[nodiscard]] double number(const char* element, const char* attribute, const char* expected, double otherwise,
                              std::optional<double> least = {}) const;
  [[nodiscard]] Eigen::Vector3d vector(const char* element, const char* attribute, const char* expected,
                                       const Eigen::Vector3d& otherwise) const;

  /// Returns a required length [m], zero or more.
  [[nodiscard]] double length(const char* element, const char* attribute) const;
  [[nodiscard]] Eigen::Vector3d lengths(const char* element, const char* attribute) const;

  [[nodiscard]] UrdfTree::Origin origin() const;

 private:
  [[nodiscard]] std::optional<std::vector<double>> find(const char* name, const char* attribute, std::size_t count,
                                                        const char* expected, std::optional<double> least,
                                                        bool is_required) const;

  const tinyxml2::XMLElement& parent_;
  std::string where_;
};

}  // namespace tubeplan::app
