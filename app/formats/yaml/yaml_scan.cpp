#include "app/formats/yaml/yaml_scan.hpp"

#include <algorithm>

namespace tubeplan::app {

namespace {

// Returns true for a quote that opens a quoted scalar. Only a quote at the start of a value does so, unlike in "5'
// pipe".
bool startsQuote(std::string_view text, std::size_t at) {
  if (text[at] != '"' && text[at] != '\'') return false;
  const std::size_t before = at == 0 ? std::string_view::npos : text.find_last_not_of(" \n\r", at - 1);
  return before == std::string_view::npos || std::string_view(",[{:").find(text[before]) != std::string_view::npos;
}

}  // namespace

// Neither '' within single quotes nor \" within double quotes ends the scalar.
std::size_t pastQuoted(std::string_view text, std::size_t at) {
  const char quote = text[at];
  for (std::size_t i = at + 1; i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (text[i] == quote) {
      if (quote == '"' || i + 1 >= text.size() || text[i + 1] != '\'') return i + 1;
      ++i;
    }
  }
  return std::string_view::npos;
}

bool startsComment(std::string_view text, std::size_t at) {
  return text[at] == '#' && (at == 0 || text[at - 1] == ' ' || text[at - 1] == '\n');
}

std::size_t pastFlow(std::string_view text, std::size_t at) {
  int depth = 0;
  for (std::size_t i = at; i < text.size();) {
    if (startsComment(text, i)) {
      i = std::min(text.find('\n', i), text.size());
    } else if (startsQuote(text, i)) {
      i = std::min(pastQuoted(text, i), text.size());
    } else {
      depth += text[i] == '[' || text[i] == '{' ? 1 : text[i] == ']' || text[i] == '}' ? -1 : 0;
      ++i;
      if (depth == 0) return i;
    }
  }
  return text.size();
}

}  // namespace tubeplan::app
