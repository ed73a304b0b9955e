// Angles in columns of a foreign table. They may be sexagesimal: degrees or hours, minutes and seconds.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/formats/foreign/foreign_table.hpp"
#include "app/formats/foreign/sexagesimal.hpp"

namespace tubeplan::app {

/// Returns the notation of the first non-blank field of a column; std::nullopt if that field is not a sexagesimal
/// angle.
[[nodiscard]] std::optional<SixtiethForm> sixtiethForm(const ForeignTable& table, std::size_t column);

/// Returns the unit that a notation implies by its signs (h, d or °); null for a notation that may mean hours or
/// degrees, or if there is none.
[[nodiscard]] const Unit* unitOfForm(const std::optional<SixtiethForm>& form);

/// Throws InputError for a column with angles in several notations, or with sexagesimal angles in an unknown unit
/// (hours or degrees). `is_stated` is true if the column's heading or the user states the unit.
void requireOneForm(const ForeignTable& table, std::size_t column, bool is_stated);

/// Returns true if a column stated in degrees may in fact be in hours: its heading names an hour angle or a right
/// ascension, and all its numbers are from -12 to 12 or from 0 to 24.
[[nodiscard]] bool mayBeHours(const ForeignTable& table, std::size_t column);

/// Throws InputError, with both interpretations, if a column stated in degrees may in fact be in hours; `quantity` is
/// the quantity assigned to the column.
void refuseDoubtfulDegrees(const ForeignTable& table, std::size_t column, const std::string& quantity);

/// Returns the number in a field, converted to the column's unit; sexagesimal angles are accepted. Returns std::nullopt
/// if the field is not a number or contradicts the unit.
[[nodiscard]] std::optional<double> numberIn(std::string_view field, const Unit* unit);

}  // namespace tubeplan::app
