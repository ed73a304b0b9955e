#include "app/files/xml_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tubeplan::app {

namespace {

using Eigen::Vector3d;

}  // namespace

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
