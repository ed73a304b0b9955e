#include "app/documents/foreign_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/formats/foreign/clock_time.hpp"
#include "app/formats/foreign/foreign_heading.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

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
          {"remarks", table.remarks},
          {"names", names ? nlohmann::json(*names) : nlohmann::json()}};
}

nlohmann::json targetJson(const ColumnTarget& target, const std::optional<ColumnGuess>& guess) {
  nlohmann::json found;
  if (guess)
    found = {{"table", guess->table},
             {"column", guess->column},
             {"unit", guess->unit ? std::string(guess->unit->name) : std::string()}};
  return {{"quantity", target.quantity},
          {"units", target.unit ? foreignUnitNames(*target.unit) : std::vector<std::string>()},
          {"is_required", target.is_joint},
          {"found", found}};
}

nlohmann::json optionJson(const char* name, const char* label, nlohmann::json values) {
  return {{"name", name}, {"label", label}, {"values", std::move(values)}};
}

nlohmann::json formsJson(Stated stated) {
  nlohmann::json values = nlohmann::json::array();
  for (const auto& form : writtenForms())
    if (form.stated == stated)
      values.push_back({{"value", form.name}, {"words", fmt::format("{}: {}", form.name, form.words)}});
  return values;
}

nlohmann::json plainJson(const std::vector<std::string>& names) {
  nlohmann::json values = nlohmann::json::array();
  for (const auto& name : names) values.push_back({{"value", name}, {"words", name}});
  return values;
}

}  // namespace

nlohmann::json foreignColumnsJson(const ForeignRequest& request, const Cell& cell) {
  const auto& tables = request.tables;
  const auto targets = columnTargets(cell.arm);
  const auto guesses = guessColumns(tables, targets, request.choice, request.kind);
  nlohmann::json table_list = nlohmann::json::array(), target_list = nlohmann::json::array();
  for (const auto& table : tables) table_list.push_back(tableJson(table, targets));
  for (std::size_t k = 0; k < targets.size(); ++k) target_list.push_back(targetJson(targets[k], guesses[k]));
  return {{"tables", table_list},
          {"targets", target_list},
          {"options",
           {optionJson("kind", "kind of the readings", plainJson(calibration::measurementKindNames())),
            optionJson("orientation", "form of the orientation", formsJson(Stated::kTurn)),
            optionJson("points", "form of the places", formsJson(Stated::kPlace)),
            optionJson("dates", "order in dates",
                       plainJson({nameOf(DateOrder::kDayFirst), nameOf(DateOrder::kMonthFirst)}))}}};
}

}  // namespace tubeplan::app
