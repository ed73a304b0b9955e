#include "app/documents/figures_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <vector>

#include "app/documents/figures.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;
// JSON objects in which paths are looked up: the document first, the current entry last.
using Scopes = std::vector<const json*>;

/// Removes and returns the part of `text` before `mark`, and removes the mark too. Without a mark, takes the whole
/// text.
std::string_view takeUpTo(std::string_view& text, char mark) {
  const auto end = text.find(mark);
  const auto taken = text.substr(0, end);
  text = end == text.npos ? "" : text.substr(end + 1);
  return taken;
}

/// If `text` begins with `mark`, removes it and returns true.
bool takeMark(std::string_view& text, char mark) {
  if (!text.starts_with(mark)) return false;
  text.remove_prefix(1);
  return true;
}

struct FigureFormat {
  bool in_columns = false;
  std::string align, sign, digits;
  int width = 0;
  char type = 0;
};

FigureFormat parseFigureFormat(std::string_view text) {
  static const std::regex kFormat(R"((\*?)([<>]?)(\+?)(\d*)(\.\d+)?(.?))");
  std::cmatch part;
  if (!std::regex_match(text.data(), text.data() + text.size(), part, kFormat))
    throw std::logic_error(fmt::format("no format of a figure: '{}'", text));
  return {part.length(1) > 0,
          part.str(2),
          part.str(3),
          part.str(5),
          part.length(4) ? std::stoi(part.str(4)) : 0,
          part.length(6) ? *part[6].first : '\0'};
}

const Unit& lengthUnitOf(const json& document) {
  return *findUnit(UnitKind::kLength, document.at("units").at("length").get<std::string>());
}

std::string writtenNumber(double value, const FigureFormat& format, const json& document) {
  const auto written = [&](double shown, std::string_view digits, std::string_view type) {
    return fmt::format(fmt::runtime(fmt::format("{{:{}{}{}}}", format.sign, digits, type)), shown);
  };
  switch (format.type) {
    case 'l':
      return written(value, fmt::format(".{}", lengthDecimals(lengthUnitOf(document))), "f");
    case '%':
      return written(100 * value, format.digits, "f");
    case 'p':
      return chanceText(value);
    case 'a':
      value = std::abs(value);
      [[fallthrough]];
    case 'r':
      return significantText(value, std::stoi(format.digits.substr(1)));
    default:
      return written(value, format.digits, format.type ? std::string(1, format.type) : "");
  }
}

/// Returns an interval as text. If one bound is missing, as for a stiffness that may be infinite, it reads "... or
/// more" or "... or less".
std::string writtenInterval(const json& interval, const FigureFormat& format) {
  const auto end = [&](int k) {
    return significantText(interval[k].get<double>(), std::stoi(format.digits.substr(1)));
  };
  if (interval[0].is_null()) return interval[1].is_null() ? "anything" : end(1) + " or less";
  return interval[1].is_null() ? end(0) + " or more" : end(0) + " to " + end(1);
}

std::string writtenValue(const json& value, const FigureFormat& format, const json& document) {
  if (value.is_null() || (value.is_number() && !std::isfinite(value.get<double>()))) return "none";
  if (value.is_string()) return format.type == 'n' ? nameInLine(value.get<std::string>()) : value.get<std::string>();
  if (format.type == 'i') return writtenInterval(value, format);
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_integer() && !format.type && format.sign.empty()) return value.dump();
  if (value.is_number()) return writtenNumber(value.get<double>(), format, document);
  std::vector<std::string> all;
  for (const auto& [key, entry] : value.items()) {
    all.push_back(writtenValue(entry, format, document));
    if (format.in_columns)
      all.back() = fmt::format(" {:>{}}", all.back(), std::max(format.width, 1) - 1);
    else if (value.is_object())
      all.back() += " " + key;
  }
  return fmt::format("{}", fmt::join(all, format.in_columns ? "" : ", "));
}

const json* figureIn(const json& in, std::string_view path) {
  const json* at = &in;
  while (!path.empty()) {
    const std::string key(takeUpTo(path, '/'));
    const bool is_place = std::ranges::all_of(key, [](unsigned char c) { return std::isdigit(c); });
    if (at->is_array() && is_place && std::stoul(key) < at->size())
      at = &(*at)[std::stoul(key)];
    else if (at->is_object() && at->contains(key))
      at = &*at->find(key);
    else
      return nullptr;
  }
  return at;
}

const json& figureAt(const Scopes& scopes, std::string_view path) {
  for (auto scope = scopes.rbegin(); scope != scopes.rend(); ++scope)
    if (const json* found = figureIn(**scope, path)) return *found;
  throw std::logic_error(fmt::format("no figure '{}' for the text of a document", path));
}

