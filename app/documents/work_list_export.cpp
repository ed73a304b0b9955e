#include "app/documents/work_list_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/formats/units.hpp"
#include "tubesheets/csv_table.hpp"
#include "tubesheets/length_unit.hpp"
#include "tubesheets/table_text.hpp"

namespace tubeplan::app {

namespace {

using tubesheets::ColumnText;
using tubesheets::TubeColumn;

/// Outcome for a requested tube: the position of its visit, or the reason why it is not visited.
struct TubeOutcome {
  int tube = 0;
  std::string visit;    ///< position in the visiting order, from 1; empty for a tube without a visit
  std::string outcome;  ///< reason why the tube is not visited; empty for a visited tube
  std::string dwell;    ///< dwell time [s]; empty for excluded tubes
};

/// Returns the visited tubes in visiting order, then the tubes out of reach, then the tubes excluded because of their
/// state.
std::vector<TubeOutcome> outcomesOf(const PlanOutcome& outcome) {
  std::vector<TubeOutcome> all;
  const auto dwellAt = [&](int tube) {
    const auto own = outcome.conditions.dwell_at.find(tube);
    return formatNumber(own == outcome.conditions.dwell_at.end() ? outcome.conditions.dwell : own->second);
  };
  for (const auto& visit : outcome.plan.visits)
    all.push_back({visit.tube, std::to_string(all.size() + 1), "", formatNumber(visit.dwell)});
  for (const auto& missed : outcome.plan.unreachable)
    all.push_back({missed.tube, "", "unreachable: " + missed.reason, dwellAt(missed.tube)});
  for (const auto& left_out : outcome.selection.left_out)
    all.push_back({left_out.tube, "", fmt::format("left out: {}", left_out.word), ""});
  return all;
}

bool hasDwellTimes(const PlanOutcome& outcome) {
  return std::ranges::any_of(outcome.plan.visits, [](const auto& visit) { return visit.dwell > 0; });
}

std::string ownList(const PlanOutcome& outcome) {
  const auto& sheet = outcome.model.sheet;
  const auto* known = tubesheets::findLengthUnit(outcome.cell.units.length().name);
  const tubesheets::LengthUnit& unit = known ? *known : tubesheets::kInch;
  const std::string fingerprint = sheet.fingerprint();
  const bool has_dwell_times = hasDwellTimes(outcome);
  std::string text = fmt::format("leg,sheet,row,column,x_{0},y_{0},visit{1},outcome\n", unit.suffix,
                                 has_dwell_times ? ",dwell_s" : "");
  for (const TubeOutcome& of_tube : outcomesOf(outcome)) {
    if (of_tube.dwell.empty()) continue;  // skips tubes that are excluded because of their state
    const auto& tube = sheet.tubes[static_cast<std::size_t>(of_tube.tube)];
    text += fmt::format("{},{},{},{},{},{},{}{},{}\n", tubesheets::legName(sheet.leg), fingerprint, tube.row,
                        tube.column, tubesheets::formatLength(tube.x, unit), tubesheets::formatLength(tube.y, unit),
                        of_tube.visit, has_dwell_times ? "," + of_tube.dwell : "",
                        of_tube.outcome.empty() ? "" : tubesheets::csvQuoted(of_tube.outcome));
  }
  return text;
}

/// The given work list, with added columns that state the outcome for each tube.
class GivenList {
 public:
  explicit GivenList(const PlanOutcome& outcome) : outcome_(outcome), list_(*outcome.selection.list) {
    for (TubeOutcome& of_tube : outcomesOf(outcome)) by_tube_.emplace(of_tube.tube, std::move(of_tube));
  }

  std::string text() {
    const auto& sheet = outcome_.model.sheet;
    addMissing(TubeColumn::kLeg, "leg",
               [&](const TubeOutcome&) { return std::string(tubesheets::legName(sheet.leg)); });
    addMissing(TubeColumn::kSheet, "sheet", [print = sheet.fingerprint()](const TubeOutcome&) { return print; });
    add(TubeColumn::kVisit, "visit", [](const TubeOutcome& of_tube) { return of_tube.visit; });
    if (hasDwellTimes(outcome_)) addDwellTimes();
    add(TubeColumn::kOutcome, "outcome", [](const TubeOutcome& of_tube) { return of_tube.outcome; });
    return tubesheets::withColumns(list_.text, list_.table.text, columns_);
  }

 private:
  /// Adds the dwell times that the list does not state, in a new column or in the empty fields of its own column.
  void addDwellTimes() {
    add(TubeColumn::kDwell, "dwell_s", [](const TubeOutcome& of_tube) { return of_tube.dwell; });
    for (const auto& item : list_.items)
      if (item.dwell) columns_.back().fields.erase(item.line);
  }

  void addMissing(TubeColumn column, const char* name, const auto& textOf) {
    if (!list_.table.has(column)) add(column, name, textOf);
  }

  void add(TubeColumn column, const char* name, const auto& textOf) {
    ColumnText added{name, std::nullopt, {}};
    if (const auto place = list_.table.places.find(column); place != list_.table.places.end())
      added.place = place->second;
    for (const auto& item : list_.items)
      if (const auto found = by_tube_.find(*outcome_.model.sheet.indexOf(item.row, item.column));
          found != by_tube_.end())
        added.fields.emplace(item.line, textOf(found->second));
    columns_.push_back(std::move(added));
  }

  const PlanOutcome& outcome_;
  const tubesheets::WorkList& list_;
  std::map<int, TubeOutcome> by_tube_;
  std::vector<ColumnText> columns_;
};

}  // namespace

std::string workListCsv(const PlanOutcome& outcome) {
  return outcome.selection.list ? GivenList(outcome).text() : ownList(outcome);
}

}  // namespace tubeplan::app
