// Tags of a URDF text with their places, and changes of single values that leave every other byte unchanged.
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

/// Attribute of a tag; `value` is part of the text, without its quotes and with its entities as written.
struct XmlAttribute {
  std::string_view name, value;
};

/// Tag of a text; `whole` includes < and >.
struct XmlTag {
  std::string_view whole, name;
  std::vector<XmlAttribute> attributes;
  bool opens = false;   ///< true for `<a>` and `<a/>`
  bool closes = false;  ///< true for `</a>` and `<a/>`

  /// Returns the attribute of that name; null if there is none.
  [[nodiscard]] const XmlAttribute* find(std::string_view attribute) const;
};

struct UrdfJointTags {
  XmlTag joint;
  std::optional<XmlTag> origin, limit;  ///< first `<origin>` and `<limit>` of the joint
};

/// Tags of a URDF file; all views refer to the text.
struct UrdfTags {
  std::map<std::string, UrdfJointTags> joints;  ///< tags of the joints, by name
  std::set<std::string> links;
  std::string_view robot_end;  ///< end tag `</robot>`
};

/// Returns the joints of a URDF text, as readUrdfTree reads them, without those that transmissions and controllers
/// name.
[[nodiscard]] UrdfTags urdfTagsOf(std::string_view text);

/// Accuracy of numbers with the twelve digits of an arm file [m, rad].
inline constexpr double kAsWritten = 5e-11;

/// Returns true if two numbers are equal to the digits of an arm file; infinities must be equal.
[[nodiscard]] bool isAsWritten(double a, double b);

/// Returns numbers to twelve decimals, finer than any instrument, without trailing zeros.
[[nodiscard]] std::string decimalOf(double value);
[[nodiscard]] std::string decimalsOf(const Eigen::Vector3d& v);

/// Returns three numbers as written, with changed ones as new decimals.
[[nodiscard]] std::string withNumbers(std::string_view written, const Eigen::Vector3d& was, const Eigen::Vector3d& is);

/// Replacements of pieces of a text that do not overlap. Every piece is a view of the text.
class XmlChanges {
 public:
  explicit XmlChanges(std::string_view text) : text_(text) {}

  void replace(std::string_view piece, std::string by);
  void insertBehind(std::string_view piece, std::string more);

  /// Sets the value of an attribute; a missing attribute is added after the others.
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
