// What the elements of a URDF must say, refused by line where they do not.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tinyxml2 {
class XMLElement;
}

namespace tubeplan::app {

/// An attribute's text; empty where there is no such element or attribute.
[[nodiscard]] std::string attributeOf(const tinyxml2::XMLElement* element, const char* name);

/// Finite numbers apart by blanks; empty where a piece is none.
[[nodiscard]] std::optional<std::vector<double>> numbersIn(std::string_view text);

/// "robot.urdf:12 (joint elbow)", of an element that has a name.
[[nodiscard]] std::string placeOf(const tinyxml2::XMLElement& named, const std::string& file);

/// Each throws InputError. Links and joints have names, each its own, and joints a type, a parent and a child; numbers
/// are as many as they should be.
void checkNames(const tinyxml2::XMLElement& robot, const std::string& file);
void checkJointNumbers(const tinyxml2::XMLElement& joint, const std::string& file);

/// Checks the numbers of an inertial or a collision element of a link; throws InputError for the first that is wrong.
void checkLinkNumbers(const tinyxml2::XMLElement& part, const tinyxml2::XMLElement& link, const std::string& file);

}  // namespace tubeplan::app
