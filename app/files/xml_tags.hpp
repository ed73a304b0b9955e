// Tags of an XML text by their places in it, for changes of single values that leave every other byte as it is.
#pragma once

#include <cstddef>
#include <optional>
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
  bool opens = false;   ///< <a> and <a/>
  bool closes = false;  ///< </a> and <a/>

  /// Null where there is none of that name.
  [[nodiscard]] const XmlAttribute* find(std::string_view attribute) const;
};

/// The first tag from there on; comments, declarations and raw text (CDATA) are passed over. The text must be
/// well-formed; the rest of one that is not has no tags.
[[nodiscard]] std::optional<XmlTag> nextXmlTag(std::string_view text, std::size_t from);

}  // namespace tubeplan::app
