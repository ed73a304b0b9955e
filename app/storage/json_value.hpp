// A value of a JSON document with its place in it, taken out kind by kind, so that nothing a document says is trusted.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

/// What a JSON text of the program's own may nest.
inline constexpr int kDeepestJson = 16;

class NotJson : public InputError {
 public:
  using InputError::InputError;
};

/// Throws NotJson for text that is none, at its line and column, and for what nests deeper than kDeepestJson;
/// `expected` and `advice` are for its message.
[[nodiscard]] nlohmann::json parseJson(std::string_view text, const std::string& where, const std::string& expected,
                                       const std::string& advice = "");

/// Refers to a document that outlives it. Each reading throws InputError for a value of another kind or out of its
/// bounds, naming the place.
class JsonValue {
 public:
  /// The document, called `name`; `advice` is for every message.
  JsonValue(const nlohmann::json& document, std::string name, std::string advice = "")
      : JsonValue(document, std::move(name), "", std::move(advice)) {}

  [[nodiscard]] const nlohmann::json& json() const { return value_; }

  /// Whether it is an object with that key.
  [[nodiscard]] bool has(const std::string& key) const { return value_.is_object() && value_.contains(key); }

  /// The value of a key that must be there; for messages it is "plan.json sheet.name".
  [[nodiscard]] JsonValue at(const std::string& key) const;

  /// The items of a list; for messages they are "plan.json tubes[0]".
  [[nodiscard]] std::vector<JsonValue> items() const;

  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] double number(double least = -std::numeric_limits<double>::infinity(),
                              double most = std::numeric_limits<double>::infinity()) const;

  /// A whole number, also one that is written 3.0.
  [[nodiscard]] int integer(int least, int most) const;

  /// A list of so many numbers.
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
