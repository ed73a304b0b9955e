#include "app/formats/foreign/foreign_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/formats/foreign/foreign_heading.hpp"
#include "app/formats/foreign/pointing_table.hpp"
#include "app/formats/other_file.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/lower_case.hpp"

namespace tubeplan::app {

namespace {

/// Words that may accompany the units in a line such as "length mm, angle deg".
constexpr std::array<std::string_view, 8> kQuantityWords{"length", "lengths",  "angle",   "angles",
                                                         "linear", "distance", "angular", "and"};

/// Returns the units that the text names; empty if it contains any word other than units and kQuantityWords.
std::vector<const Unit*> unitsIn(std::string_view text) {
  std::vector<const Unit*> units;
  constexpr std::string_view kWordSeparators = " \t,;/()[]:=";
  for (std::size_t start = 0; (start = text.find_first_not_of(kWordSeparators, start)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kWordSeparators, start), text.size());
    const std::string_view word = text.substr(start, end - start);
    start = end;
    if (const Unit* unit = findUnitWord(word))
      units.push_back(unit);
    else if (std::ranges::find(kQuantityWords, lowerCase(word)) == kQuantityWords.end())
      return {};
  }
  return units;
}

/// Returns true if a line states units and nothing else.
bool statesUnits(std::string_view line) { return !unitsIn(tubesheets::behindUnits(line)).empty(); }

/// Returns the units stated by lines that have the word `unit` or `units`, a colon or an equals sign, and then only
/// units. Throws InputError if two lines state different units of a kind.
std::map<UnitKind, StatedUnit> statedUnits(const std::vector<std::string>& lines, const std::string& file) {
  std::map<UnitKind, StatedUnit> stated;
  for (const auto& line : lines)
    for (const Unit* unit : unitsIn(tubesheets::behindUnits(line))) {
      const auto [known, is_new] = stated.try_emplace(unit->kind, StatedUnit{unit, line});
      if (!is_new && known->second.unit->name != unit->name)
        throw InputError::problem(
            file,
            fmt::format("the lines {} and {} state different units", inQuotes(known->second.line), inQuotes(line)),
            "remove the line that is wrong");
    }
  return stated;
}

}  // namespace

bool isBlankField(std::string_view field) {
  return field.empty() || field == "-" || field == "--" || field == "NaN" || field == "nan" || field == "n/a" ||
         field == "N/A";
}

ForeignTable parseForeignTable(std::string_view text, const std::string& file) {
  requireTable(file, text);
  if (isPointingData(text)) return parsePointingData(text, file);
  ForeignTable table{
      tubesheets::parseTextTable(text, {.isUnit = isUnitWord, .statesUnits = statesUnits}), file, {}, {}};
  if (const auto& problem = table.problem)
    throw InputError(problem->line > 0 ? fmt::format("{}:{}", file, problem->line) : file, problem->found,
                     problem->expected, problem->advice);
  table.units = statedUnits(table.lines_before, file);
  return table;
}

}  // namespace tubeplan::app
