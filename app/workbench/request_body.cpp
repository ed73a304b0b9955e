#include "app/workbench/request_body.hpp"

#include <fmt/format.h>

#include "app/files/input_error.hpp"
#include "app/files/json_value.hpp"

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
  if (text.size() > kLongestText) value.refuse(fmt::format("a text of at most {} bytes", kLongestText));
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
  constexpr const char* kExpected = "the JSON that this address takes";
  json object = parseJson(request.body, kBody, kExpected);
  if (!object.is_object()) throw NotJson(kBody, "no object", kExpected);
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
  if (!value) throw InputError("request (" + key + ")", "nothing", expected);
  return *value;
}

}  // namespace tubeplan::app
