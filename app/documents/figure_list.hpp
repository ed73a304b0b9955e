// Document as one list of figures, each with words and its unit, and that list as CSV and as Markdown.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tubeplan::app {

struct Figure {
  std::string list;         ///< path of the outermost list that holds the figure, "parameters"; empty for none
  std::string row;          ///< index in that list
  std::string column;       ///< path inside the list's entry, "prior/sigma"; the full path for a figure in no list
  std::string description;  ///< "tool.tip.x: value"
  nlohmann::json value;     ///< plain value, or a list of plain values
  std::string unit;         ///< empty for words, counts and pure numbers
  std::string note;

  /// Returns "parameters/0/prior/sigma", the path in the notation of jq and JSON pointers.
  [[nodiscard]] std::string key() const;
};

/// Returns the conclusions of a document first, then all other figures in its order.
[[nodiscard]] std::vector<Figure> figuresOf(const nlohmann::json& document);

/// Returns a value for one cell, numbers with this number of digits; empty if it is unknown.
[[nodiscard]] std::string cellText(const nlohmann::json& value, int digits);

/// Returns the columns key,description,value,unit,note with a row for each figure.
[[nodiscard]] std::string figuresCsv(const nlohmann::json& document);

/// Returns a table of the figures outside lists, then one table for each list.
[[nodiscard]] std::string figuresMarkdown(const nlohmann::json& document);

}  // namespace tubeplan::app
