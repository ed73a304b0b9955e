#include "app/storage/json_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/storage/utf8.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

/// Returns a string such as " from 0 to 10" or ", at least 0"; empty if both bounds are infinite.
std::string boundsText(double least, double most) {
  if (std::isfinite(least) && std::isfinite(most)) return fmt::format(" from {} to {}", least, most);
  if (std::isfinite(least)) return fmt::format(", at least {}", least);
  return std::isfinite(most) ? fmt::format(", at most {}", most) : "";
}

/// Returns a position such as "plan.json:3:17" (line and column) for the byte at which the JSON parser stopped.
std::string placeIn(std::string_view text, const std::string& where, std::size_t byte) {
  const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n');
  return fmt::format("{}:{}:{}", where, line, before.size() - (start == std::string_view::npos ? 0 : start + 1) + 1);
}

}  // namespace

json parseJson(std::string_view text, const std::string& where, const std::string& expected,
               const std::string& advice) {
  const json::parser_callback_t bounded = [&](int depth, json::parse_event_t, json&) {
    if (depth > kDeepestJson)
      throw NotJson(where, fmt::format("values nested more than {} deep", kDeepestJson), expected, advice);
    return true;
  };
  try {
    return json::parse(text, bounded);
  } catch (const json::parse_error& error) {
    throw NotJson(placeIn(text, where, error.byte), "text that is not JSON", expected, advice);
  } catch (const json::exception&) {
    throw NotJson(where, "a number beyond the range of JSON", expected, advice);
  }
}

void JsonValue::refuse(const std::string& expected) const {
  throw InputError(place(), inQuotes(value_.dump(-1, ' ', false, json::error_handler_t::replace)), expected, advice_);
}

JsonValue JsonValue::at(const std::string& key) const {
  if (!value_.is_object()) refuse("an object with the key " + key);
  const auto found = value_.find(key);
  if (found == value_.end()) throw InputError::problem(place(), "the key " + inQuotes(key) + " is missing", advice_);
  return {*found, document_, path_ + (path_.empty() ? "" : ".") + key, advice_};
}

std::vector<JsonValue> JsonValue::items() const {
  if (!value_.is_array()) refuse("a list");
  std::vector<JsonValue> items;
  items.reserve(value_.size());
  for (const auto& item : value_)
    items.push_back({item, document_, fmt::format("{}[{}]", path_, items.size()), advice_});
  return items;
}

std::string JsonValue::text() const {
  if (!value_.is_string()) refuse("a string");
  auto text = value_.get<std::string>();
  if (!isPlainText(text)) refuse("a string without control characters");
  return text;
}

bool JsonValue::boolean() const {
  if (!value_.is_boolean()) refuse("true or false");
  return value_.get<bool>();
}

double JsonValue::number(double least, double most) const {
  const double number = value_.is_number() ? value_.get<double>() : std::numeric_limits<double>::quiet_NaN();
  if (!std::isfinite(number) || number < least || number > most) refuse("a finite number" + boundsText(least, most));
  return number;
}

int JsonValue::integer(int least, int most) const {
  const double number = value_.is_number() ? value_.get<double>() : std::numeric_limits<double>::quiet_NaN();
  if (!(number >= least && number <= most) || number != std::floor(number))
    refuse("a whole number" + boundsText(least, most));
  return static_cast<int>(number);
}

Eigen::VectorXd JsonValue::numbers(Eigen::Index count) const {
  const auto list = items();
  if (std::ssize(list) != count) refuse(fmt::format("{} numbers", count));
  Eigen::VectorXd numbers(count);
  for (Eigen::Index k = 0; k < count; ++k) numbers[k] = list[static_cast<std::size_t>(k)].number();
  return numbers;
}

}  // namespace tubeplan::app
