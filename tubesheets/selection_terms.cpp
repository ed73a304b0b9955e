#include "tubesheets/selection_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <ranges>
#include <utility>

#include "tubesheets/csv_table.hpp"
#include "tubesheets/length_unit.hpp"
#include "tubesheets/tube_choice.hpp"

namespace tubeplan::tubesheets {
namespace {

template <class Predicate>
TermChoice keepIf(const std::vector<int>& candidates, Predicate predicate) {
  TermChoice choice;
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(choice.tubes), predicate);
  return choice;
}

TermChoice refuseTerm(std::string reason) { return {{}, std::move(reason)}; }

// Parses a count of 1 or more; returns std::nullopt if the argument is not such a number.
std::optional<int> parseCount(std::string_view argument) {
  const std::optional<int> count = parseInteger(argument);
  return count && *count >= 1 ? count : std::nullopt;
}

constexpr std::string_view kExpectedCount = "expected a whole number above zero after the colon";

TermChoice chooseAll(const Sheet&, const std::vector<int>& candidates, std::string_view) { return {candidates, ""}; }

TermChoice chooseOuter(const Sheet& sheet, const std::vector<int>& candidates, std::string_view argument) {
  const std::optional<int> depth = parseCount(argument);
  if (!depth) return refuseTerm(std::string(kExpectedCount));
  const std::vector<int> depths = peelDepths(sheet);
  return keepIf(candidates, [&](int tube) { return depths[tube] > 0 && depths[tube] <= *depth; });
}

// Parses a zone such as "-10:10:20:40in". Returns four limits in metres, or std::nullopt if the zone is malformed.
std::optional<std::vector<double>> parseZone(std::string_view argument) {
  const std::size_t unit_start = argument.find_last_not_of("abcdefghijklmnopqrstuvwxyz") + 1;
  const LengthUnit* unit = findLengthUnit(argument.substr(unit_start));
  if (unit == nullptr) return std::nullopt;
  std::vector<double> numbers;
  std::string_view remaining = argument.substr(0, unit_start);
  while (numbers.size() < 5) {
    const std::size_t colon = std::min(remaining.find(':'), remaining.size());
    const std::optional<double> number = parseNumber(remaining.substr(0, colon));
    if (!number) return std::nullopt;
    numbers.push_back(snapLength(*number * unit->metres));
    if (colon == remaining.size()) break;
    remaining.remove_prefix(colon + 1);
  }
  if (numbers.size() != 4) return std::nullopt;
  return numbers;
}

TermChoice chooseZone(const Sheet& sheet, const std::vector<int>& candidates, std::string_view argument) {
  const auto zone = parseZone(argument);
  if (!zone) return refuseTerm("expected zone:X0:X1:Y0:Y1 and a unit, as in zone:-10:10:20:40in (in, mm or m)");
  const double x0 = (*zone)[0], x1 = (*zone)[1], y0 = (*zone)[2], y1 = (*zone)[3];
  if (x0 > x1 || y0 > y1) return refuseTerm("the zone's limits are reversed: expected the smaller number first");
  TermChoice choice = keepIf(candidates, [&](int tube) {
    const Tube& hole = sheet.tubes[tube];
    return hole.x >= x0 && hole.x <= x1 && hole.y >= y0 && hole.y <= y1;
  });
  if (choice.tubes.empty()) choice.reason = "no hole of this sheet lies in that zone";
  return choice;
}

TermChoice requireLeg(const Sheet& sheet, const std::vector<int>& candidates, std::string_view argument) {
  const std::optional<Leg> leg = findLeg(argument);
  if (!leg) return refuseTerm("expected one of " + legNames() + " after the colon");
  if (*leg != sheet.leg)
    return refuseTerm(
        fmt::format("this list is for the {} leg, but the sheet is {}", legName(*leg), legName(sheet.leg)));
  return {candidates, ""};
}

TermChoice requireSheet(const Sheet& sheet, const std::vector<int>& candidates, std::string_view argument) {
  const std::string fingerprint = sheet.fingerprint();
  if (argument != fingerprint)
    return refuseTerm(fmt::format("this list is for the sheet {}, but this sheet is {}", argument, fingerprint));
  return {candidates, ""};
}

TermChoice thinEvery(const Sheet&, const std::vector<int>& candidates, std::string_view argument) {
  const std::optional<int> k = parseCount(argument);
  if (!k) return refuseTerm(std::string(kExpectedCount));
  return {chooseEvery(candidates, *k), ""};
}

TermChoice thinSpread(const Sheet& sheet, const std::vector<int>& candidates, std::string_view argument) {
  const std::optional<int> count = parseCount(argument);
  if (!count) return refuseTerm(std::string(kExpectedCount));
  if (*count > static_cast<int>(candidates.size()))
    return refuseTerm(
        fmt::format("the item asks for {} tubes, but the rest of the list selects {}", *count, candidates.size()));
  return {chooseSpread(sheet, candidates, *count), ""};
}

struct Span {
  int first = 0, last = 0;
};

// Takes a span such as "R3" or "R3-7" from the front of `text`. Returns false if the letter is present but no number
// follows.
bool takeSpan(std::string_view& text, char letter, std::optional<Span>& span) {
  const auto take_number = [&](int& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || number < 1) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
  };
  if (text.empty() || (text.front() & ~0x20) != letter) return true;
  text.remove_prefix(1);
  span.emplace();
  if (!take_number(span->first)) return false;
  span->last = span->first;
  if (!text.starts_with('-')) return true;
  text.remove_prefix(1);
  return take_number(span->last);
}

