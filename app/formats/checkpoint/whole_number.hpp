// Checked conversion of integers from JSON files of this program, which may be damaged.
#pragma once

#include <concepts>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace tubeplan::app {

/// Converts a JSON value to an integer more strictly than nlohmann::json, which accepts 1e30 and 2.5. Throws
/// nlohmann::json::type_error for anything but an integer in the range of the type.
template <std::integral Whole>
Whole wholeNumber(const nlohmann::json& value) {
  if (value.is_number_unsigned() && std::in_range<Whole>(value.get<std::uint64_t>()))
    return static_cast<Whole>(value.get<std::uint64_t>());
  if (value.is_number_integer() && !value.is_number_unsigned() && std::in_range<Whole>(value.get<std::int64_t>()))
    return static_cast<Whole>(value.get<std::int64_t>());
  throw nlohmann::json::type_error::create(302, "type must be a whole number, but it is another", &value);
}

template <std::integral Whole>
std::vector<Whole> wholeNumbers(const nlohmann::json& list) {
  std::vector<Whole> numbers;
  numbers.reserve(list.size());
  for (const auto& value : list) numbers.push_back(wholeNumber<Whole>(value));
  return numbers;
}

}  // namespace tubeplan::app
