// Angles in the columns of a foreign table, which may be written in sixtieths.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/formats/foreign/foreign_table.hpp"
#include "app/formats/foreign/sexagesimal.hpp"

namespace tubeplan::app {

/// Returns the form of a column's first field that is not blank; nothing if that is no angle in sixtieths.
[[nodiscard]] std::optional<SixtiethForm> sixtiethForm(const ForeignTable& table, std::size_t column);

/// Returns the unit that a form's signs state; null for a form that may mean hours or degrees, or none.
[[nodiscard]] const Unit* unitOfForm(const std::optional<SixtiethForm>& form);

/// Throws InputError for a column of angles in several forms, or in sixtieths that may be of hours or of degrees.
/// `is_stated` is true if its heading or the user states the unit.
void requireOneForm(const ForeignTable& table, std::size_t column, bool is_stated);

/// Returns true if a column of degrees may be of hours: its name is an hour angle or a right ascension, and all its
/// numbers are from -12 to 12 or from 0 to 24.
[[nodiscard]] bool mayBeHours(const ForeignTable& table, std::size_t column);

/// Throws InputError, with both interpretations, for a column of degrees that may be hours; `quantity` is the meaning
/// assumed for it.
void refuseDoubtfulDegrees(const ForeignTable& table, std::size_t column, const std::string& quantity);

/// Returns the number of a field in the unit of its column, also for an angle in sixtieths; nothing if the field is no
/// number or contradicts the unit.
[[nodiscard]] std::optional<double> numberIn(std::string_view field, const Unit* unit);

}  // namespace tubeplan::app
