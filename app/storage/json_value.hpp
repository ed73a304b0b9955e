// Values of a JSON document, each with its position in the document, read with checks of type and range.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

/// Maximum nesting depth that parseJson() accepts; the program's own JSON stays within it.
inline constexpr int kDeepestJson = 16;

class NotJson : public InputError {
 public:
  using InputError::InputError;
};

/// Parses a JSON text. Throws NotJson, with line and column, for text that is not JSON or is nested deeper than
/// kDeepestJson. `expected` and `advice` become parts of the error message.
[[nodiscard]] nlohmann::json parseJson(std::string_view text, const std::string& where, const std::string& expected,
                                       const std::string& advice = "");

/// Reference to a value of a JSON document, which must outlive it. Accessors throw InputError, with the value's
/// position, for a value of another type or a number out of bounds.
class JsonValue {
 public:
  /// Refers to the whole document, which messages call `name`; `advice` ends every message.
  JsonValue(const nlohmann::json& document, std::string name, std::string advice = "")
      : JsonValue(document, std::move(name), "", std::move(advice)) {}

  [[nodiscard]] const nlohmann::json& json() const { return value_; }

  /// Returns true if the value is an object with this key.
  [[nodiscard]] bool has(const std::string& key) const { return value_.is_object() && value_.contains(key); }

  /// Returns the value of a required key; messages name it as "plan.json sheet.name".
  [[nodiscard]] JsonValue at(const std::string& key) const;

  /// Returns the items of an array; messages name them as "plan.json tubes[0]".
  [[nodiscard]] std::vector<JsonValue> items() const;

  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] double number(double least = -std::numeric_limits<double>::infinity(),
                              double most = std::numeric_limits<double>::infinity()) const;

  /// Returns the value as an integer; a number such as 3.0 is accepted.
  [[nodiscard]] int integer(int least, int most) const;

  /// Returns the value as an array of exactly `count` numbers.
  [[nodiscard]] Eigen::VectorXd numbers(Eigen::Index count) const;

  [[noreturn]] void refuse(const std::string& expected) const;

 private:
  JsonValue(const nlohmann::json& value, std::string document, std::string path, std::string advice)
      : value_(value), document_(std::move(document)), path_(std::move(path)), advice_(std::move(advice)) {}
  [[nodiscard]] std::string place() const { return path_.empty() ? document_ : document_ + " " + path_; }

  const nlohmann::json& value_;
  std::string document_, path_, advice_;
};

}  // namespace tubeplan::app
