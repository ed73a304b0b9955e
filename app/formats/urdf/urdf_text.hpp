// Tags of URDF text with their positions, and changes of single values that leave every other byte unchanged.
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

/// Attribute of a tag; `value` is a view of the text between the quotes, with entities as written.
struct XmlAttribute {
  std::string_view name, value;
};

/// Tag in XML text; `text` includes < and >.
struct XmlTag {
  std::string_view text, name;
  std::vector<XmlAttribute> attributes;
  bool opens = false;   ///< true for a tag that opens an element: `<a>` and `<a/>`
  bool closes = false;  ///< true for a tag that closes an element: `</a>` and `<a/>`

  /// Returns the attribute with the given name; null if there is none.
  [[nodiscard]] const XmlAttribute* find(std::string_view attribute) const;
};

struct UrdfJointTags {
  XmlTag joint;
  std::optional<XmlTag> origin, limit;  ///< first `<origin>` and `<limit>` in the joint
};

/// Tags of a URDF file, as views of its text.
struct UrdfTags {
  std::map<std::string, UrdfJointTags> joints;  ///< tags of the robot's joints, keyed by joint name
  std::set<std::string> links;
  std::string_view robot_end;  ///< end tag `</robot>`
};

/// Returns the tags in URDF text of the joints that readUrdfTree() reads, without elements in transmissions and
/// controllers that merely refer to joints.
[[nodiscard]] UrdfTags urdfTagsOf(std::string_view text);

/// Tolerance for values that an arm file states to twelve digits [m, rad].
inline constexpr double kAsWritten = 5e-11;

/// Returns true if two numbers are equal to the precision of an arm file; infinities must be equal.
[[nodiscard]] bool isAsWritten(double a, double b);

/// Return numbers as text with twelve decimals, finer than any instrument resolves, without trailing zeros.
[[nodiscard]] std::string decimalOf(double value);
[[nodiscard]] std::string decimalsOf(const Eigen::Vector3d& v);

/// Returns `written`, the text of the three numbers `was`, with those numbers replaced that differ in `is`.
[[nodiscard]] std::string withNumbers(std::string_view written, const Eigen::Vector3d& was, const Eigen::Vector3d& is);

/// Replacements of non-overlapping pieces of the text. Every piece must be a view of the text.
class XmlChanges {
 public:
  explicit XmlChanges(std::string_view text) : text_(text) {}

  void replace(std::string_view piece, std::string by);
  void insertBehind(std::string_view piece, std::string more);

  /// Sets the value of an attribute; a missing attribute is added after the tag's other attributes.
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
