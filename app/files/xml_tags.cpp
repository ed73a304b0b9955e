#include "app/files/xml_tags.hpp"

#include <algorithm>

namespace tubeplan::app {

namespace {

constexpr std::string_view kXmlBlanks = " \t\r\n";

/// What begins so ends so, tags or not in between.
struct PassedOver {
  std::string_view begin, end;
};
constexpr PassedOver kPassedOver[] = {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}};

/// Reads the attributes behind a tag's name, up to its > or />; returns where that begins, npos where it does not.
std::size_t readAttributes(std::string_view text, std::size_t at, XmlTag& tag) {
  for (;;) {
    at = text.find_first_not_of(kXmlBlanks, at);
    if (at == std::string_view::npos || text[at] == '>' || text[at] == '/') return at;
    const std::size_t name_end = text.find_first_of(" \t\r\n=", at), quote = text.find_first_of("\"'", at);
    if (quote == std::string_view::npos || name_end > quote) return std::string_view::npos;
    const std::size_t end = text.find(text[quote], quote + 1);
    if (end == std::string_view::npos) return end;
    tag.attributes.push_back({text.substr(at, name_end - at), text.substr(quote + 1, end - quote - 1)});
    at = end + 1;
  }
}

/// The tag whose < stands there.
std::optional<XmlTag> tagAt(std::string_view text, std::size_t begin) {
  XmlTag tag;
  tag.closes = text.substr(begin + 1).starts_with('/');
  tag.opens = !tag.closes;
  const std::size_t name = begin + (tag.closes ? 2 : 1), name_end = text.find_first_of(" \t\r\n/>", name);
  if (name_end == std::string_view::npos) return {};
  tag.name = text.substr(name, name_end - name);
  std::size_t end = readAttributes(text, name_end, tag);
  if (end == std::string_view::npos) return {};
  tag.closes = tag.closes || text[end] == '/';
  end = text.find('>', end);
  if (end == std::string_view::npos) return {};
  tag.whole = text.substr(begin, end + 1 - begin);
  return tag;
}

}  // namespace

const XmlAttribute* XmlTag::find(std::string_view attribute) const {
  const auto found = std::ranges::find(attributes, attribute, &XmlAttribute::name);
  return found == attributes.end() ? nullptr : &*found;
}

std::optional<XmlTag> nextXmlTag(std::string_view text, std::size_t from) {
  for (std::size_t at = text.find('<', from); at != std::string_view::npos; at = text.find('<', at)) {
    const auto passed = std::ranges::find_if(
        kPassedOver, [&](const PassedOver& kind) { return text.substr(at).starts_with(kind.begin); });
    if (passed == std::end(kPassedOver)) return tagAt(text, at);
    const std::size_t end = text.find(passed->end, at + passed->begin.size());
    if (end == std::string_view::npos) break;
    at = end + passed->end.size();
  }
  return {};
}

}  // namespace tubeplan::app
