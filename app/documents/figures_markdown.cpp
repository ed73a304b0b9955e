#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/documents/figure_list.hpp"

namespace tubeplan::app {

namespace {

constexpr int kDigits = 6;

/// Returns the text as a Markdown table cell; characters that would end the cell or start an HTML tag are escaped.
std::string markdownCell(const std::string& text) {
  std::string cell;
  for (const char c : text)
    cell += c == '|' ? "\\|" : c == '\n' ? "<br>" : c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return cell + " |";
}

std::string singleFigures(const std::vector<Figure>& figures) {
  std::string text = "| key | description | value | unit | note |\n|---|---|---|---|---|\n";
  for (const Figure& figure : figures)
    if (figure.list.empty())
      text += fmt::format("| {} {} {} {} {}\n", markdownCell(figure.key()), markdownCell(figure.description),
                          markdownCell(cellText(figure.value, kDigits)), markdownCell(figure.unit),
                          markdownCell(figure.note));
  return text;
}

/// Returns the entries of a list as a table. If all values of a column have the same unit, the column heading names
/// this unit.
std::string listTable(const std::vector<Figure>& figures, const std::string& list) {
  std::vector<std::string> columns, rows;
  std::map<std::string, std::set<std::string>> units;
  std::map<std::pair<std::string, std::string>, const Figure*> cells;
  for (const Figure& figure : figures) {
    if (figure.list != list) continue;
    if (rows.empty() || rows.back() != figure.row) rows.push_back(figure.row);
    if (std::ranges::find(columns, figure.column) == columns.end()) columns.push_back(figure.column);
    if (!figure.value.is_null()) units[figure.column].insert(figure.unit);
    cells[{figure.row, figure.column}] = &figure;
  }
  std::string text = fmt::format("\n## {}\n\n|", list), line = "|";
  for (const auto& column : columns) {
    const std::string unit = units[column].size() == 1 ? *units[column].begin() : "";
    text += " " + markdownCell(column + (unit.empty() ? "" : " [" + unit + "]"));
    line += "---|";
  }
  text += "\n" + line + "\n";
  for (const auto& row : rows) {
    text += "|";
    for (const auto& column : columns) {
      const auto found = cells.find({row, column});
      std::string cell = found == cells.end() ? "" : cellText(found->second->value, kDigits);
      if (units[column].size() > 1 && !cell.empty()) cell += " " + found->second->unit;
      text += " " + markdownCell(cell);
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::string figuresMarkdown(const nlohmann::json& document) {
  const auto figures = figuresOf(document);
  std::string text = singleFigures(figures);
  std::vector<std::string> lists{""};
  for (const Figure& figure : figures) {
    if (std::ranges::find(lists, figure.list) != lists.end()) continue;
    lists.push_back(figure.list);
    text += listTable(figures, figure.list);
  }
  return text;
}

}  // namespace tubeplan::app
