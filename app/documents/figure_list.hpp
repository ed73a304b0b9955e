// A document as one list of figures, each with words and its unit, and that list as CSV and as Markdown.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tubeplan::app {

struct Figure {
  std::string list;         ///< path of the outermost list that it is in, "parameters"; empty for none
  std::string row;          ///< place in that list
  std::string column;       ///< path behind that, "prior/sigma"; of a figure in no list all of it
  std::string description;  ///< "tool.tip.x: value"
  nlohmann::json value;     ///< plain, or a list of plain values
  std::string unit;         ///< empty of words, counts and pure numbers
  std::string note;

  /// "parameters/0/prior/sigma", as jq and JSON pointers lead there.
  [[nodiscard]] std::string key() const;
};

/// What a document comes to first, then all else in its order.
[[nodiscard]] std::vector<Figure> figuresOf(const nlohmann::json& document);

/// A value in one cell, numbers to so many digits; empty where it is not known.
[[nodiscard]] std::string cellText(const nlohmann::json& value, int digits);

/// key,description,value,unit,note: a row for each figure.
[[nodiscard]] std::string figuresCsv(const nlohmann::json& document);

/// A table of the figures that stand alone, then one for each list.
[[nodiscard]] std::string figuresMarkdown(const nlohmann::json& document);

}  // namespace tubeplan::app
