#include "app/formats/foreign/angle_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "app/formats/foreign/foreign_heading.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"

namespace tubeplan::app {

namespace {

const ForeignRow* firstRowWith(const ForeignTable& table, std::size_t column) {
  const auto found =
      std::ranges::find_if(table.rows, [&](const auto& row) { return !isBlankField(row.fields[column]); });
  return found == table.rows.end() ? nullptr : &*found;
}

/// Returns true for an angle or a number in a notation other than `form`. Fields that are neither are rejected later,
/// by their reader.
bool isOfAnotherForm(std::string_view field, const std::optional<SixtiethForm>& form) {
  if (const auto angle = parseSexagesimal(field)) return form != angle->form;
  return form && signedNumber(field);
}

struct NumberRange {
  double least = std::numeric_limits<double>::infinity(), most = -least;
};

/// Returns the range of the numbers in a column whose heading names an hour angle or a right ascension. Returns
/// std::nullopt for other columns, columns without numbers, and columns with fields that are not numbers.
std::optional<NumberRange> rangeOfHourAngle(const ForeignTable& table, std::size_t column) {
  constexpr std::array<std::string_view, 5> kHourNames{"ha", "hourangle", "hourang", "ra", "rightascension"};
  const std::string name = parseHeading(table.columns[column]).name;
  if (std::ranges::find(kHourNames, name) == kHourNames.end()) return std::nullopt;
  NumberRange range;
  for (const auto& row : table.rows) {
    if (isBlankField(row.fields[column])) continue;
    const auto number = signedNumber(row.fields[column]);
    if (!number) return std::nullopt;
    range = {std::min(range.least, *number), std::max(range.most, *number)};
  }
  return range.least <= range.most ? std::optional(range) : std::nullopt;
}

}  // namespace

std::optional<SixtiethForm> sixtiethForm(const ForeignTable& table, std::size_t column) {
  const ForeignRow* first = firstRowWith(table, column);
  const auto angle = first ? parseSexagesimal(first->fields[column]) : std::nullopt;
  return angle ? std::optional(angle->form) : std::nullopt;
}

const Unit* unitOfForm(const std::optional<SixtiethForm>& form) {
  if (!form || isBare(*form)) return nullptr;
  return form == SixtiethForm::kHours ? sixtiethsOfHours() : sixtiethsOfDegrees();
}

void requireOneForm(const ForeignTable& table, std::size_t column, bool is_stated) {
  const ForeignRow* first = firstRowWith(table, column);
  if (!first) return;
  const auto form = sixtiethForm(table, column);
  const std::string &heading = table.columns[column], &text = first->fields[column];
  for (const auto& row : table.rows)
    if (isOfAnotherForm(row.fields[column], form))
      throw InputError::problem(fmt::format("{}:{} (column {})", table.file, row.line, inQuotes(heading)),
                                fmt::format("the angle {} is written in a different form from {} in line {}",
                                            inQuotes(row.fields[column]), inQuotes(text), first->line),
                                "write all angles of the column in the same form");
  if (!form || !isBare(*form) || is_stated) return;
  const double value = parseSexagesimal(text)->value;
  throw InputError::problem(
      fmt::format("the column {} of {}", inQuotes(heading), table.file),
      fmt::format("{} may be hours, minutes and seconds ({:.6g} deg) or degrees, minutes and seconds ({:.6g} deg)",
                  inQuotes(text), value * kDegreesPerHour, value),
      fmt::format("rename the heading to '{0} [hms]' or '{0} [dms]', or write --column NAME_hms='{0}' or "
                  "NAME_dms='{0}'",
                  heading));
}

bool mayBeHours(const ForeignTable& table, std::size_t column) {
  const auto numbers = rangeOfHourAngle(table, column);
  constexpr double kHalfDay = 12;
  return numbers && ((numbers->least >= -kHalfDay && numbers->most <= kHalfDay) ||
                     (numbers->least >= 0 && numbers->most <= 2 * kHalfDay));
}

void refuseDoubtfulDegrees(const ForeignTable& table, std::size_t column, const std::string& quantity) {
  if (!mayBeHours(table, column)) return;
  const auto [least, most] = *rangeOfHourAngle(table, column);
  const std::string theirs = inQuotes(table.columns[column]);
  throw InputError::problem(
      fmt::format("the column {} of {}", theirs, table.file),
      fmt::format("its numbers, {0:.6g} to {1:.6g}, may be hours ({2:.6g} to {3:.6g} deg) or degrees", least, most,
                  least * kDegreesPerHour, most * kDegreesPerHour),
      fmt::format("write --column {0}_h={1} or --column {0}_deg={1}", quantity, theirs));
}

std::optional<double> numberIn(std::string_view field, const Unit* unit) {
  const bool is_in_sixtieths = unit && (unit == sixtiethsOfHours() || unit == sixtiethsOfDegrees());
  if (const auto number = signedNumber(field)) return is_in_sixtieths ? std::nullopt : number;
  const auto angle = unit && unit->kind == UnitKind::kAngle ? parseSexagesimal(field) : std::nullopt;
  if (!angle) return std::nullopt;
  const bool are_hours = unit == sixtiethsOfHours() || unit->name == "h";
  const bool are_degrees = unit == sixtiethsOfDegrees() || unit->name == "deg";
  const bool agrees =
      (are_hours && angle->form != SixtiethForm::kDegrees) || (are_degrees && angle->form != SixtiethForm::kHours);
  return agrees ? std::optional(angle->value) : std::nullopt;
}

}  // namespace tubeplan::app
