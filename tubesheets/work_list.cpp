#include "tubesheets/work_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "tubesheets/csv_table.hpp"
#include "tubesheets/selection_terms.hpp"

namespace tubeplan::tubesheets {
namespace {

// One item of a request: its text without the minus sign, and its position.
struct Item {
  std::string_view text;
  int number = 0;             // number of the item, starting from 1
  std::size_t character = 0;  // position of the item's first character, starting from 1
  bool is_minus = false;
  const SelectionTerm* term = nullptr;  // term of the item; null for a range or a state
  std::string_view argument;

  [[nodiscard]] TermRole role() const { return term == nullptr ? TermRole::kSource : term->role; }
};

Selection refuseList(std::string reason) {
  return {SelectionStatus::kRefused, std::move(reason), {}, {}, {}, {}, std::nullopt};
}

Selection refuseList(const Item& item, const std::string& reason) {
  return refuseList(fmt::format("item {} \"{}{}\" (character {}): {}", item.number, item.is_minus ? "-" : "", item.text,
                                item.character, reason));
}

std::string knownForms() {
  std::vector<std::string_view> forms{"R10C20"};
  for (const SelectionTerm& term : selectionTerms()) forms.push_back(term.form);
  return fmt::format("{}, {}", fmt::join(forms, ", "), tubeStateNames());
}

Item makeItem(std::string_view field, int number, std::size_t start) {
  const std::string_view text = trimBlanks(field);
  Item item;
  item.text = text;
  item.number = number;
  item.character = start + (text.empty() ? 0 : static_cast<std::size_t>(text.data() - field.data())) + 1;
  item.is_minus = text.starts_with('-');
  if (item.is_minus) item.text.remove_prefix(1);
  const std::size_t colon = std::min(item.text.find(':'), item.text.size());
  const auto& terms = selectionTerms();
  const auto term = std::find_if(terms.begin(), terms.end(),
                                 [&](const SelectionTerm& t) { return t.name == item.text.substr(0, colon); });
  if (term != terms.end()) item.term = &*term;
  if (colon < item.text.size()) item.argument = item.text.substr(colon + 1);
  return item;
}

std::vector<Item> splitItems(std::string_view request) {
  std::vector<Item> items;
  for (std::size_t start = 0; start <= request.size();) {
    const std::size_t comma = std::min(request.find(',', start), request.size());
    items.push_back(makeItem(request.substr(start, comma - start), static_cast<int>(items.size()) + 1, start));
    start = comma + 1;
  }
  return items;
}

// Returns the fault in the text of an item, found without examining tubes; empty if there is none.
std::string findItemFault(const Item& item) {
  if (item.text.empty()) return "nothing here; expected one of " + knownForms();
  if (item.is_minus && item.role() != TermRole::kSource) return "only tubes can be excluded with a minus";
  if (item.term != nullptr && item.term->takes_argument == item.argument.empty())
    return fmt::format("expected {}", item.term->form);
  const bool is_range = item.text.find_first_of("Rr") == 0 || item.text.find_first_of("Cc") == 0;
  if (item.term == nullptr && !findTubeState(item.text) && !is_range)
    return "not recognised; expected one of " + knownForms();
  return "";
}

TermChoice choose(const Item& item, const Sheet& sheet, const std::vector<int>& candidates) {
  if (item.term != nullptr) return item.term->choose(sheet, candidates, item.argument);
  const std::optional<TubeState> state = findTubeState(item.text);
  if (!state) return chooseRange(sheet, candidates, item.text);
  TermChoice choice;
  for (const int tube : candidates)
    if (sheet.tubes[tube].state == *state) choice.tubes.push_back(tube);
  return choice;
}

std::vector<int> allTubes(const Sheet& sheet) {
  std::vector<int> all(sheet.tubes.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

// Returns true for states in which a tube may be unreachable or misidentified. Such tubes are selected only by name.
bool isDoubtful(TubeState state) { return state == TubeState::kInaccessible || state == TubeState::kUnresolved; }

// Returns a flag for each tube: true if it is requested by its state or by its own name, not as part of a range.
std::vector<bool> namedTubes(const Sheet& sheet, const std::vector<Item>& items) {
  const std::vector<int> all = allTubes(sheet);
  std::vector<bool> is_named(all.size(), false);
  for (const Item& item : items) {
    if (item.role() != TermRole::kSource || item.is_minus || item.term != nullptr) continue;
    const TermChoice choice = choose(item, sheet, all);
    const bool is_one = choice.tubes.size() == 1 && item.text.find('-') == std::string_view::npos &&
                        item.text.find_first_of("Cc") != std::string_view::npos &&
                        item.text.find_first_of("Rr") != std::string_view::npos;
    if (!findTubeState(item.text) && !is_one) continue;
    for (const int tube : choice.tubes) is_named[tube] = true;
  }
  return is_named;
}

// Applies the items that add tubes, then the items that remove tubes. Stops at the first item that is refused.
Selection applySources(const Sheet& sheet, const std::vector<Item>& items) {
  const std::vector<int> all = allTubes(sheet);
  const bool has_addition = std::any_of(
      items.begin(), items.end(), [](const Item& item) { return item.role() == TermRole::kSource && !item.is_minus; });
  std::vector<bool> is_selected(all.size(), !has_addition);
  for (const bool minus : {false, true}) {
    for (const Item& item : items) {
      if (item.role() != TermRole::kSource || item.is_minus != minus) continue;
      const TermChoice choice = choose(item, sheet, all);
      if (!choice.reason.empty()) return refuseList(item, choice.reason);
      for (const int tube : choice.tubes) is_selected[tube] = !minus;
    }
  }
  const std::vector<bool> is_named = namedTubes(sheet, items);
  Selection selection{SelectionStatus::kSelected, "", {}, {}, {}, {}, std::nullopt};
  for (const int tube : all) {
    if (!is_selected[tube]) continue;
    const TubeState state = sheet.tubes[tube].state;
    const bool is_left_out = isExcludedUnlessNamed(state) && !is_named[tube];
    if (is_left_out)
      selection.left_out.push_back({tube, tubeStateName(state)});
    else
      selection.tube_indices.push_back(tube);
    if (!is_left_out && isDoubtful(state)) selection.doubtful[tube] = state;
  }
  return selection;
}

// Returns a phrase for messages about an empty selection that counts the tubes in `left_out`; empty if there are none.
std::string exceptText(const Selection& selection) {
  const std::string left_out = leftOutText(selection);
  return left_out.empty()
             ? ""
             : fmt::format(" except {}, which are selected only by state (such as \"plugged\") or by name", left_out);
}

/// Returns a message if the list is for another leg or sheet, or if a tube's position differs from that on the sheet;
/// empty otherwise. Lengths are stated in `unit`.
std::string findListFault(const WorkListItem& item, const Sheet& sheet, const std::string& fingerprint,
                          const LengthUnit& unit) {
  if (item.leg && *item.leg != sheet.leg)
    return fmt::format("this list is for the {} leg, but the sheet is {}", legName(*item.leg), legName(sheet.leg));
  if (!item.sheet.empty() && item.sheet != fingerprint)
    return fmt::format("this list is for the sheet {}, but this sheet is {}", item.sheet, fingerprint);
  const Tube* tube = sheet.find(item.row, item.column);
  if (!tube) return "";
  const double off = std::hypot(item.x.value_or(tube->x) - tube->x, item.y.value_or(tube->y) - tube->y);
  if (off <= sheet.hole_diameter / 2) return "";
  return fmt::format(
      "the coordinates are not those of {}, which is {:.4g} {} away: correct the name or the coordinates, or remove "
      "the "
      "columns of the coordinates",
      tubeName(item.row, item.column), off / unit.metres, unit.suffix);
}

/// Returns a sentence that counts the tubes of a list that are not on the sheet, and names a few; empty if none.
std::string explainMissingTubes(const WorkList& list, const Sheet& sheet) {
  constexpr std::size_t kShown = 5;
  std::set<std::pair<int, int>> seen;
  std::vector<const WorkListItem*> missing;
  for (const WorkListItem& item : list.items)
    if (!sheet.indexOf(item.row, item.column) && seen.emplace(item.row, item.column).second) missing.push_back(&item);
  if (missing.empty()) return "";
  const std::string first = explainMissing(sheet, missing.front()->row, missing.front()->column);
  if (missing.size() == 1) return fmt::format("line {}: {}", missing.front()->line, first);
  std::vector<std::string> named;
  for (std::size_t k = 0; k < std::min(missing.size(), kShown); ++k)
    named.push_back(fmt::format("{} (line {})", tubeName(missing[k]->row, missing[k]->column), missing[k]->line));
  if (missing.size() > kShown) named.emplace_back("...");
  return fmt::format("{} tubes of the list are not on this sheet: {}; {}", missing.size(), fmt::join(named, ", "),
                     first);
}

/// Combines the rows of each tube. The result is keyed by tube index.
std::map<int, WorkListItem> tubesOfList(const WorkList& list, const Sheet& sheet) {
  std::map<int, WorkListItem> tubes;
  for (const WorkListItem& item : list.items) {
    WorkListItem& tube = tubes.try_emplace(*sheet.indexOf(item.row, item.column), item).first->second;
    if (item.state) tube.state = item.state;
    if (item.dwell) tube.dwell = item.dwell;
    tube.is_done = tube.is_done && item.is_done;
  }
  return tubes;
}

/// Returns the reason for omitting a tube: done or plugged according to the list, or plugged according to the sheet;
/// std::nullopt if the tube is to be visited.
std::optional<LeftOut> leftOutOf(int index, const WorkListItem& item, const Sheet& sheet) {
  if (item.is_done) return LeftOut{index, "done", true};
  const TubeState state = item.state.value_or(sheet.tubes[static_cast<std::size_t>(index)].state);
  if (!takesNoTool(state)) return std::nullopt;
  return LeftOut{index, tubeStateName(state), item.state.has_value()};
}

}  // namespace

bool isExcludedUnlessNamed(TubeState state) { return takesNoTool(state) || isDoubtful(state); }

std::string leftOutText(const Selection& selection) {
  std::map<std::pair<bool, std::string_view>, int> counts;
  for (const LeftOut& tube : selection.left_out) ++counts[{tube.is_by_list, tube.word}];
  std::vector<std::string> parts;
  for (const auto& [kind, count] : counts)
    parts.push_back(fmt::format("{} {}{}", count, kind.second, kind.first ? " according to the list" : ""));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string doubtfulText(const Sheet& sheet, const Selection& selection) {
  constexpr std::size_t kShown = 5;
  std::map<TubeState, int> counts;
  std::vector<std::string> names, parts;
  for (const int index : selection.tube_indices) {
    const auto found = selection.doubtful.find(index);
    if (found == selection.doubtful.end()) continue;
    ++counts[found->second];
    const Tube& tube = sheet.tubes[static_cast<std::size_t>(index)];
    names.push_back(tubeName(tube.row, tube.column));
  }
  if (names.empty()) return "";
  for (const auto& [state, count] : counts) parts.push_back(fmt::format("{} {}", count, tubeStateName(state)));
  if (names.size() > kShown) {
    names.resize(kShown);
    names.emplace_back("...");
  }
  return fmt::format("{} among the requested tubes ({}): included as requested", fmt::join(parts, ", "),
                     fmt::join(names, ", "));
}

Selection selectTubes(const Sheet& sheet, const std::string& request) {
  const std::vector<Item> items = splitItems(request);
  for (const Item& item : items)
    if (const std::string fault = findItemFault(item); !fault.empty()) return refuseList(item, fault);
  for (const Item& item : items) {
    if (item.role() != TermRole::kGuard) continue;
    if (const TermChoice choice = choose(item, sheet, {}); !choice.reason.empty())
      return refuseList(item, choice.reason);
  }
  Selection selection = applySources(sheet, items);
  for (const Item& item : items) {
    if (selection.status == SelectionStatus::kRefused) return selection;
    if (item.role() != TermRole::kThinner) continue;
    TermChoice choice = choose(item, sheet, selection.tube_indices);
    if (!choice.reason.empty()) return refuseList(item, choice.reason);
    selection.tube_indices = std::move(choice.tubes);
  }
  if (selection.status == SelectionStatus::kSelected && selection.tube_indices.empty())
    return refuseList(fmt::format("\"{}\" selects no tube of this sheet{}", request, exceptText(selection)));
  return selection;
}

std::string spreadRequest(const Sheet& sheet, std::size_t most) {
  const std::size_t count = selectTubes(sheet, "all").tube_indices.size();
  return "spread:" + std::to_string(std::max<std::size_t>(1, std::min(most, count)));
}

Selection selectTubes(const Sheet& sheet, WorkList list) {
  if (list.status != TubeTextStatus::kRead)
    return refuseList(list.problem ? list.problem->sentence() : "the work list has not been read");
  const std::string fingerprint = sheet.fingerprint();
  const LengthUnit* stated = list.table.unit_x ? list.table.unit_x : list.table.unit_y;
  for (const WorkListItem& item : list.items)
    if (const std::string fault = findListFault(item, sheet, fingerprint, stated ? *stated : kMetre); !fault.empty())
      return refuseList(fmt::format("line {}: {}", item.line, fault));
  if (std::string missing = explainMissingTubes(list, sheet); !missing.empty()) return refuseList(std::move(missing));
  Selection selection{SelectionStatus::kSelected, "", {}, {}, {}, {}, std::nullopt};
  for (const auto& [tube, item] : tubesOfList(list, sheet)) {
    if (const auto left_out = leftOutOf(tube, item, sheet)) {
      selection.left_out.push_back(*left_out);
      continue;
    }
    selection.tube_indices.push_back(tube);
    const TubeState state = item.state.value_or(sheet.tubes[static_cast<std::size_t>(tube)].state);
    if (isDoubtful(state)) selection.doubtful[tube] = state;
    if (item.dwell) selection.dwell[tube] = *item.dwell;
  }
  if (selection.tube_indices.empty())
    return refuseList("the work list names no tube that is to be visited: " + leftOutText(selection));
  selection.list = std::move(list);
  return selection;
}

}  // namespace tubeplan::tubesheets
