// XML document of a URDF file, checked as a whole: plain URDF with one tree of named links and joints.
#pragma once

#include <tinyxml2.h>

#include <string>

namespace tubeplan::app {

/// Parses the text into `document` and returns the element `<robot>`. Throws InputError for XML that is damaged, for
/// xacro, for names that are missing or given twice, and for links that do not form one tree.
[[nodiscard]] tinyxml2::XMLElement& readUrdfDocument(const std::string& text, const std::string& file,
                                                     tinyxml2::XMLDocument& document);

}  // namespace tubeplan::app
