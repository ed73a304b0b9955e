// Work lists: which tubes to visit, from a line of text or from a table.
//
// The line is a comma-separated list of items, blanks around them allowed. The sheet must have no problems (sheet.hpp).
//   - all, R10C20, R1-10C5-9, R10, C20, outer:2, zone:-10:10:20:40in, plugged (a tube state): the union of these.
//   - The same with a minus (-plugged, -R3C4, -outer:1): removed, from all tubes if nothing else is asked for.
//   - every:K, spread:N: a part of what the rest of the list selects, in the order written.
//   - leg:hot, sheet:FINGERPRINT: the list is for that leg or sheet only.
// Plugged and stabilised tubes take no tool, inaccessible ones could not be reached before, and the identity of
// unresolved ones is in doubt. All of these are left out, and counted, unless they are asked for by their state
// (`plugged`, as in `all,plugged`) or by their own name (R10C20).
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

inline constexpr double kLongestStay = 86'400;  ///< longest stay at a tube [s]: a day

/// One line of a work list.
struct WorkListItem {
  int row = 0;
  int column = 0;
  int line = 0;
  std::optional<Leg> leg;
  std::string sheet;               ///< fingerprint; empty = any sheet
  std::optional<double> dwell;     ///< stay at the tube [s]
  std::optional<TubeState> state;  ///< state of the tube according to the list
  bool is_done = false;            ///< true if the list says that the work is done
  std::optional<double> x, y;      ///< position of the hole according to the list [m]
  std::string steam_generator;
};

struct WorkList : TubeText {
  std::vector<WorkListItem> items;  ///< items of all rows; a tube may occur more than once
};

/// A tube that was asked for and not selected, with the reason.
struct LeftOut {
  int tube = 0;           ///< index in Sheet::tubes
  std::string_view word;  ///< "plugged", "done"
  bool is_by_list = false;
};

enum class SelectionStatus { kNotRun, kSelected, kRefused };

struct Selection {
  SelectionStatus status = SelectionStatus::kNotRun;
  std::string reason;             ///< reason of a refusal, which names the item, the tube or the line
  std::vector<int> tube_indices;  ///< indices in Sheet::tubes, ascending, each once
  std::map<int, double> dwell;    ///< stay at a tube [s] by index, where a list states one
  std::vector<LeftOut> left_out;  ///< tubes left out because of their state or finished work
  /// Inaccessible or unresolved tubes that are selected because they were named, with their state by the list or else
  /// the sheet.
  std::map<int, TubeState> doubtful;
  std::optional<WorkList> list;  ///< the list that the tubes come from, if any
};

/// Returns "12 plugged, 3 stabilised, 2 done according to the list"; empty if no tube is left out.
[[nodiscard]] std::string leftOutText(const Selection& selection);

/// Returns "2 inaccessible, 1 unresolved among the tubes asked for (R3C4, ...): taken as asked"; empty if there are
/// none.
[[nodiscard]] std::string doubtfulText(const Sheet& sheet, const Selection& selection);

/// Selects tubes by the language above. Refused: malformed items, tubes that are not on the sheet, another leg or
/// sheet, an empty result.
[[nodiscard]] Selection selectTubes(const Sheet& sheet, const std::string& request);

/// Returns true for plugged, stabilised, inaccessible and unresolved, which are visited only if the tube or its state
/// is named.
[[nodiscard]] bool isLeftOutUnlessNamed(TubeState state);

/// Returns "spread:N", N being at most `most` and the number of tubes that take a tool.
[[nodiscard]] std::string spreadRequest(const Sheet& sheet, std::size_t most);

/// Reads a work list (text_table.hpp) with columns for row and column, or for the tube's name, under any of their usual
/// names (tube_table.cpp). Optional columns are leg (hot, cold, full, HL, CL), sheet (a fingerprint), dwell_s (seconds
/// to stay, from 0 to a day; empty: not stated), state or status (a state or a code of tube_codes.hpp; empty: the
/// sheet's), code or ind (likewise, or any remark), x, y with a unit (position of the hole) and sg (the steam
/// generator). Other columns are noted. A tube may be named several times, as with two indications. Refused: two legs,
/// sheets or steam generators in one list, two states or two stays for one tube, anything malformed, no tubes.
[[nodiscard]] WorkList parseWorkListCsv(std::string_view text);

/// Reads a work list of a table whose columns were chosen, by the rules of parseWorkListCsv().
[[nodiscard]] WorkList readWorkListTable(std::string_view text, TubeTable table);

/// Selects the tubes of a list, each once. Left out are those whose work is done and those plugged or stabilised by the
/// list or, where it says nothing, by the sheet. Inaccessible and unresolved tubes are taken, because the list names
/// them. Refused: a refused list, another leg or sheet, tubes that are not on the sheet (all are counted) or not where
/// the list has them, an empty result.
[[nodiscard]] Selection selectTubes(const Sheet& sheet, WorkList list);

}  // namespace tubeplan::tubesheets
