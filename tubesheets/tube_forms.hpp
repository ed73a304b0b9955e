// Other notations of tube names: R012C034, 12-34, 12/34, Row 12 Col 34.
#pragma once

#include <optional>
#include <string_view>

#include "tubesheets/tube.hpp"

namespace tubeplan::tubesheets {

inline constexpr int kLargestTubeNumber = 100000;

/// Reads row and column from two numbers with their letters or words (R and C; L, line, T or tube for the column), in
/// either order and any capitals. Two bare numbers with a hyphen or a slash between them are row and column. Nothing
/// for anything else: 34.12 is ambiguous, and R12-34 is a range.
[[nodiscard]] std::optional<RowAndColumn> readTubeForm(std::string_view text);

/// Read a row's or a column's own number, bare or with its letter or word: "12", "R12", "Col 34"; nothing for anything
/// else.
[[nodiscard]] std::optional<int> readRowNumber(std::string_view text);
[[nodiscard]] std::optional<int> readColumnNumber(std::string_view text);

}  // namespace tubeplan::tubesheets
