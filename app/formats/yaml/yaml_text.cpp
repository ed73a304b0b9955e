#include "app/formats/yaml/yaml_text.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "app/storage/lower_case.hpp"

namespace tubeplan::app {

namespace {

constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::string_view kOthers = "0123456789_-";

/// Returns true for words that YAML reads as null or a boolean.
bool isReserved(const std::string& name) {
  constexpr std::array<std::string_view, 9> kReserved = {"null", "true", "false", "yes", "no", "on", "off", "y", "n"};
  return std::find(kReserved.begin(), kReserved.end(), lowerCase(name)) != kReserved.end();
}

}  // namespace

// A JSON string is also a valid YAML string.
std::string yamlQuoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string yamlName(const std::string& name) {
  const auto isPlain = [](char c) {
    return kLetters.find(c) != std::string_view::npos || kOthers.find(c) != std::string_view::npos;
  };
  const bool is_word = !name.empty() && kLetters.find(name.front()) != std::string_view::npos &&
                       std::all_of(name.begin(), name.end(), isPlain) && !isReserved(name);
  return is_word ? name : yamlQuoted(name);
}

}  // namespace tubeplan::app
