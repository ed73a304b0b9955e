// Documents in words: tables of lines, each filled in with the figures of a JSON document. What a figure is, and in
// which unit, is stated once, where the document is made; here are words, digits and order.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// A line for each entry of the list at the path `of`, "bases" or "rms/after", or for the figure or object there. What
/// is missing, null, false, empty or a count of none has no line; "+rms" and "-rms" are positive and negative numbers
/// alone. "!rms" and "!+rms" have a line where those have none, "" has one always.
///
/// `{PATH:FORMAT UNIT}` in `words` is a figure of the entry, else of what holds it, else of the document; UNIT is the
/// path of its unit's name. `{}` is the entry itself, `{#PATH}` the length of a list, `{@}` the line's `name`. FORMAT
/// is fmt's [<>][+][WIDTH][.DIGITS][TYPE] with more types: r, significant digits, whole numbers without an exponent; a,
/// the same of the size without its sign; l, with the decimals of a length; %, a share; p, the probability of chance;
/// i, an interval, to as many digits; n, a name of the user's. A list is written with commas, or after * in columns of
/// that width, an object as "4 open, 2 plugged", and a number that does not exist as "none".
struct TextLine {
  std::string_view of, words;
  std::span<const TextLine> inner = {};  ///< behind it, about the same entry
  std::string_view name = {};
  std::size_t most = 1000000;  ///< entries that are shown
};

/// Throws std::logic_error for words that name a figure which no document has.
[[nodiscard]] std::string textOf(const nlohmann::json& document, std::span<const TextLine> lines);

/// One line of words about the document.
[[nodiscard]] std::string textOf(const nlohmann::json& document, std::string_view words);

}  // namespace tubeplan::app
