// Reader of a text word by word that counts lines for messages.
#pragma once

#include <string>
#include <string_view>

namespace tubeplan::app {

class TextWords {
 public:
  /// Refers to a text that outlives it; `name` is the file's name in messages.
  TextWords(std::string_view text, std::string name);

  /// Returns the next word on this line or a later one; empty at the end of the text.
  std::string_view next();
  /// Returns the next word of this line; empty at its end. A backslash at the end of a line continues it on the next.
  std::string_view nextInLine();
  /// Skips the rest of this line, with its end.
  void skipLine();

  /// Returns the next word of this line as a number. Throws InputError unless it is finite.
  double number();

  [[nodiscard]] bool atEnd() const { return at_ == text_.size(); }
  [[nodiscard]] std::size_t position() const { return at_; }  ///< index of the byte after the last one read

  /// Throws InputError at this line; an empty `found` means the end of the line or the file.
  [[noreturn]] void fail(std::string_view found, const std::string& expected) const;
  /// Throws InputError::saying() at this line.
  [[noreturn]] void failSaying(const std::string& what) const;

 private:
  [[nodiscard]] std::string where() const;
  void skipBlanks(bool over_lines);
  std::string_view word();

  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace tubeplan::app