std::string explainSpan(std::string_view name, const Span& span, int last) {
  if (span.last < span.first) return fmt::format("the limits {0} {1} to {2} are reversed", name, span.first, span.last);
  if (span.last > last) return fmt::format("{0} {1} is not on this sheet: {0}s 1 to {2}", name, span.last, last);
  return "";
}

}  // namespace

const std::vector<SelectionTerm>& selectionTerms() {
  static const std::vector<SelectionTerm> terms{
      {"all", "all", "every tube of the sheet", TermRole::kSource, false, chooseAll},
      {"outer", "outer:N", "tubes at most N deep from the periphery", TermRole::kSource, true, chooseOuter},
      {"zone", "zone:X0:X1:Y0:Y1in", "tubes within x and y limits (in, mm or m)", TermRole::kSource, true, chooseZone},
      {"leg", "leg:hot", "refuse the list on another leg", TermRole::kGuard, true, requireLeg},
      {"sheet", "sheet:FINGERPRINT", "refuse the list on another sheet", TermRole::kGuard, true, requireSheet},
      {"every", "every:K", "of what the rest selects, every K-th by row and column", TermRole::kThinner, true,
       thinEvery},
      {"spread", "spread:N", "of what the rest selects, N tubes spread evenly", TermRole::kThinner, true, thinSpread},
  };
  return terms;
}

TermChoice chooseRange(const Sheet& sheet, const std::vector<int>& candidates, std::string_view range) {
  std::optional<Span> rows, columns;
  std::string_view remaining = range;
  const bool is_understood =
      takeSpan(remaining, 'R', rows) && takeSpan(remaining, 'C', columns) && remaining.empty() && (rows || columns);
  if (!is_understood) return refuseTerm("expected a range such as R10C20, R1-10C5-9, R10 or C20");
  const Span row = rows.value_or(Span{1, sheet.rows}), column = columns.value_or(Span{1, sheet.columns});
  const bool is_one_tube = row.first == row.last && column.first == column.last && rows && columns;
  if (is_one_tube && !sheet.indexOf(row.first, column.first))
    return refuseTerm(explainMissing(sheet, row.first, column.first));
  for (const std::string& reason : {explainSpan("row", row, sheet.rows), explainSpan("column", column, sheet.columns)})
    if (!reason.empty()) return refuseTerm(reason);
  TermChoice choice = keepIf(candidates, [&](int tube) {
    const Tube& hole = sheet.tubes[tube];
    return hole.row >= row.first && hole.row <= row.last && hole.column >= column.first && hole.column <= column.last;
  });
  if (choice.tubes.empty()) choice.reason = "no hole of this sheet lies in that range";
  return choice;
}

std::string explainMissing(const Sheet& sheet, int row, int column) {
  const auto is_in_row = [row](const Tube& tube) { return tube.row == row; };
  if (sheet.tubes.empty()) return tubeName(row, column) + " is not on this sheet, which has no holes";
  const auto [first_row, last_row] = std::ranges::minmax(sheet.tubes | std::views::transform(&Tube::row));
  const auto [first_column, last_column] = std::ranges::minmax(sheet.tubes | std::views::transform(&Tube::column));
  std::string text = fmt::format("{} is not on this sheet: rows {} to {}, columns {} to {}", tubeName(row, column),
                                 first_row, last_row, first_column, last_column);
  const auto first = std::find_if(sheet.tubes.begin(), sheet.tubes.end(), is_in_row);
  if (first == sheet.tubes.end()) return text;
  const auto last = std::find_if(sheet.tubes.rbegin(), sheet.tubes.rend(), is_in_row);
  text += fmt::format("; row {} has columns {} to {}", row, first->column, last->column);
  const bool is_gap = column > first->column && column < last->column;
  return text + (is_gap ? ", with no hole at this one" : "");
}

}  // namespace tubeplan::tubesheets
