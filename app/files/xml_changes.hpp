// Changes of single values of an XML text, the rest of it byte for byte as it was.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/xml_tags.hpp"

namespace tubeplan::app {

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
