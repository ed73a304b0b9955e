// Documents in words: tables of lines, each filled in with the figures of a JSON document. The document states the
// meaning and unit of a figure once; the lines state words, digits and order.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// Table row that prints one line for each entry of the list at the path `of`, "bases" or "rms/after", or for the
/// figure or object there. A value that is missing, null, false, empty or a count of none prints no line; "+rms" and
/// "-rms" print positive and negative numbers alone. "!rms" and "!+rms" print a line if those print none, "" always
/// prints one.
///
/// `{PATH:FORMAT UNIT}` in `words` is a figure of the entry, else of its enclosing objects, else of the document; UNIT
/// is the path of its unit's name. `{}` is the entry itself, `{#PATH}` the length of a list, `{@}` the line's `name`.
/// FORMAT is fmt's [<>][+][WIDTH][.DIGITS][TYPE] with more types: r, significant digits, whole numbers without an
/// exponent; a, like r for the absolute value; l, with the decimals of a length; %, a share; p, the probability of
/// chance; i, an interval, to as many digits; n, a user's name. A list is written with commas, or after * in columns of
/// that width, an object as "4 open, 2 plugged", and a number that does not exist as "none".
struct TextLine {
  std::string_view of, words;
  std::span<const TextLine> inner = {};  ///< lines after it, about the same entry
  std::string_view name = {};
  std::size_t most = 1000000;  ///< maximum number of entries shown
};

/// Returns the lines in words. Throws std::logic_error for words that name a figure which no document has.
[[nodiscard]] std::string textOf(const nlohmann::json& document, std::span<const TextLine> lines);

/// Returns one line of words about the document.
[[nodiscard]] std::string textOf(const nlohmann::json& document, std::string_view words);

}  // namespace tubeplan::app
