// Alternative notations of tube names: R012C034, 12-34, 12/34, Row 12 Col 34.
#pragma once

#include <optional>
#include <string_view>

#include "tubesheets/tube.hpp"

namespace tubeplan::tubesheets {

inline constexpr int kLargestTubeNumber = 100000;

/// Reads row and column from two numbers with their letters or words (R or row; C, col, column, L, line, T or tube), in
/// either order and in upper or lower case. Two numbers without letters, separated by a hyphen or a slash, are row and
/// column. Returns std::nullopt for any other text: 34.12 is ambiguous, and R12-34 is a range.
[[nodiscard]] std::optional<RowAndColumn> readTubeForm(std::string_view text);

/// Read the number of a row or of a column, with or without its letter or word, such as "12", "R12" or "Col 34";
/// std::nullopt for any other text.
[[nodiscard]] std::optional<int> readRowNumber(std::string_view text);
[[nodiscard]] std::optional<int> readColumnNumber(std::string_view text);

}  // namespace tubeplan::tubesheets
