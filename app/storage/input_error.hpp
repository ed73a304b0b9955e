// The one exception of the program: the user's input cannot be used. Thrown by the readers and commands, caught once in
// main.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// Its message is one line: "where: found F, expected E; advice".
class InputError : public std::runtime_error {
 public:
  /// `where` names the file with line and column, or the option; `found` and `expected` continue "found ..., expected
  /// ..."; `advice` says what to do and may be empty.
  InputError(std::string where, std::string found, std::string expected, std::string advice = "");

  [[nodiscard]] const std::string& where() const { return where_; }
  [[nodiscard]] const std::string& found() const { return found_; }
  [[nodiscard]] const std::string& expected() const { return expected_; }
  [[nodiscard]] const std::string& advice() const { return advice_; }

 private:
  std::string where_, found_, expected_, advice_;
};

/// What the file system would not do, and with which file.
[[nodiscard]] InputError inputErrorOf(const std::filesystem::filesystem_error& error);

/// Text of the user's in quotes, fit for one line of a message: unprintable bytes as `\xNN`, cut after 60 characters.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// A name of the user's in a line of a table: the same without the quotes.
[[nodiscard]] std::string nameInLine(std::string_view name);

}  // namespace tubeplan::app
