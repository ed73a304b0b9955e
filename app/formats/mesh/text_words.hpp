// Reader that splits text into words and counts lines for messages.
#pragma once

#include <string>
#include <string_view>

namespace tubeplan::app {

class TextWords {
 public:
  /// Keeps a view of `text`, which must outlive this object; messages name the file as `name`.
  TextWords(std::string_view text, std::string name);

  /// Returns the next word on the current or a later line; empty at the end of the text.
  std::string_view next();
  /// Returns the next word on the current line; empty at the end of the line. A backslash at the end of a line
  /// continues the line.
  std::string_view nextInLine();
  /// Skips the rest of the current line, including its line break.
  void skipLine();

  /// Reads the next word of the current line as a number. Throws InputError unless it is a finite number.
  double number();

  [[nodiscard]] bool atEnd() const { return at_ == text_.size(); }
  [[nodiscard]] std::size_t position() const { return at_; }  ///< index of the first unread byte

  /// Throws InputError at the current line; an empty `found` means the end of the line or of the file.
  [[noreturn]] void fail(std::string_view found, const std::string& expected) const;
  /// Throws InputError::problem() at the current line.
  [[noreturn]] void failWithProblem(const std::string& what) const;

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
