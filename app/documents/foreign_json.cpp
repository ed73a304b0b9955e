#include "app/documents/foreign_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace tubeplan::app {

namespace {

constexpr std::size_t kRowsShown = 4;

nlohmann::json tableJson(const ForeignTable& table, const std::vector<ColumnTarget>& targets) {
  nlohmann::json rows = nlohmann::json::array();
  for (std::size_t k = 0; k < std::min(kRowsShown, table.rows.size()); ++k) rows.push_back(table.rows[k].fields);
  const auto names = findNames(table, targets);
  return {{"name", table.file},
          {"columns", table.columns},
          {"rows", rows},
          {"count", table.rows.size()},
          {"names", names ? nlohmann::json(*names) : nlohmann::json()}};
}

nlohmann::json targetJson(const ColumnTarget& target, const std::optional<ColumnGuess>& guess) {
  nlohmann::json found;
  if (guess)
    found = {{"table", guess->table},
             {"column", guess->column},
             {"unit", guess->unit ? std::string(guess->unit->name) : std::string()}};
  return {{"quantity", target.quantity},
          {"units", target.unit ? unitNames(*target.unit) : std::vector<std::string>()},
          {"is_required", target.is_joint},
          {"found", found}};
}

}  // namespace

nlohmann::json foreignColumnsJson(const std::vector<ForeignTable>& tables, const Cell& cell) {
  const auto targets = columnTargets(cell.arm);
  const auto guesses = guessColumns(tables, targets);
  nlohmann::json table_list = nlohmann::json::array(), target_list = nlohmann::json::array();
  for (const auto& table : tables) table_list.push_back(tableJson(table, targets));
  for (std::size_t k = 0; k < targets.size(); ++k) target_list.push_back(targetJson(targets[k], guesses[k]));
  return {{"tables", table_list}, {"targets", target_list}};
}

}  // namespace tubeplan::app
