// Work lists: the tubes to visit, selected by a line of text (a request) or listed in a table.
//
// A request is a comma-separated list of items; blanks around items are allowed. The sheet must have no problems
// (sheet.hpp).
//   - all, R10C20, R1-10C5-9, R10, C20, outer:2, zone:-10:10:20:40in, plugged (a tube state): adds these tubes.
//   - The same items with a minus (-plugged, -R3C4): removes these tubes; from all tubes if no item adds any.
//   - every:K, spread:N: keeps part of the tubes that the other items select; applied in the order written.
//   - leg:hot, sheet:FINGERPRINT: refuses a sheet of another leg or with another fingerprint.
// Plugged and stabilised tubes cannot take a tool, inaccessible tubes could not be reached before, and the identity of
// unresolved tubes is in doubt. All these tubes are omitted, and counted, unless they are requested by their state
// (`plugged`, such as in `all,plugged`) or by their own name (R10C20).
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

inline constexpr double kLongestDwell = 86'400;  ///< longest dwell time at a tube [s]: one day

/// One row of a work list.
struct WorkListItem {
  int row = 0;
  int column = 0;
  int line = 0;
  std::optional<Leg> leg;
  std::string sheet;               ///< fingerprint of the sheet; empty means any sheet
  std::optional<double> dwell;     ///< dwell time at the tube [s]
  std::optional<TubeState> state;  ///< state of the tube according to the list
  bool is_done = false;            ///< true if the list says that the work is done
  std::optional<double> x, y;      ///< position of the hole according to the list [m]
  std::string steam_generator;
};

struct WorkList : TubeText {
  std::vector<WorkListItem> items;  ///< items of all rows; several items may name the same tube
};

/// A tube that was requested but not selected, with the reason.
struct LeftOut {
  int tube = 0;           ///< index of the tube in Sheet::tubes
  std::string_view word;  ///< reason for leaving the tube out, such as "plugged" or "done"
  bool is_by_list = false;
};

enum class SelectionStatus { kNotRun, kSelected, kRefused };

struct Selection {
  SelectionStatus status = SelectionStatus::kNotRun;
  std::string reason;             ///< reason for refusal, which names the item, the tube or the line; empty if selected
  std::vector<int> tube_indices;  ///< indices of the selected tubes in Sheet::tubes, ascending, each once
  /// Dwell times [s] keyed by index in Sheet::tubes, for tubes where a list states a dwell time.
  std::map<int, double> dwell;
  std::vector<LeftOut> left_out;  ///< requested tubes that are excluded because of their state or because their work is
                                  ///< done
  /// Inaccessible or unresolved tubes that were selected by name, keyed by index in Sheet::tubes. The state is taken
  /// from the list if it states one, otherwise from the sheet.
  std::map<int, TubeState> doubtful;
  std::optional<WorkList> list;  ///< work list that the tubes come from; std::nullopt for a request
};

/// Returns a phrase that counts the tubes in `left_out`, such as "12 plugged, 3 stabilised, 2 done according to the
/// list"; empty if there are none.
[[nodiscard]] std::string leftOutText(const Selection& selection);

/// Returns a sentence on the tubes in `doubtful`, such as "2 inaccessible, 1 unresolved among the requested tubes
/// (R3C4, ...): included as requested"; empty if there are none.
[[nodiscard]] std::string doubtfulText(const Sheet& sheet, const Selection& selection);

/// Selects tubes by a request in the language described above. Refuses malformed items, tubes that are not on the
/// sheet, another leg or sheet, and an empty result.
[[nodiscard]] Selection selectTubes(const Sheet& sheet, const std::string& request);

/// Returns true for plugged and stabilised tubes, which no tool can enter.
[[nodiscard]] constexpr bool takesNoTool(TubeState state) {
  return state == TubeState::kPlugged || state == TubeState::kStabilised;
}

/// Returns true for plugged, stabilised, inaccessible and unresolved: tubes in these states are visited only if the
/// tube or its state is named.
[[nodiscard]] bool isExcludedUnlessNamed(TubeState state);

/// Returns the request "spread:N", where N is `most` or the number of tubes that `all` selects, whichever is smaller,
/// but at least 1.
[[nodiscard]] std::string spreadRequest(const Sheet& sheet, std::size_t most);

/// Reads a work list (text_table.hpp) with columns for row and column, or for the tube's name, under any of their usual
/// names (tube_columns.cpp). Optional columns are leg (hot, cold, full, HL, CL), sheet (a fingerprint), dwell_s (dwell
/// time in seconds, from 0 to a day; empty means that it was not stated), state or status (a state or a code of
/// tube_codes.hpp; empty means that the state on the sheet), code or ind (a state, a code or any remark), x and y with
/// a unit (position of the hole) and sg (the steam generator). A note lists all other columns. A tube may be named
/// several times, for example once per indication. Refuses two legs, sheets or steam generators in one list, two states
/// or two dwell times for one tube, malformed fields, and a list without tubes.
[[nodiscard]] WorkList parseWorkListCsv(std::string_view text);

/// Reads a work list from a table whose columns the user chose, with the rules of parseWorkListCsv().
[[nodiscard]] WorkList readWorkListTable(std::string_view text, TubeTable table);

/// Selects the tubes of a list, each once. Omits tubes whose work is done, and tubes that are plugged or stabilised
/// according to the list or, where the list states nothing, according to the sheet. Inaccessible and unresolved tubes
/// are selected, because the list names them. Refuses a list that could not be read, another leg or sheet, tubes that
/// are not on the sheet (all are counted) or whose position in the list differs from the sheet's, and an empty result.
[[nodiscard]] Selection selectTubes(const Sheet& sheet, WorkList list);

}  // namespace tubeplan::tubesheets
