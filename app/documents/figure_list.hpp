// List of all values ("figures") of a JSON document, each with a description and unit, and this list as CSV and as
// Markdown.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tubeplan::app {

/// Returns true for a scalar, and for a list of scalars or of such lists.
[[nodiscard]] bool isPlain(const nlohmann::json& value);

/// Returns true if a value is, or contains, a number that is not a count.
[[nodiscard]] bool hasReal(const nlohmann::json& value);

struct Figure {
  /// Path of the outermost list that contains the value, such as "parameters"; empty outside lists.
  std::string list;
  std::string row;          ///< index in `list`
  std::string column;       ///< path within the list's entry, such as "prior/sigma"; full path outside lists
  std::string description;  ///< description, such as "tool.tip.x: value"
  nlohmann::json value;     ///< scalar, or a list of scalars
  std::string unit;         ///< unit; empty for strings, counts and dimensionless numbers
  std::string note;

  /// Returns the path in the notation of jq and JSON pointers, such as "parameters/0/prior/sigma".
  [[nodiscard]] std::string key() const;
};

/// Returns the values of a document: conclusions first, then all other values in document order.
[[nodiscard]] std::vector<Figure> figuresOf(const nlohmann::json& document);

/// Returns a value as the text of a table cell, with `digits` significant digits; empty if the value is unknown.
[[nodiscard]] std::string cellText(const nlohmann::json& value, int digits);

/// Returns CSV with the columns key,description,value,unit,note and one row for each value.
[[nodiscard]] std::string figuresCsv(const nlohmann::json& document);

/// Returns one Markdown table of the values outside lists, followed by a table for each list.
[[nodiscard]] std::string figuresMarkdown(const nlohmann::json& document);

}  // namespace tubeplan::app
