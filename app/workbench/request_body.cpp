#include "app/workbench/request_body.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "app/formats/cell/command_inputs.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/json_value.hpp"
#include "tubesheets/csv_table.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

constexpr std::size_t kLongestText = 1u << 16;
constexpr std::size_t kLongestList = 20000;

const json* find(const json& object, const std::string& key) {
  const auto found = object.find(key);
  return found == object.end() || found->is_null() ? nullptr : &*found;
}

JsonValue valueIn(const json& value, const std::string& key) { return {value, "request (" + key + ")"}; }

std::string textIn(const JsonValue& value) {
  std::string text = value.text();
  if (text.size() > kLongestText) value.refuse(fmt::format("a string of at most {} bytes", kLongestText));
  return text;
}

std::vector<JsonValue> itemsIn(const json& list, const std::string& key) {
  if (list.size() > kLongestList) valueIn(list, key).refuse(fmt::format("a list of at most {} items", kLongestList));
  return valueIn(list, key).items();
}

}  // namespace

json objectOf(const Request& request) {
  if (request.body.empty()) return json::object();
  constexpr const char* kBody = "request body";
  constexpr const char* kExpected = "the JSON that this address expects";
  json object = parseJson(request.body, kBody, kExpected);
  if (!object.is_object()) throw NotJson(kBody, fmt::format("a JSON {}", object.type_name()), "a JSON object");
  return object;
}

int integerOf(const json& object, const std::string& key, int otherwise, int least, int most) {
  const json* value = find(object, key);
  return value ? valueIn(*value, key).integer(least, most) : otherwise;
}

std::uint64_t seedOf(const json& object) {
  const json* value = find(object, "seed");
  if (!value) return 1;
  if (!value->is_number_unsigned()) valueIn(*value, "seed").refuse("a whole number, zero or more");
  return value->get<std::uint64_t>();
}

double numberOf(const json& object, const std::string& key, double otherwise) {
  const json* value = find(object, key);
  return value ? valueIn(*value, key).number() : otherwise;
}

bool booleanOf(const json& object, const std::string& key, bool otherwise) {
  const json* value = find(object, key);
  return value ? valueIn(*value, key).boolean() : otherwise;
}

std::string textOf(const json& object, const std::string& key, const std::string& otherwise) {
  const json* value = find(object, key);
  return value ? textIn(valueIn(*value, key)) : otherwise;
}

std::vector<std::string> textsOf(const json& object, const std::string& key) {
  std::vector<std::string> texts;
  const json* value = find(object, key);
  if (!value) return texts;
  for (const auto& item : itemsIn(*value, key)) texts.push_back(textIn(item));
  return texts;
}

std::vector<double> numbersOf(const json& object, const std::string& key) {
  std::vector<double> numbers;
  for (const auto& item : itemsIn(requiredOf(object, key, "a list of numbers"), key)) numbers.push_back(item.number());
  return numbers;
}

const json& requiredOf(const json& object, const std::string& key, const std::string& expected) {
  const json* value = find(object, key);
  if (!value) throw InputError::problem("request (" + key + ")", "the key is missing", "give " + expected);
  return *value;
}

Eigen::VectorXd jointsOf(const json& body, const Cell& cell) {
  std::vector<std::string> texts;
  for (const double value : numbersOf(body, "joints")) texts.push_back(fmt::format("{}", value));
  return parseJoints(fmt::format("{}", fmt::join(texts, ",")), cell.arm, cell.units, "request (joints)");
}

double loadOf(const json& body, const Cell& cell) {
  return parseLoad(numberOf(body, "load", 0), cell.units, "request (load)");
}

std::optional<int> holeOf(const json& body, const Cell& cell) {
  if (!body.contains("hole") || body["hole"].is_null()) return std::nullopt;
  return requiredHoleOf(body, cell);
}

int requiredHoleOf(const json& body, const Cell& cell) {
  const auto& sheet = requireSheet(cell, "name a hole");
  (void)requiredOf(body, "hole", "the index of a hole");
  return integerOf(body, "hole", 0, 0, static_cast<int>(sheet.tubes.size()) - 1);
}

std::vector<int> selectedTubes(const std::string& text, const tubesheets::Sheet& sheet) {
  const auto selection = tubesheets::selectTubes(sheet, text);
  if (selection.status != tubesheets::SelectionStatus::kSelected)
    throw InputError::problem(
        "tubes", fmt::format("{} does not select tubes of this sheet: {}", inQuotes(text), selection.reason),
        "use a selection such as all, R10C20, R1-10C5-9, outer:2, every:10, spread:60 or -plugged");
  return selection.tube_indices;
}

std::string tubesText(const json& body, const tubesheets::Sheet& sheet, const std::string& otherwise) {
  if (!body.contains("tubes") || !body["tubes"].is_array()) {
    const std::string text = textOf(body, "tubes", otherwise);
    (void)selectedTubes(text, sheet);
    return text;
  }
  std::vector<std::string> names;
  const auto numbers = numbersOf(body, "tubes");
  for (const double number : numbers) {
    if (!(number >= 0 && number < static_cast<double>(sheet.tubes.size())) || number != std::floor(number))
      throw InputError("tubes", fmt::format("{}", number),
                       fmt::format("the index of a hole, 0 to {}", sheet.tubes.size() - 1));
    const auto& tube = sheet.tubes[static_cast<std::size_t>(number)];
    // A range of one tube excludes a plugged tube; a tube selected by name is always included.
    names.push_back(numbers.size() > 1 ? fmt::format("R{0}-{0}C{1}-{1}", tube.row, tube.column)
                                       : tubesheets::tubeName(tube.row, tube.column));
  }
  const std::string text = fmt::format("{}", fmt::join(names, ","));
  (void)selectedTubes(text, sheet);
  return text;
}

std::map<int, double> dwellTimesOf(const json& body, const tubesheets::Sheet& sheet) {
  std::map<int, double> dwell_times;
  if (!body.contains("stays") || body["stays"].is_null()) return dwell_times;
  if (!body["stays"].is_object())
    throw InputError("stays", body["stays"].dump(), "an object {index of a hole: seconds}");
  for (const auto& [name, dwell] : body["stays"].items()) {
    const auto tube = tubesheets::parseInteger(name);
    if (!tube || *tube < 0 || *tube >= static_cast<int>(sheet.tubes.size()))
      throw InputError("stays", inQuotes(name), fmt::format("the index of a hole, 0 to {}", sheet.tubes.size() - 1));
    if (!dwell.is_number() || !(dwell.get<double>() >= 0 && dwell.get<double>() <= tubesheets::kLongestDwell))
      throw InputError("stays", dwell.dump(), "seconds from 0 to a day");
    dwell_times.emplace(*tube, dwell.get<double>());
  }
  return dwell_times;
}

}  // namespace tubeplan::app
