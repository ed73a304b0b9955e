#include "tubesheets/table_text.hpp"

#include <algorithm>
#include <cassert>

namespace tubeplan::tubesheets {
namespace {

/// The content of a line, and the line ending after it.
struct RawLine {
  std::string_view content, end;
};

RawLine takeLine(std::string_view& text) {
  const std::size_t feed = std::min(text.find('\n'), text.size());
  std::size_t length = feed;
  if (feed < text.size() && length > 0 && text[length - 1] == '\r') --length;
  const RawLine line{text.substr(0, length), text.substr(length, std::min(feed + 1, text.size()) - length)};
  text.remove_prefix(std::min(feed + 1, text.size()));
  return line;
}

bool containsValue(std::string_view span, const std::string& value) {
  const auto field = splitCsvLine(span, '\0');
  return field && field->size() == 1 && field->front() == value;
}

class LineEditor {
 public:
  LineEditor(const TextTable& table, const std::vector<ColumnText>& columns) : table_(table), columns_(columns) {}

  [[nodiscard]] std::string edited(std::string_view content, int line) const {
    // Remove trailing tabs, which would become empty fields once columns are appended.
    if (table_.separator == '\t' && csvSpans(content, '\t')->size() != table_.columns.size())
      content = trimBlanks(content);
    std::string text =
        line == table_.heading_line || line == table_.units_line ? std::string(content) : withChanges(content, line);
    for (const ColumnText& column : columns_) {
      if (column.place) continue;
      text += table_.separator;
      if (line == table_.heading_line)
        text += csvField(column.name, table_.separator);
      else if (const auto field = column.fields.find(line); field != column.fields.end())
        text += csvField(field->second, table_.separator);
    }
    return text;
  }

 private:
  [[nodiscard]] std::string withChanges(std::string_view content, int line) const {
    const auto spans = csvSpans(content, table_.separator);
    assert(spans);
    std::string text;
    for (std::size_t c = 0; c < spans->size(); ++c) {
      if (c > 0) text += table_.separator;
      text += fieldAt(c, (*spans)[c], line);
    }
    return text;
  }

  [[nodiscard]] std::string fieldAt(std::size_t c, std::string_view span, int line) const {
    const auto column = std::ranges::find(columns_, std::optional(c), &ColumnText::place);
    if (column == columns_.end()) return std::string(span);
    const auto field = column->fields.find(line);
    if (field == column->fields.end() || containsValue(span, field->second)) return std::string(span);
    return csvField(field->second, table_.separator);
  }

  const TextTable& table_;
  const std::vector<ColumnText>& columns_;
};

}  // namespace

std::string withColumns(std::string_view text, const TextTable& table, const std::vector<ColumnText>& columns) {
  const LineEditor editor(table, columns);
  std::string out;
  auto row = table.rows.begin();
  for (int line = 1; !text.empty(); ++line) {
    const RawLine raw = takeLine(text);
    const bool is_row = row != table.rows.end() && row->line == line;
    const bool is_of_table = is_row || line == table.heading_line || line == table.units_line;
    out += is_of_table ? editor.edited(raw.content, line) : std::string(raw.content);
    out += raw.end;
    if (is_row) ++row;
  }
  return out;
}

}  // namespace tubeplan::tubesheets
