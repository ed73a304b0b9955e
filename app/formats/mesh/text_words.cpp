#include "app/formats/mesh/text_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/storage/input_error.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr const char* kExportAgain = "export the part again";

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

}  // namespace

TextWords::TextWords(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
  if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
}

void TextWords::skipBlanks(bool over_lines) {
  for (; at_ < text_.size(); ++at_) {
    if (text_[at_] == '\n' && over_lines)
      ++line_;
    else if (!isBlank(text_[at_]))
      return;
  }
}

std::string_view TextWords::word() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && text_[at_] != '\n' && !isBlank(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

std::string_view TextWords::next() {
  skipBlanks(true);
  return word();
}

std::string_view TextWords::nextInLine() {
  skipBlanks(false);
  std::string_view found = word();
  while (found == "\\" && (skipBlanks(false), at_ < text_.size() && text_[at_] == '\n')) {
    ++at_;
    ++line_;
    skipBlanks(false);
    found = word();
  }
  return found;
}

void TextWords::skipLine() {
  at_ = std::min(text_.find('\n', at_), text_.size());
  if (atEnd()) return;
  ++at_;
  ++line_;
}

double TextWords::number() {
  const std::string_view found = nextInLine();
  const auto number = tubesheets::parseNumber(found.starts_with('+') ? found.substr(1) : found);
  if (!number) fail(found, "a finite number");
  return *number;
}

void TextWords::fail(std::string_view found, const std::string& expected) const {
  const std::string end = fmt::format("the end of the {}", atEnd() ? "file" : "line");
  throw InputError(where(), found.empty() ? end : inQuotes(found), expected, kExportAgain);
}

void TextWords::failWithProblem(const std::string& what) const {
  throw InputError::problem(where(), what, kExportAgain);
}

std::string TextWords::where() const { return fmt::format("{}:{}", name_, line_); }

}  // namespace tubeplan::app
