// The units of length that a column's name (x_in, x_mm, x_m) or a zone may carry.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tubeplan::tubesheets {

struct LengthUnit {
  std::string_view suffix;  ///< as in a column's name: "in"
  double metres;            ///< metres per unit
};

inline constexpr LengthUnit kInch{"in", 0.0254};
inline constexpr LengthUnit kMillimetre{"mm", 0.001};
inline constexpr LengthUnit kMetre{"m", 1.0};

/// All of them.
[[nodiscard]] std::span<const LengthUnit> lengthUnits();

/// The unit of that suffix; null when there is none.
[[nodiscard]] const LengthUnit* findLengthUnit(std::string_view suffix);

/// The same by any word or sign for it, in any capitals: "Inches", "millimetres"; null when there is none.
[[nodiscard]] const LengthUnit* findLengthWord(std::string_view word);

/// Lengths [m] of drilled positions are kept on a grid of 2^-44 m (57 femtometre): far below any drawing, and coarse
/// enough that a length printed in another unit returns to the same bits.
[[nodiscard]] double snapLength(double metres);

/// The shortest decimal, in that unit, which comes back (times the unit, snapped) as exactly `metres`, a snapped and
/// finite length.
[[nodiscard]] std::string formatLength(double metres, const LengthUnit& unit);

}  // namespace tubeplan::tubesheets
