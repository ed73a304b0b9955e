// The joints of a URDF text by their places in it.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "app/files/xml_tags.hpp"

namespace tubeplan::app {

struct UrdfJointTags {
  XmlTag joint;
  std::optional<XmlTag> origin, limit;  ///< the first of each
};

/// All views lie within the text.
struct UrdfTags {
  std::map<std::string, UrdfJointTags> joints;  ///< by name
  std::set<std::string> links;
  std::string_view robot_end;  ///< </robot>
};

/// Returns the joints of a URDF text that readUrdfTree reads. Joints that transmissions and controllers name are none.
[[nodiscard]] UrdfTags urdfTagsOf(std::string_view text);

}  // namespace tubeplan::app
