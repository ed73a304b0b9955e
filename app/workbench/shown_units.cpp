#include "app/workbench/shown_units.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/documents/converted_text.hpp"
#include "app/formats/units.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

const Unit* shownUnit(UnitKind kind, std::string_view name) {
  const Unit* unit = name.empty() ? nullptr : findUnit(kind, name);
  if (!unit && !name.empty()) throw InputError("units", inQuotes(std::string(name)), alternatives(unitNames(kind)));
  return unit;
}

FileFigures fileFiguresOf(const Cell& cell) {
  FileFigures file{std::string(cell.units.length().name), std::string(cell.units.angle().name)};
  for (Eigen::Index k = 0; k < cell.arm.jointCount(); ++k)
    file.joints.push_back({cell.arm.joint(k).name, cell.arm.joint(k).type == deflection::JointType::kPrismatic});
  return file;
}

/// Keys of sentences, in which numbers have their units. Other text, such as names and formulas, stays as it is. So
/// does the text of an error, whose wrong value has no unit.
constexpr std::string_view kSentences[] = {"found",     "advice", "also_words", "ground",   "grounds", "left_out",
                                           "meaning",   "notes",  "not_tried",  "reason",   "remarks", "sentence",
                                           "sentences", "to_do",  "warning",    "warnings", "words",   "verdict_words"};

void convertSentences(json& value, bool is_sentence, const TargetUnits& target) {
  if (value.is_string() && is_sentence) value = textInUnits(value.get_ref<const std::string&>(), target);
  if (value.is_array())
    for (json& item : value) convertSentences(item, is_sentence, target);
  if (value.is_object())
    for (auto& [key, inner] : value.items())
      if (key != "error" && key != "problem")
        convertSentences(inner, std::ranges::find(kSentences, key) != std::end(kSentences), target);
}

/// Keys of requests whose numbers are lengths, and those that have a posture: a list, or text such as "10,45,-35,12".
constexpr const char* kLengths[] = {"sigma", "standoff", "insertion"};
constexpr const char* kPostures[] = {"joints", "start", "end"};

/// Returns the numbers of a posture in text; null if it is something else, such as "park" or the name of a tube.
json numbersIn(const json& text) {
  json numbers = json::array();
  std::string_view remaining = text.get_ref<const std::string&>();
  while (true) {
    const std::size_t comma = std::min(remaining.find(','), remaining.size());
    const auto number = tubesheets::parseNumber(tubesheets::trimBlanks(remaining.substr(0, comma)));
    if (!number) return nullptr;
    numbers.push_back(*number);
    if (comma == remaining.size()) return numbers;
    remaining.remove_prefix(comma + 1);
  }
}

/// Converts a number that was written in the `shown` unit. It is rounded so that a limit of the file stays within it.
void takeNumber(json& number, const Unit* shown, const Unit& file) {
  if (number.is_number() && shown) number = rounded(number.get<double>() * (shown->factor / file.factor));
}

}  // namespace

std::optional<ShownUnits> ShownUnits::of(const Request& request) {
  const std::string units_text = request.parameter("units");
  if (units_text.empty()) return std::nullopt;
  const std::size_t comma = std::min(units_text.find(','), units_text.size());
  const Unit* length = shownUnit(UnitKind::kLength, units_text.substr(0, comma));
  return ShownUnits(length, shownUnit(UnitKind::kAngle, comma < units_text.size() ? units_text.substr(comma + 1) : ""));
}

json ShownUnits::shown(json document, const Session& session) const {
  json converted = inUnits(std::move(document), fileFiguresOf(currentModel(session).cell), target_);
  convertSentences(converted, false, target_);
  return converted;
}

Answer ShownUnits::shown(Answer answer, const Session& session) const {
  const bool is_document = answer.content_type == "application/json" && answer.headers.empty();
  if (!is_document || answer.status >= 400) return answer;
  answer.body = answerOf(shown(json::parse(answer.body), session)).body;
  return answer;
}

Request ShownUnits::inFileUnits(Request request, const Session& session) const {
  json body = json::parse(request.body, nullptr, false);
  if (request.content_type.starts_with("text/") || !body.is_object()) return request;
  const Cell& cell = currentModel(session).cell;
  for (const char* key : kLengths)
    if (body.contains(key)) takeNumber(body[key], length_, cell.units.length());
  for (const char* key : kPostures) {
    if (!body.contains(key)) continue;
    json numbers = body[key].is_string() ? numbersIn(body[key]) : body[key];
    if (!numbers.is_array() || numbers.size() != static_cast<std::size_t>(cell.arm.jointCount())) continue;
    for (Eigen::Index k = 0; k < cell.arm.jointCount(); ++k) {
      const bool is_slide = cell.arm.joint(k).type == deflection::JointType::kPrismatic;
      takeNumber(numbers[static_cast<std::size_t>(k)], is_slide ? length_ : angle_,
                 is_slide ? cell.units.length() : cell.units.angle());
    }
    const std::string text = numbers.dump();
    body[key] = body[key].is_string() ? json(text.substr(1, text.size() - 2)) : numbers;
  }
  request.body = body.dump(-1, ' ', false, json::error_handler_t::replace);
  return request;
}

double ShownUnits::lengthFactor(const Units& file) const { return (length_ ? *length_ : file.length()).factor; }

}  // namespace tubeplan::app
