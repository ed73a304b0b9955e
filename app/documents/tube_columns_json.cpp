#include "app/documents/tube_columns_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/formats/foreign/foreign_columns.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/text_file.hpp"
#include "tubesheets/tube_table.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;
using tubesheets::TextTable, tubesheets::TubeQuantity;

constexpr std::size_t kListRowsShown = 4;

json listTableJson(const TextTable& table, const std::string& file) {
  json rows = json::array();
  for (std::size_t k = 0; k < std::min(kListRowsShown, table.rows.size()); ++k) rows.push_back(table.rows[k].fields);
  return {{"name", file},
          {"columns", table.columns},
          {"rows", rows},
          {"count", table.rows.size()},
          {"remarks", json::array()},
          {"names", nullptr}};
}

/// Returns the first column whose heading names the quantity, with its unit; null if there is none.
json foundColumnJson(const TextTable& table, const TubeQuantity& quantity) {
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const auto heading = tubesheets::readTubeHeading(table.columns[c]);
    if (heading.column != quantity.column) continue;
    const std::string unit =
        heading.unit.empty() ? tubesheets::statedUnit(table.lines_before, tubesheets::isTubeUnit) : heading.unit;
    const auto* length = tubesheets::findLengthWord(unit);
    std::string name;
    if (tubesheets::isPlaceColumn(quantity.column) && length)
      name = length->suffix;
    else if (!tubesheets::isPlaceColumn(quantity.column) && !quantity.units.empty())
      name = quantity.units.front();
    return {{"table", 0}, {"column", c}, {"unit", name}};
  }
  return nullptr;
}

bool statesJoints(const std::string& text, const std::string& file, const deflection::Arm& arm) {
  const auto targets = columnTargets(arm);
  try {
    const auto guesses = guessColumns({parseForeignTable(text, file)}, targets);
    for (std::size_t k = 0; k < targets.size(); ++k)
      if (targets[k].is_joint && guesses[k]) return true;
  } catch (const InputError&) {
    return false;  // not a table of measurements
  }
  return false;
}

}  // namespace

json tubeColumnsJson(const std::string& text, const std::string& file, const deflection::Arm& arm) {
  const TextTable table = tubesheets::parseTubeText(text);
  if (table.problem) refuseText(file, *table.problem);
  json targets = json::array();
  for (const TubeQuantity& quantity : tubesheets::tubeQuantities())
    targets.push_back({{"quantity", quantity.name},
                       {"units", quantity.units},
                       {"is_required", false},
                       {"found", foundColumnJson(table, quantity)}});
  const bool names_tubes = tubesheets::rankTubeHeading(table.columns) == tubesheets::HeadingRank::kWhole;
  return {{"tables", json::array({listTableJson(table, file)})},
          {"targets", targets},
          {"options", json::array()},
          {"needs", json::array({json::array({"tube"}), json::array({"row", "column"})})},
          {"states", statesJoints(text, file, arm) ? "joints"
                     : names_tubes                 ? "tubes"
                                                   : "neither"},
          {"is_understood", !tubesheets::parseTubeTable(text).problem.has_value()}};
}

}  // namespace tubeplan::app
