#include "app/formats/urdf/urdf_text.hpp"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cmath>

namespace tubeplan::app {

namespace {

using Eigen::Vector3d;

constexpr std::string_view kXmlBlanks = " \t\r\n";

/// Begin and end marks of XML constructs that are skipped, including any tags within them.
struct PassedOver {
  std::string_view begin, end;
};
constexpr PassedOver kPassedOver[] = {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}};

/// Reads the attributes after a tag's name. Returns the index of the > or /> that ends the tag; npos if the tag does
/// not end.
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

/// Returns the tag that begins at index `begin`; std::nullopt if the tag does not end.
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
  tag.text = text.substr(begin, end + 1 - begin);
  return tag;
}

/// Returns the first tag at or after index `from`; skips comments, declarations and raw text (CDATA). The text must be
/// well-formed: no tags are found after a syntax error.
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

/// Returns the names of the robot's own elements of a kind, in file order and as readUrdfTree() has them: with entities
/// resolved, and with blanks in place of line breaks.
std::vector<std::string> namesInRobot(const tinyxml2::XMLDocument& document, const char* element) {
  std::vector<std::string> names;
  const auto* robot = document.FirstChildElement("robot");
  for (const auto* child = robot ? robot->FirstChildElement(element) : nullptr; child;
       child = child->NextSiblingElement(element)) {
    const char* name = child->Attribute("name");
    std::ranges::replace_if(
        names.emplace_back(name ? name : ""), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  }
  return names;
}

/// Visits all tags of the text and records the tags of joints that belong to the robot element.
class JointTagWalk {
 public:
  JointTagWalk(std::string_view text, std::vector<std::string> names) : text_(text), names_(std::move(names)) {}

  void noteIn(UrdfTags& tags) {
    for (auto tag = nextXmlTag(text_, 0); tag && tags.robot_end.empty();) {
      const auto next = static_cast<std::size_t>(tag->text.data() + tag->text.size() - text_.data());
      if (tag->opens) note(*tag, tags);
      if (tag->opens && !tag->closes) within_.push_back(tag->name);
      if (!tag->opens && within_ == std::vector<std::string_view>{"robot"}) tags.robot_end = tag->text;
      if (!tag->opens && !within_.empty()) within_.pop_back();
      tag = nextXmlTag(text_, next);
    }
  }

 private:
  void note(const XmlTag& tag, UrdfTags& tags) {
    if (within_.empty() || within_[0] != "robot") return;
    if (within_.size() == 1 && tag.name == "joint" && count_ < names_.size())
      current_joint_ = &(tags.joints[names_[count_++]] = {tag, {}, {}});
    if (!current_joint_ || within_.size() != 2 || within_[1] != "joint") return;
    if (tag.name == "origin" && !current_joint_->origin) current_joint_->origin = tag;
    if (tag.name == "limit" && !current_joint_->limit) current_joint_->limit = tag;
  }

  std::string_view text_;
  std::vector<std::string> names_;
  std::size_t count_ = 0;
  std::vector<std::string_view> within_;
  UrdfJointTags* current_joint_ = nullptr;
};

}  // namespace

const XmlAttribute* XmlTag::find(std::string_view attribute) const {
  const auto found = std::ranges::find(attributes, attribute, &XmlAttribute::name);
  return found == attributes.end() ? nullptr : &*found;
}

UrdfTags urdfTagsOf(std::string_view text) {
  tinyxml2::XMLDocument document;
  UrdfTags tags;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) return tags;
  for (auto& link : namesInRobot(document, "link")) tags.links.insert(std::move(link));
  JointTagWalk(text, namesInRobot(document, "joint")).noteIn(tags);
  return tags;
}

bool isAsWritten(double a, double b) {
  return a == b || std::abs(a - b) <= kAsWritten * std::max(1., std::min(std::abs(a), std::abs(b)));
}

std::string decimalOf(double value) {
  std::string text = fmt::format("{:.12f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string decimalsOf(const Vector3d& v) {
  return fmt::format("{} {} {}", decimalOf(v.x()), decimalOf(v.y()), decimalOf(v.z()));
}

std::string withNumbers(std::string_view written, const Vector3d& was, const Vector3d& is) {
  std::string text;
  for (int k = 0; k < 3; ++k) {
    const std::size_t begin = std::min(written.find_first_not_of(" \t\r\n"), written.size()),
                      end = std::min(written.find_first_of(" \t\r\n", begin), written.size());
    if (begin == end) return decimalsOf(is);
    text.append(written.substr(0, begin));
    text.append(isAsWritten(was[k], is[k]) ? written.substr(begin, end - begin) : decimalOf(is[k]));
    written.remove_prefix(end);
  }
  return text.append(written);
}

void XmlChanges::replace(std::string_view piece, std::string by) {
  changes_.push_back({static_cast<std::size_t>(piece.data() - text_.data()), piece.size(), std::move(by)});
}

void XmlChanges::insertBehind(std::string_view piece, std::string more) {
  replace({piece.data() + piece.size(), 0}, std::move(more));
}

void XmlChanges::setAttribute(const XmlTag& tag, std::string_view attribute, const std::string& value) {
  if (const auto* found = tag.find(attribute)) return replace(found->value, value);
  const std::string_view last = tag.attributes.empty() ? tag.name : tag.attributes.back().value;
  const std::size_t quote = tag.attributes.empty() ? 0 : 1;
  insertBehind({last.data(), last.size() + quote}, fmt::format(" {}=\"{}\"", attribute, value));
}

std::string XmlChanges::changedText() {
  std::ranges::stable_sort(changes_, {}, &Change::at);
  std::string out;
  std::size_t from = 0;
  for (const auto& change : changes_) {
    out.append(text_.substr(from, change.at - from)).append(change.by);
    from = change.at + change.size;
  }
  return out.append(text_.substr(from));
}

}  // namespace tubeplan::app
