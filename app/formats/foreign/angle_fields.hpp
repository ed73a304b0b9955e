// Columns of angles in a foreign table whose fields may be in sixtieths.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/formats/foreign/foreign_table.hpp"
#include "app/formats/foreign/sexagesimal.hpp"

namespace tubeplan::app {

/// Returns the form of a column's first field that is not blank; nothing where that is no angle in sixtieths.
[[nodiscard]] std::optional<SixtiethForm> sixtiethForm(const ForeignTable& table, std::size_t column);

/// Returns the unit that the signs of a form state; null where they leave it open.
[[nodiscard]] const Unit* unitOfForm(const std::optional<SixtiethForm>& form);

/// Throws InputError for a column of angles in several forms, or in sixtieths of which nothing says of what:
/// `is_stated` where its heading or the user does.
void requireOneForm(const ForeignTable& table, std::size_t column, bool is_stated);

/// Returns whether a column is called an hour angle or a right ascension and all its numbers are such as hours have,
/// from -12 to 12 or from 0 to 24, so that its degrees may be hours.
[[nodiscard]] bool mayBeHours(const ForeignTable& table, std::size_t column);

/// Throws InputError, with both readings, for a column whose degrees may be hours; `quantity` is what it is taken for.
void refuseDoubtfulDegrees(const ForeignTable& table, std::size_t column, const std::string& quantity);

/// Returns the number of a field in the unit of its column, of an angle in sixtieths too; nothing where it is none or
/// contradicts the unit.
[[nodiscard]] std::optional<double> numberIn(std::string_view field, const Unit* unit);

}  // namespace tubeplan::app
