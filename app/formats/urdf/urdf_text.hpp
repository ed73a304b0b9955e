// The text of a URDF by the places of its tags, and changes of single values that leave every other byte as it is.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::app {

/// `value` lies within the text, without its quotes and with its entities as they are written.
struct XmlAttribute {
  std::string_view name, value;
};

/// `whole` runs from < to >.
struct XmlTag {
  std::string_view whole, name;
  std::vector<XmlAttribute> attributes;
  bool opens = false;   ///< `<a>` and `<a/>`
  bool closes = false;  ///< `</a>` and `<a/>`

  /// Null where there is none of that name.
  [[nodiscard]] const XmlAttribute* find(std::string_view attribute) const;
};

struct UrdfJointTags {
  XmlTag joint;
  std::optional<XmlTag> origin, limit;  ///< the first of each
};

/// All views lie within the text.
struct UrdfTags {
  std::map<std::string, UrdfJointTags> joints;  ///< by name
  std::set<std::string> links;
  std::string_view robot_end;  ///< `</robot>`
};

/// Returns the joints of a URDF text that readUrdfTree reads. Joints that transmissions and controllers name are none.
[[nodiscard]] UrdfTags urdfTagsOf(std::string_view text);

/// m, rad: what the twelve digits of an arm file leave of a number.
inline constexpr double kAsWritten = 5e-11;

/// Returns whether two numbers are one to the digits of an arm file; infinities are one where they are equal.
[[nodiscard]] bool isAsWritten(double a, double b);

/// To twelve decimals, which is less than any instrument sees, without zeros at the end.
[[nodiscard]] std::string decimalOf(double value);
[[nodiscard]] std::string decimalsOf(const Eigen::Vector3d& v);

/// Three numbers as they are written, those that are others now by their decimals.
[[nodiscard]] std::string withNumbers(std::string_view written, const Eigen::Vector3d& was, const Eigen::Vector3d& is);

/// Pieces of a text to be put in places of others, which do not overlap. Every piece is a view into the text.
class XmlChanges {
 public:
  explicit XmlChanges(std::string_view text) : text_(text) {}

  void replace(std::string_view piece, std::string by);
  void insertBehind(std::string_view piece, std::string more);

  /// Behind the others where the tag has no such attribute.
  void setAttribute(const XmlTag& tag, std::string_view attribute, const std::string& value);

  [[nodiscard]] std::string changedText();

 private:
  struct Change {
    std::size_t at, size;
    std::string by;
  };
  std::string_view text_;
  std::vector<Change> changes_;
};

}  // namespace tubeplan::app
