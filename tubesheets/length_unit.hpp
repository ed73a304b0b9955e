// Units of length, as they occur in column names (x_in, x_mm, x_m) and in zones.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tubeplan::tubesheets {

struct LengthUnit {
  std::string_view suffix;  ///< suffix of a column name, such as "in"
  double metres;            ///< metres per unit
};

inline constexpr LengthUnit kInch{"in", 0.0254};
inline constexpr LengthUnit kMillimetre{"mm", 0.001};
inline constexpr LengthUnit kMetre{"m", 1.0};

/// Returns all units of length.
[[nodiscard]] std::span<const LengthUnit> lengthUnits();

/// Returns the unit with that suffix, or null if there is none.
[[nodiscard]] const LengthUnit* findLengthUnit(std::string_view suffix);

/// Returns the unit that a word names by its symbol or in full, in upper or lower case ("Inches", "millimetres"); null
/// if it names none.
[[nodiscard]] const LengthUnit* findLengthWord(std::string_view word);

/// Rounds a length [m] to the grid of 2^-44 m (57 femtometres) on which hole positions are stored. The grid is far
/// finer than the precision of any drawing, but coarse enough that a length printed in any unit is read back
/// bit-identically.
[[nodiscard]] double snapLength(double metres);

/// Returns a length in `unit` as the shortest decimal number that converts back to exactly `metres` after snapping.
/// `metres` must be snapped and finite.
[[nodiscard]] std::string formatLength(double metres, const LengthUnit& unit);

}  // namespace tubeplan::tubesheets
