// Work lists: which tubes to visit, from a line of text or from a table.
//
// The line is a comma-separated list of items, blanks around them allowed. The sheet must have no problems (sheet.hpp).
//   - all, R10C20, R1-10C5-9, R10, C20, outer:2, zone:-10:10:20:40in, plugged (a tube state): the union of these.
//   - The same with a minus (-plugged, -R3C4, -outer:1): taken away, from all tubes when nothing is asked for.
//   - every:K, spread:N: a part of what the rest of the list selects, in the order written.
//   - leg:hot, sheet:FINGERPRINT: the list is for that leg or sheet only.
// Plugged and stabilised tubes take no tool, inaccessible ones could not be reached before, and of unresolved ones it
// is not known which tubes they are: they are left out, and counted, unless asked for by their state (`plugged`, as in
// `all,plugged`) or by their own name (R10C20).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/problem.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/tube_table.hpp"

namespace tubeplan::tubesheets {

inline constexpr double kLongestStay = 86'400;  ///< s, at a tube: a day

/// One line of a list.
struct WorkListItem {
  int row = 0;
  int column = 0;
  int line = 0;
  std::optional<Leg> leg;
  std::string sheet;               ///< fingerprint; empty = any
  std::optional<double> dwell;     ///< s to stay
  std::optional<TubeState> state;  ///< of the tube, as the list has it
  bool is_done = false;            ///< the list says that its work is done
  std::optional<double> x, y;      ///< m, where the list has the hole
  std::string steam_generator;
};

struct WorkList : TubeText {
  std::vector<WorkListItem> items;  ///< of every row, a tube's as often as it is named
};

/// Why a tube that was asked for is not selected.
struct LeftOut {
  int tube = 0;           ///< its place in sheet.tubes
  std::string_view word;  ///< "plugged", "done"
  bool is_by_list = false;
};

enum class SelectionStatus { kNotRun, kSelected, kRefused };

struct Selection {
  SelectionStatus status = SelectionStatus::kNotRun;
  std::string reason;             ///< when refused: names the item, the tube or the line
  std::vector<int> tube_indices;  ///< places in sheet.tubes, ascending, each once
  std::map<int, double> dwell;    ///< s to stay at a tube, where a list says so
  std::vector<LeftOut> left_out;  ///< tubes that would have been selected, but for their state or their work
  /// Selected, for they were named, though inaccessible or unresolved: by the sheet's word or a list's.
  std::map<int, TubeState> doubtful;
  std::optional<WorkList> list;  ///< where the tubes are those of a list
};

/// "12 plugged, 3 stabilised, 2 done according to the list"; empty where none is left out.
[[nodiscard]] std::string leftOutText(const Selection& selection);

/// "2 inaccessible, 1 unresolved among the tubes asked for (R3C4, ...): taken as asked"; empty where none is.
[[nodiscard]] std::string doubtfulText(const Sheet& sheet, const Selection& selection);

/// Tubes by the language above. Refused: malformed items, tubes that are not on the sheet, another leg or sheet, an
/// empty result.
[[nodiscard]] Selection selectTubes(const Sheet& sheet, const std::string& request);

/// Plugged, stabilised, inaccessible or unresolved: visited where the tube or its state is named.
[[nodiscard]] bool isLeftOutUnlessNamed(TubeState state);

/// "spread:N" for at most so many of the tubes that take a tool.
[[nodiscard]] std::string spreadRequest(const Sheet& sheet, std::size_t most);

/// A table (text_table.hpp) with columns for row and column, or for the tube's name, under any of their usual names
/// (tube_table.cpp), and, where wanted, leg (hot, cold, full, HL, CL), sheet (a fingerprint), dwell_s (seconds to stay,
/// from 0 to a day; empty: not said), state or status (a state or a code of tube_codes.hpp; empty: as the sheet has
/// it), code or ind (likewise, or any remark), x, y with a unit (where the hole is) and sg (the steam generator). Other
/// columns are noted. A tube may be named several times, as with two indications. Refused: two legs, sheets or steam
/// generators in one list, a tube that is said to be in two states or to be stayed at for two times, anything
/// malformed, no tubes.
[[nodiscard]] WorkList parseWorkListCsv(std::string_view text);

/// Reads a work list of a table whose columns were chosen, by the rules of parseWorkListCsv().
[[nodiscard]] WorkList readWorkListTable(std::string_view text, TubeTable table);

/// The tubes of such a list, each once, but for those whose work is done and those that are plugged or stabilised by
/// the list's word or, where it says nothing, by the sheet's; inaccessible and unresolved ones are named by the list
/// and so taken. Refused: a refused list, another leg or sheet, tubes that are not on the sheet (all are counted) or
/// not where the list has them, none left.
[[nodiscard]] Selection selectTubes(const Sheet& sheet, WorkList list);

}  // namespace tubeplan::tubesheets
