// Exception for input of the user that cannot be used. Readers and commands throw it; main catches it in one place.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tubeplan::app {

/// Error in the user's input, with a message of one line: "where: found F, expected E; advice" of a wrong value, else
/// "where: what happened; advice".
class InputError : public std::runtime_error {
 public:
  /// Creates the error of a wrong value. `where` names the file with line and column, or the option. `found` and
  /// `expected` are values or kinds of values, which continue "found ..., expected ...". `advice` states the remedy and
  /// may be empty.
  InputError(std::string where, std::string found, std::string expected, std::string advice = "");

  /// Returns the error of anything but a wrong value. `what` is a sentence without its full stop, "no such file";
  /// `advice` states what to do, "check the name and the folder", and may be empty.
  [[nodiscard]] static InputError saying(std::string where, std::string what, std::string advice = "");

  [[nodiscard]] const std::string& where() const { return where_; }
  /// Returns the wrong value, or the sentence of what happened.
  [[nodiscard]] const std::string& found() const { return found_; }
  /// Returns the expected value; empty unless a value is wrong.
  [[nodiscard]] const std::string& expected() const { return expected_; }
  [[nodiscard]] const std::string& advice() const { return advice_; }

 private:
  std::string where_, found_, expected_, advice_;
};

/// Returns the error for a failed operation of the file system, with the file and the reason.
[[nodiscard]] InputError inputErrorOf(const std::filesystem::filesystem_error& error);

/// Returns text of the user's in quotes, for one line of a message: unprintable bytes as `\xNN`, cut after 60
/// characters.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// Returns a name of the user's for a line of a table: printable as with inQuotes(), but without the quotes.
[[nodiscard]] std::string nameInLine(std::string_view name);

}  // namespace tubeplan::app
