// Text made from a JSON document by a table of lines whose placeholders are replaced by values of the document. The
// document provides values and units; the lines define wording, digits and order.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// Row of a table of text lines. Prints one line for each entry of the list at the path `of`, such as "bases", or one
/// line for the value or object at a path such as "rms/after". No line is printed for a value that is missing, null,
/// false, empty or a zero count. "+rms" and "-rms" print only positive and only negative numbers. "!rms" and "!+rms"
/// print a line if "rms" and "+rms" would print none; "" always prints one line.
///
/// `{PATH:FORMAT UNIT}` in `words` is replaced by the value at PATH, searched in the entry, then in its enclosing
/// objects, then in the document. UNIT is the path of the name of the unit. `{}` is the entry itself, `{#PATH}` the
/// length of a list, and `{@}` the line's `name`. FORMAT is fmt's [<>][+][WIDTH][.DIGITS][TYPE] with additional types:
/// r, significant digits, without an exponent for numbers from 1 to 1e7; a, like r for the absolute value; l, with the
/// decimals of a length; %, a fraction as a percentage; p, a p-value; i, an interval with this number of digits; n, a
/// user-defined name. `(ONE|SEVERAL)` is replaced by ONE after a placeholder of the number 1, otherwise by SEVERAL:
/// "{#legs} leg(|s)". A list is written with commas, and an object as "4 open, 2 plugged". If FORMAT begins with *, the
/// values of both are written in columns of WIDTH, separated by at least one space. Null and a number that
/// is not finite are written as "none".
struct TextLine {
  std::string_view of, words;
  std::span<const TextLine> inner = {};  ///< further lines about the same entry
  std::string_view name = {};
  std::size_t most = 1000000;  ///< maximum number of entries shown
};

/// Returns the lines with their placeholders replaced by values of the document. Throws std::logic_error if a
/// placeholder names a value that is not in the document.
[[nodiscard]] std::string textOf(const nlohmann::json& document, std::span<const TextLine> lines);

/// Returns `words` with its placeholders replaced by values of the document.
[[nodiscard]] std::string textOf(const nlohmann::json& document, std::string_view words);

}  // namespace tubeplan::app