/// Returns the value of a placeholder, which begins with its path.
json valueOf(std::string_view placeholder, const Scopes& scopes, const TextLine& line) {
  const std::string_view path = takeUpTo(placeholder, ':');
  if (path == "@") return line.name;
  return path.starts_with('#') ? json(figureAt(scopes, path.substr(1)).size()) : figureAt(scopes, path);
}

/// Returns the text that replaces a placeholder; `placeholder` is the part between the braces.
std::string filled(std::string_view placeholder, const json& value, const Scopes& scopes) {
  std::string_view remaining = placeholder;
  (void)takeUpTo(remaining, ':');
  const FigureFormat format = parseFigureFormat(takeUpTo(remaining, ' '));
  std::string text = writtenValue(value, format, *scopes.front());
  if (!remaining.empty() && !value.is_null()) text += " " + figureAt(scopes, remaining).get<std::string>();
  const bool is_left = format.align == "<" || (format.align.empty() && value.is_string());
  return is_left ? fmt::format("{:<{}}", text, format.width) : fmt::format("{:>{}}", text, format.width);
}

std::string textOf(const Scopes& scopes, std::span<const TextLine> lines);

/// Returns words in which every "(ONE|SEVERAL)" is replaced by one of the two.
std::string agreeing(std::string_view words, bool is_one) {
  static const std::regex kChoice(R"(\(([^()|]*)\|([^()|]*)\))");
  return std::regex_replace(std::string(words), kChoice, is_one ? "$1" : "$2");
}

/// Returns a line filled in with values of the innermost scope, followed by its inner lines.
std::string filledIn(const Scopes& scopes, const TextLine& line) {
  std::string text;
  std::string_view remaining = line.words;
  bool is_one = false;
  while (!remaining.empty()) {
    const bool has_figure = remaining.find('{') != remaining.npos;
    text += agreeing(takeUpTo(remaining, '{'), is_one);
    if (!has_figure) continue;
    const std::string_view placeholder = takeUpTo(remaining, '}');
    const json value = valueOf(placeholder, scopes, line);
    is_one = value == 1;
    text += filled(placeholder, value, scopes);
  }
  return text + textOf(scopes, line.inner);
}

bool isNothing(const json& value) {
  return value.is_null() || value == false || value == "" || (value.is_structured() && value.empty()) ||
         (value.is_number_integer() && value == 0) || (value.is_number() && !std::isfinite(value.get<double>()));
}

/// Returns the position after the innermost object or list of the scopes; a scalar inside it is excluded.
Scopes::const_iterator innermostObject(const Scopes& scopes) {
  return std::find_if(scopes.rbegin(), scopes.rend(), [](const json* scope) { return scope->is_structured(); }).base();
}

/// Adds the entries found at `path`, starting from the innermost scope, each with its enclosing objects. Lists on the
/// path contribute all their entries.
void addEntries(std::string_view path, const Scopes& scopes, std::vector<Scopes>& entries) {
  const auto descend = [&](const json& entry, std::string_view remaining_path) {
    Scopes inner = scopes;
    inner.push_back(&entry);
    if (remaining_path.empty() && !entry.is_array())
      entries.push_back(inner);
    else
      addEntries(remaining_path, inner, entries);
  };
  const json& innermost = *scopes.back();
  if (innermost.is_array()) {
    for (const auto& entry : innermost) descend(entry, path);
    return;
  }
  const auto key = takeUpTo(path, '/');
  const json* found = figureIn(innermost, key);
  if (found && !isNothing(*found)) descend(*found, path);
}

std::string textOf(const Scopes& scopes, std::span<const TextLine> lines) {
  std::string text;
  for (const auto& line : lines) {
    std::string_view path = line.of;
    const bool is_absence = takeMark(path, '!'), is_positive = takeMark(path, '+'), is_negative = takeMark(path, '-');
    std::vector<Scopes> entries;
    if (path.empty())
      entries.push_back(scopes);
    else
      addEntries(path, {scopes.begin(), innermostObject(scopes)}, entries);
    if (is_positive) std::erase_if(entries, [](const Scopes& found) { return *found.back() <= 0; });
    if (is_negative) std::erase_if(entries, [](const Scopes& found) { return *found.back() >= 0; });
    if (is_absence) entries = entries.empty() ? std::vector<Scopes>{scopes} : std::vector<Scopes>{};
    for (std::size_t k = 0; k < std::min(line.most, entries.size()); ++k) text += filledIn(entries[k], line);
  }
  return text;
}

}  // namespace

std::string textOf(const json& document, std::span<const TextLine> lines) { return textOf(Scopes{&document}, lines); }

std::string textOf(const json& document, std::string_view words) { return filledIn({&document}, TextLine{"", words}); }

}  // namespace tubeplan::app
