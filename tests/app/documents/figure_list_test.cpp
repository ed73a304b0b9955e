// CSV and Markdown list every value of a document, each number with its unit, and no text can end a table cell early.
#include "app/documents/figure_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

json documentWithAll() {
  json document = json::parse(R"({
    "units": {"length": "in", "angle": "deg", "force": "lbf", "conditions": [{"name": "humidity", "unit": "percent"}]},
    "error_unit": "mm", "verdict": "adequate", "bare": {}, "none": [], "count": 3, "known": true, "p_value": 0.25,
    "rms": {"heldout_after": 0.5, "before": null}, "base": {"position": [1.5, 2, 3], "rpy": [0.1, 0.2, 0.3]},
    "covariance": [[1.5, 2], [3, 4.5]], "moment": 2.5,
    "parameters": [{"name": "tip|x", "value": 1.25, "unit": "rad", "prior": {"sigma": 0.5, "unit": "1", "of": "value"}},
                   {"name": "a,\"b\"", "value": null, "note": "fixed\nhere", "parts": [{"id": "P1", "load": 2.5}]}],
    "mixed": [[{"effect": "backlash", "at": "theta1", "interval": [0.5, 1], "unit": "deg"}], "alone"],
    "readings": [{"id": "P1", "humidity": 50.5, "sigma": 0.01, "joints": [1.5]}, {"id": "P2", "humidity": 51.5}]})");
  document["unbounded"] = std::numeric_limits<double>::infinity();
  return document;
}

const Figure& figureAt(const std::vector<Figure>& figures, const std::string& key) {
  static const Figure kNone{};
  const auto found = std::ranges::find_if(figures, [&](const Figure& figure) { return figure.key() == key; });
  EXPECT_NE(found, figures.end()) << key;
  return found == figures.end() ? kNone : *found;
}

/// Adds the JSON pointers of all figures, without the leading slash; a list of plain values counts as one figure.
void addLeaves(const json& value, const std::string& path, std::vector<std::string>& leaves) {
  if (value.empty() || value.dump().find('{') == std::string::npos) return leaves.push_back(path.substr(1));
  for (const auto& [key, inner] : value.items()) addLeaves(inner, path + "/" + key, leaves);
}

TEST(FigureList, keepsEveryFigure) {
  const json document = documentWithAll();
  std::vector<std::string> leaves, keys;
  addLeaves(document, "", leaves);
  for (const auto& figure : figuresOf(document)) keys.push_back(figure.key());
  EXPECT_EQ(keys.front(), "verdict") << "what it comes to stands first";
  std::ranges::sort(leaves), std::ranges::sort(keys);
  EXPECT_EQ(keys, leaves);
}

TEST(FigureList, statesUnits) {
  const auto figures = figuresOf(documentWithAll());
  const struct {
    const char *key, *unit;
  } kCases[] = {{"base/position", "in"},
                {"base/rpy", "deg"},
                {"rms/heldout_after", "mm"},
                {"parameters/0/value", "rad"},
                {"parameters/0/prior/sigma", ""},
                {"mixed/0/0/interval", "deg"},
                {"readings/0/humidity", "percent"},
                {"readings/0/sigma", "mm"},
                {"readings/0/joints", "of the joint"},
                {"moment", "lbf*in"},
                {"count", ""},
                {"p_value", ""},
                {"verdict", ""},
                {"parameters/1/parts/0/load", "lbf"}};
  for (const auto& [key, unit] : kCases) EXPECT_EQ(figureAt(figures, key).unit, unit) << key;
}

TEST(FigureList, describesAndNotes) {
  const auto figures = figuresOf(documentWithAll());
  EXPECT_EQ(figureAt(figures, "rms/heldout_after").description, "root mean square, held-out after");
  EXPECT_EQ(figureAt(figures, "parameters/0/value").description, "parameters tip|x: value");
  EXPECT_EQ(figureAt(figures, "mixed/0/0/interval").description, "mixed 1: backlash at theta1: interval");
  EXPECT_EQ(figureAt(figures, "parameters/0/prior/sigma").note, "value");
  for (const char* key : {"unbounded", "rms/before", "parameters/1/value"}) {
    EXPECT_EQ(figureAt(figures, key).note, "not known") << key;
    EXPECT_EQ(cellText(figureAt(figures, key).value, 6), "") << key;
  }
  EXPECT_EQ(cellText(figureAt(figures, "covariance").value, 6), "1.5, 2; 3, 4.5");
  EXPECT_EQ(cellText("a\x1b[31m\nb", 6).find('\x1b'), std::string::npos);
}

TEST(FigureList, isCsv) {
  const json document = {{"a", 0.1}, {"b", "x, \"y\""}, {"c", nullptr}};
  EXPECT_EQ(figuresCsv(document),
            "key,description,value,unit,note\na,a,0.1,,\nb,b,\"x, \"\"y\"\"\",,\nc,c,,,not known\n");
  for (const auto& figure : figuresOf(documentWithAll()))
    EXPECT_NE(figuresCsv(documentWithAll()).find("\n" + tubesheets::csvField(figure.key()) + ","), std::string::npos);
}

TEST(FigureList, isMarkdown) {
  const std::string text = figuresMarkdown(documentWithAll());
  for (const char* part : {"| base/position | base, position | 1.5, 2, 3 | in |  |", "## parameters\n",
                           "| humidity [percent] |", "tip\\|x", "fixed<br>here"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  EXPECT_NE(figuresMarkdown(json::parse(R"({"a": "<script>"})")).find("&lt;script>"), std::string::npos);
  for (const auto& figure : figuresOf(documentWithAll()))
    EXPECT_NE(text.find((figure.list.empty() ? "\n| " : "| ") + figure.column), std::string::npos) << figure.key();
}

}  // namespace
}  // namespace tubeplan::app
