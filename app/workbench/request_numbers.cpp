#include "app/workbench/request_numbers.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/files/command_inputs.hpp"
#include "app/files/input_error.hpp"
#include "app/workbench/request_body.hpp"
#include "tubesheets/csv_table.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

Eigen::VectorXd jointsOf(const nlohmann::json& body, const Cell& cell) {
  std::vector<std::string> texts;
  for (const double value : numbersOf(body, "joints")) texts.push_back(fmt::format("{}", value));
  return parseJoints(fmt::format("{}", fmt::join(texts, ",")), cell.arm, cell.units, "request (joints)");
}

double loadOf(const nlohmann::json& body, const Cell& cell) {
  return parseLoad(numberOf(body, "load", 0), cell.units, "request (load)");
}

std::optional<int> holeOf(const nlohmann::json& body, const Cell& cell) {
  if (!body.contains("hole") || body["hole"].is_null()) return std::nullopt;
  return requiredHoleOf(body, cell);
}

int requiredHoleOf(const nlohmann::json& body, const Cell& cell) {
  const auto& sheet = requireSheet(cell, "name a hole");
  (void)requiredOf(body, "hole", "the index of a hole");
  return integerOf(body, "hole", 0, 0, static_cast<int>(sheet.tubes.size()) - 1);
}

std::vector<int> selectedTubes(const std::string& text, const tubesheets::Sheet& sheet) {
  const auto selection = tubesheets::selectTubes(sheet, text);
  if (selection.status != tubesheets::SelectionStatus::kSelected)
    throw InputError("tubes", inQuotes(text) + " (" + selection.reason + ")", "tubes of this sheet",
                     "all, R10C20, R1-10C5-9, outer:2, every:10, spread:60, -plugged");
  return selection.tube_indices;
}

std::string tubesText(const nlohmann::json& body, const tubesheets::Sheet& sheet, const std::string& otherwise) {
  if (!body.contains("tubes") || !body["tubes"].is_array()) {
    const std::string text = textOf(body, "tubes", otherwise);
    (void)selectedTubes(text, sheet);
    return text;
  }
  std::vector<std::string> names;
  const auto numbers = numbersOf(body, "tubes");
  for (const double number : numbers) {
    if (!(number >= 0 && number < static_cast<double>(sheet.tubes.size())) || number != std::floor(number))
      throw InputError("tubes", fmt::format("{}", number), "indices of holes");
    const auto& tube = sheet.tubes[static_cast<std::size_t>(number)];
    // Several are an area, whose plugged tubes are left out; a single one is meant.
    names.push_back(numbers.size() > 1 ? fmt::format("R{0}-{0}C{1}-{1}", tube.row, tube.column)
                                       : tubesheets::tubeName(tube.row, tube.column));
  }
  const std::string text = fmt::format("{}", fmt::join(names, ","));
  (void)selectedTubes(text, sheet);
  return text;
}

std::map<int, double> staysOf(const nlohmann::json& body, const tubesheets::Sheet& sheet) {
  std::map<int, double> stays;
  if (!body.contains("stays") || body["stays"].is_null()) return stays;
  if (!body["stays"].is_object()) throw InputError("stays", body["stays"].dump(), "{index of a hole: seconds}");
  for (const auto& [name, stay] : body["stays"].items()) {
    const auto tube = tubesheets::parseInteger(name);
    if (!tube || *tube < 0 || *tube >= static_cast<int>(sheet.tubes.size()))
      throw InputError("stays", inQuotes(name), "the index of a hole");
    if (!stay.is_number() || !(stay.get<double>() >= 0 && stay.get<double>() <= tubesheets::kLongestStay))
      throw InputError("stays", stay.dump(), "seconds from 0 to a day");
    stays.emplace(*tube, stay.get<double>());
  }
  return stays;
}

}  // namespace tubeplan::app
