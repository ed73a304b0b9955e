#include "app/workbench/request_body.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/files/input_error.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

constexpr std::size_t kLongestText = 1u << 16;
constexpr std::size_t kLongestList = 20000;

[[noreturn]] void refuse(const std::string& key, const json& value, const std::string& expected) {
  const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  throw InputError("request (" + key + ")", inQuotes(text), expected);
}

const json* find(const json& object, const std::string& key) {
  const auto found = object.find(key);
  return found == object.end() || found->is_null() ? nullptr : &*found;
}

std::string textIn(const json& value, const std::string& key) {
  if (!value.is_string() || value.get_ref<const std::string&>().size() > kLongestText) refuse(key, value, "a text");
  return value.get<std::string>();
}

double numberIn(const json& value, const std::string& key) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) refuse(key, value, "a finite number");
  return value.get<double>();
}

const json& listIn(const json& value, const std::string& key, const std::string& expected) {
  if (!value.is_array() || value.size() > kLongestList) refuse(key, value, expected);
  return value;
}

}  // namespace

json objectOf(const Request& request) {
  if (request.body.empty()) return json::object();
  const json::parser_callback_t bounded = [](int depth, json::parse_event_t, json&) {
    if (depth > kDeepestJson) throw json::other_error::create(501, "nested too deeply", nullptr);
    return true;
  };
  json object = json::parse(request.body, bounded);
  if (!object.is_object()) throw json::type_error::create(302, "the body must be an object", &object);
  return object;
}

int integerOf(const json& object, const std::string& key, int otherwise, int least, int most) {
  const json* value = find(object, key);
  if (!value) return otherwise;
  const std::string expected = fmt::format("a whole number from {} to {}", least, most);
  if (!value->is_number()) refuse(key, *value, expected);
  const double number = value->get<double>();
  if (!(number >= least && number <= most) || number != std::floor(number)) refuse(key, *value, expected);
  return static_cast<int>(number);
}

std::uint64_t seedOf(const json& object) {
  const json* value = find(object, "seed");
  if (!value) return 1;
  if (!value->is_number_unsigned()) refuse("seed", *value, "a whole number, zero or more");
  return value->get<std::uint64_t>();
}

double numberOf(const json& object, const std::string& key, double otherwise) {
  const json* value = find(object, key);
  return value ? numberIn(*value, key) : otherwise;
}

bool booleanOf(const json& object, const std::string& key, bool otherwise) {
  const json* value = find(object, key);
  if (!value) return otherwise;
  if (!value->is_boolean()) refuse(key, *value, "true or false");
  return value->get<bool>();
}

std::string textOf(const json& object, const std::string& key, const std::string& otherwise) {
  const json* value = find(object, key);
  return value ? textIn(*value, key) : otherwise;
}

std::vector<std::string> textsOf(const json& object, const std::string& key) {
  std::vector<std::string> texts;
  const json* value = find(object, key);
  if (!value) return texts;
  for (const auto& item : listIn(*value, key, "a list of texts")) texts.push_back(textIn(item, key));
  return texts;
}

std::vector<double> numbersOf(const json& object, const std::string& key) {
  std::vector<double> numbers;
  for (const auto& item : listIn(requiredOf(object, key, "a list of numbers"), key, "a list of numbers"))
    numbers.push_back(numberIn(item, key));
  return numbers;
}

const json& requiredOf(const json& object, const std::string& key, const std::string& expected) {
  const json* value = find(object, key);
  if (!value) throw InputError("request (" + key + ")", "nothing", expected);
  return *value;
}

}  // namespace tubeplan::app
