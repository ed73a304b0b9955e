#include "app/documents/figure_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/documents/figure_units.hpp"
#include "app/documents/figures.hpp"
#include "app/storage/utf8.hpp"
#include "calibration/diagnosis/causes/cause.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

/// Full words for the abbreviations in JSON keys.
constexpr std::pair<std::string_view, std::string_view> kShort[] = {
    {"chi2", "chi-square"}, {"dof", "degree of freedom"},      {"dx", "x error"},
    {"dy", "y error"},      {"heldout", "held-out"},           {"rms", "root mean square"},
    {"p", "chance"},        {"rpy", "turns about x, y and z"}, {"sigma", "standard deviation"},
    {"F", "F statistic"},   {"sigmas", "standard deviations"}, {"s", "in seconds"}};

std::string wordsOfKey(const std::string& key) {
  std::istringstream parts(key);
  std::vector<std::string> words;
  for (std::string part; std::getline(parts, part, '_');) {
    const auto* meant = std::ranges::find(kShort, part, [](const auto& entry) { return entry.first; });
    words.push_back(meant == std::end(kShort) ? part : std::string(meant->second));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

bool isUnknown(const json& value) {
  return value.is_null() || (value.is_number_float() && !std::isfinite(value.get<double>()));
}

/// Returns the name that distinguishes an entry from the other entries of its list; if it has no name, its number,
/// starting from 1.
std::string entryName(const json& entry, std::size_t place) {
  if (entry.contains("effect") && entry.contains("at"))
    return calibration::causeTitle(cellText(entry["effect"], 1), cellText(entry["at"], 1));
  for (const char* key : {"name", "id", "joint", "row", "hole", "variable", "column"})
    if (entry.contains(key) && entry[key].is_string()) return cellText(entry[key], 1);
  return std::to_string(place + 1);
}

/// Returns the separator between a description and its continuation.
std::string between(const std::string& description) {
  if (description.empty()) return "";
  return description.ends_with(':') ? " " : ", ";
}

/// Collects the values contained in a JSON document, with their descriptions and units.
class FigureCollector {
 public:
  explicit FigureCollector(const json& document) {
    if (!isPlain(document)) add(document, {}, "");
  }

  std::vector<Figure> figures;

 private:
  /// Adds the values contained in `value`. `at` holds the attributes found so far, and `path` the keys without list
  /// indices.
  void add(const json& value, const Figure& at, const std::string& path) {
    if (isPlain(value)) return addPlain(value, at, path);
    scopes_.push_back(&value);
    for (std::size_t place = 0; const auto& [key, inner] : value.items()) {
      Figure next = at;
      if (value.is_array() && at.row.empty()) {
        next.list = at.column, next.column.clear(), next.row = key;
      } else {
        next.column += (at.column.empty() ? "" : "/") + key;
      }
      if (value.is_array())
        next.description += fmt::format(" {}:", entryName(inner, place++));
      else
        next.description += between(at.description) + wordsOfKey(key);
      add(inner, next, value.is_array() ? path : path.empty() ? key : path + "/" + key);
    }
    scopes_.pop_back();
  }

  void addPlain(const json& value, Figure figure, const std::string& path) {
    figure.value = value;
    if (hasReal(value)) figure.unit = figureUnit(path, scopes_);
    const json& holder = *scopes_.back();
    if (isUnknown(value)) figure.note = "not known";
    for (const char* key : {"of", "note"})
      if (value.is_number() && holder.is_object() && holder.contains(key) && holder[key].is_string())
        figure.note = holder[key].get<std::string>();
    figures.push_back(std::move(figure));
  }

  std::vector<const json*> scopes_;
};

}  // namespace

bool isPlain(const json& value) {
  return value.is_array() ? std::all_of(value.begin(), value.end(), isPlain) : !value.is_object() || value.empty();
}

bool hasReal(const json& value) {
  return value.is_array() ? std::any_of(value.begin(), value.end(), hasReal) : value.is_number_float();
}

std::string Figure::key() const {
  return fmt::format("{}{}{}", list.empty() ? "" : fmt::format("{}/{}", list, row),
                     list.empty() || column.empty() ? "" : "/", column);
}

std::vector<Figure> figuresOf(const json& document) {
  constexpr std::string_view kFirst[] = {"verdict", "sentence", "sentences", "status", "reason", "warnings", "to_do"};
  auto figures = FigureCollector(document).figures;
  std::ranges::stable_sort(figures, {}, [&](const Figure& figure) { return std::ranges::find(kFirst, figure.key()); });
  return figures;
}

std::string cellText(const json& value, int digits) {
  constexpr std::size_t kLongest = 1000000;
  if (isUnknown(value) || value.is_object()) return "";
  if (value.is_number_float()) return significantText(value.get<double>(), digits);
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (!value.is_string() && !value.is_array()) return value.dump();
  std::vector<std::string> parts;
  if (value.is_string()) {
    std::istringstream lines(value.get<std::string>());
    for (std::string line; std::getline(lines, line);) parts.push_back(printable(line, kLongest));
    return fmt::format("{}", fmt::join(parts, "\n"));
  }
  const bool has_lists = std::any_of(value.begin(), value.end(), [](const json& entry) { return entry.is_array(); });
  for (const auto& entry : value) parts.push_back(cellText(entry, digits));
  return fmt::format("{}", fmt::join(parts, has_lists ? "; " : ", "));
}

}  // namespace tubeplan::app
