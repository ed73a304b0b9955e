// Reads work lists: readWorkListTable() and parseWorkListCsv().
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <utility>

#include "tubesheets/tube_table.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::tubesheets {
namespace {

std::string describeLeg(const std::optional<Leg>& leg) { return leg ? std::string(legName(*leg)) : "no leg"; }
std::string describeSheet(const std::string& sheet) { return sheet.empty() ? "no sheet" : sheet; }

// Returns a problem if a row is for a different leg, sheet or steam generator than the first row, for example because
// it was pasted by mistake.
std::optional<Problem> findInconsistentLine(const WorkListItem& first, const WorkListItem& item) {
  if (item.leg != first.leg)
    return Problem{"leg", describeLeg(item.leg), describeLeg(first.leg) + ", as on the lines above",
                   "keep one list for each leg", item.line};
  if (item.sheet != first.sheet)
    return Problem{"sheet", describeSheet(item.sheet), describeSheet(first.sheet) + ", as on the lines above",
                   "keep one list for each sheet", item.line};
  if (item.steam_generator != first.steam_generator)
    return Problem{"sg", "\"" + item.steam_generator + "\"", "\"" + first.steam_generator + "\", as on the lines above",
                   "keep one list for each steam generator", item.line};
  return std::nullopt;
}

/// Finds a contradiction between two rows that name the same tube.
std::optional<Problem> findContradiction(const WorkListItem& first, const WorkListItem& item) {
  const std::string tube = tubeName(item.row, item.column);
  const auto problem = [&](const std::string& found, const std::string& before) {
    return Problem{tube, found, fmt::format("{}, as on line {}", before, first.line), "correct one of them", item.line};
  };
  if (first.state && item.state && *first.state != *item.state)
    return problem(std::string(tubeStateName(*item.state)), std::string(tubeStateName(*first.state)));
  if (first.dwell && item.dwell && *first.dwell != *item.dwell)
    return problem(fmt::format("a stay of {} s", *item.dwell), fmt::format("{} s", *first.dwell));
  if (first.is_done != item.is_done)
    return problem(item.is_done ? "done" : "not done", first.is_done ? "done" : "not done");
  return std::nullopt;
}

/// Returns a sentence such as "named in several rows, visited once: R12C34 (lines 2 and 3)"; empty if there are none.
std::string repeatedText(const std::map<std::pair<int, int>, std::vector<int>>& lines) {
  constexpr std::size_t kShown = 5;
  std::vector<std::string> named;
  std::size_t count = 0;
  for (const auto& [tube, at] : lines) {
    if (at.size() < 2) continue;
    if (++count <= kShown)
      named.push_back(fmt::format("{} (lines {})", tubeName(tube.first, tube.second), fmt::join(at, " and ")));
  }
  if (count > kShown) named.push_back(fmt::format("{} more", count - kShown));
  return named.empty() ? "" : fmt::format("named in several rows, visited once: {}", fmt::join(named, ", "));
}

class ListReader {
 public:
  ListReader(std::string_view text, TubeTable table) {
    list_.text = text;
    list_.table = std::move(table);
  }

  WorkList read() {
    list_.readRows("tubes", [this](const CsvRow& row) { readRow(row); });
    if (list_.problem) list_.items.clear();
    list_.addNotes({unknownCodesText(unknown_), repeatedText(lines_), unitlessText()});
    return std::move(list_);
  }

 private:
  void readRow(const CsvRow& row) {
    const TubeTable& table = list_.table;
    const NamedTube named = tubeOf(table, row);
    list_.refuse(named.problem);
    WorkListItem item;
    item.row = named.tube.row;
    item.column = named.tube.column;
    item.line = row.line;
    item.sheet = table.field(row, TubeColumn::kSheet);
    item.steam_generator = table.field(row, TubeColumn::kSteamGenerator);
    readLeg(row, item);
    readPlace(row, item);
    readDwell(row, item);
    readCodes(row, item);
    if (list_.problem) return;
    const auto [first, is_new] = first_.try_emplace({item.row, item.column}, list_.items.size());
    if (!is_new) list_.refuse(findContradiction(list_.items[first->second], item));
    list_.items.push_back(std::move(item));
    lines_[first->first].push_back(row.line);
    list_.refuse(findInconsistentLine(list_.items.front(), list_.items.back()));
  }

  void readLeg(const CsvRow& row, WorkListItem& item) {
    const std::string leg = list_.table.field(row, TubeColumn::kLeg);
    item.leg = findLeg(leg);
    if (!leg.empty() && !item.leg)
      list_.refuse(Problem{"leg", "\"" + leg + "\"", "one of " + legNames(), "", row.line});
  }

  void readPlace(const CsvRow& row, WorkListItem& item) {
    const ReadLength x = lengthOf(list_.table, row, TubeColumn::kX), y = lengthOf(list_.table, row, TubeColumn::kY);
    list_.refuse(x.problem);
    list_.refuse(y.problem);
    item.x = x.metres;
    item.y = y.metres;
  }

  void readDwell(const CsvRow& row, WorkListItem& item) {
    const std::string dwell = list_.table.field(row, TubeColumn::kDwell);
    if (dwell.empty()) return;
    item.dwell = parseNumber(dwell);
    if (!item.dwell || *item.dwell < 0 || *item.dwell > kLongestDwell)
      list_.refuse(Problem{"dwell_s", "\"" + dwell + "\"", "seconds from 0 to a day", "", row.line});
  }

  void readCodes(const CsvRow& row, WorkListItem& item) {
    const ReadCodes codes = codesOf(list_.table, row);
    list_.refuse(codes.problem);
    item.state = codes.state;
    item.is_done = codes.is_done;
    for (const std::string& code : codes.unknown) ++unknown_[code];
  }

  [[nodiscard]] std::string unitlessText() const {
    const TubeTable& table = list_.table;
    const bool is_unitless =
        (table.has(TubeColumn::kX) && !table.unit_x) || (table.has(TubeColumn::kY) && !table.unit_y);
    return is_unitless ? "x or y without a unit (x_in, x_mm, x_m): not compared with the sheet" : "";
  }

  WorkList list_;
  std::map<std::pair<int, int>, std::size_t> first_;       // index of the item that first names each tube
  std::map<std::pair<int, int>, std::vector<int>> lines_;  // lines that name each tube
  std::map<std::string, int> unknown_;                     // unknown codes with their counts
};

}  // namespace

WorkList readWorkListTable(std::string_view text, TubeTable table) { return ListReader(text, std::move(table)).read(); }

WorkList parseWorkListCsv(std::string_view text) { return readWorkListTable(text, parseTubeTable(text)); }

}  // namespace tubeplan::tubesheets
