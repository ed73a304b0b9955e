// findNames() and guessColumns(): likely columns of quantities, before the user assigns columns.
#include <algorithm>
#include <set>
#include <utility>

#include "app/formats/foreign/angle_fields.hpp"
#include "app/formats/foreign/column_names.hpp"
#include "app/formats/foreign/foreign_columns.hpp"
#include "app/formats/foreign/form_columns.hpp"

namespace tubeplan::app {

namespace {

/// Returns likely columns for the numbers of written orientations and positions, each with the index of its target;
/// none if several forms are possible.
std::vector<std::pair<std::size_t, ColumnGuess>> guessForms(const std::vector<ForeignTable>& tables,
                                                            const std::vector<std::vector<ForeignHeading>>& headings,
                                                            const std::vector<ColumnTarget>& targets,
                                                            const ColumnChoice& choice, const std::string& kind) {
  FreeColumns free;
  for (const auto& table : tables) free.emplace_back(table.columns.size(), true);
  std::vector<const ColumnTarget*> joints;
  for (const auto& target : targets)
    if (target.is_joint) joints.push_back(&target);
  const FormSearch search{tables, headings, choice.units, free, joints};
  std::vector<std::pair<std::size_t, ColumnGuess>> guesses;
  for (const auto& [stated, name] : neededForms(kindsOf(search, kind), choice)) {
    const bool has_columns = std::ranges::any_of(columnsOf(stated).columns, [&](std::string_view column) {
      return hasFreeColumn(search, *std::ranges::find(targets, column, &ColumnTarget::quantity));
    });
    if (name.empty() && has_columns) continue;
    const auto found = decideForms(formsByHeadings(search, stated, name), tables);
    if (found.size() != 1) continue;
    for (std::size_t k = 0; k < targets.size(); ++k)
      if (targets[k].form == found.front().form)
        guesses.push_back({k, {found.front().table, found.front().columns[targets[k].part]}});
    for (const std::size_t c : found.front().columns) free[found.front().table][c] = false;
  }
  return guesses;
}

}  // namespace

std::optional<std::size_t> findNames(const ForeignTable& table, const std::vector<ColumnTarget>& targets) {
  const auto headings = columnNames(table, targets);
  for (const char* quantity : {"point", "id"})
    for (const auto& target : targets) {
      if (target.quantity != quantity) continue;
      const auto found = std::find_if(headings.begin(), headings.end(), [&](const auto& h) { return fits(target, h); });
      if (found != headings.end()) return static_cast<std::size_t>(found - headings.begin());
    }
  return std::nullopt;
}

std::vector<std::optional<ColumnGuess>> guessColumns(const std::vector<ForeignTable>& tables,
                                                     const std::vector<ColumnTarget>& targets,
                                                     const ColumnChoice& choice, const std::string& kind) {
  const auto headings = columnNames(tables, targets);
  std::vector<std::optional<ColumnGuess>> guesses(targets.size());
  std::set<std::pair<std::size_t, std::size_t>> used;
  for (const auto& [k, guess] : guessForms(tables, headings, targets, choice, kind)) {
    guesses[k] = guess;
    used.emplace(guess.table, guess.column);
  }
  for (std::size_t k = 0; k < targets.size(); ++k)
    for (std::size_t t = 0; t < tables.size(); ++t)
      for (std::size_t c = 0; c < headings[t].size() && !guesses[k]; ++c)
        if (fits(targets[k], headings[t][c]) && used.emplace(t, c).second) guesses[k] = {t, c};
  for (std::size_t k = 0; k < targets.size(); ++k)
    if (auto& guess = guesses[k]; guess && targets[k].unit) {
      guess->unit = unitOf(tables[guess->table], headings[guess->table][guess->column], *targets[k].unit, choice.units);
      if (targets[k].is_joint && guess->unit && guess->unit->name == "deg" &&
          mayBeHours(tables[guess->table], guess->column))
        guess->unit = nullptr;
    }
  return guesses;
}

}  // namespace tubeplan::app
