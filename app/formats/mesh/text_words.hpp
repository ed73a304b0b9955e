// A text word by word, which knows its line.
#pragma once

#include <string>
#include <string_view>

namespace tubeplan::app {

class TextWords {
 public:
  /// Of a text that outlives it; `name` is the file's, for messages.
  TextWords(std::string_view text, std::string name);

  /// The next word, over ends of lines too; empty at the end of the text.
  std::string_view next();
  /// The next word of this line; empty where the line ends. A backslash at its end carries it on.
  std::string_view nextInLine();
  /// Leaves the rest of this line out, and its end.
  void skipLine();

  /// The next word of this line, which must be a finite number.
  double number();

  [[nodiscard]] bool atEnd() const { return at_ == text_.size(); }
  [[nodiscard]] std::size_t position() const { return at_; }  ///< of the byte after what was read

  /// Throws InputError at this line; an empty `found` stands for the end of the line or the file.
  [[noreturn]] void fail(std::string_view found, const std::string& expected) const;

 private:
  void skipBlanks(bool over_lines);
  std::string_view word();

  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace tubeplan::app
