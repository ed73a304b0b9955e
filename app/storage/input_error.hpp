// Exception for user input that cannot be used. Readers and commands throw it; main() prints its message.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// Error in the user's input, with a one-line message: "where: found F, expected E; advice" for a wrong value, or else
/// "where: what happened; advice".
class InputError : public std::runtime_error {
 public:
  /// Creates the error for a wrong value. `where` names the file with line and column, or the option. `found` and
  /// `expected` are values or descriptions of values, which complete "found ..., expected ...". `advice` states the
  /// remedy and may be empty.
  InputError(std::string where, std::string found, std::string expected, std::string advice = "");

  /// Returns the error for a problem other than a wrong value. `what` is a sentence without its full stop, such as "no
  /// such file". `advice` states a remedy, such as "check the name and the folder", and may be empty.
  [[nodiscard]] static InputError problem(std::string where, std::string what, std::string advice = "");

  [[nodiscard]] const std::string& where() const { return where_; }
  /// Returns the wrong value, or the sentence passed to problem().
  [[nodiscard]] const std::string& found() const { return found_; }
  /// Returns the expected value; empty for an error made by problem().
  [[nodiscard]] const std::string& expected() const { return expected_; }
  [[nodiscard]] const std::string& advice() const { return advice_; }

 private:
  std::string where_, found_, expected_, advice_;
};

/// Returns the error for a failed file-system operation, with the file and the reason.
[[nodiscard]] InputError inputErrorOf(const std::filesystem::filesystem_error& error);

/// Returns user text in quotes for a one-line message. Unprintable characters become escapes such as `\x1B`; text
/// beyond 60 bytes is cut.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// Returns a user-defined name for a line of a table: escaped as by inQuotes(), but without quotes.
[[nodiscard]] std::string nameInLine(std::string_view name);

}  // namespace tubeplan::app
