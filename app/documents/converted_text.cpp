#include "app/documents/converted_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

constexpr std::string_view kMinus = "\u2212";

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isWordPart(char c) {
  return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.' || c == '@' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Number in a clause. Numbers joined by "±" or "to" share the unit of the last one.
struct Number {
  std::size_t begin = 0, end = 0;  ///< place in the text
  bool is_whole = true;
  int digits = 0;              ///< significant digits as written
  bool is_joined = false;      ///< true if the unit is that of the next number
  std::string_view unit = {};  ///< text of the unit that follows; empty if none does
};

/// Returns the number that begins at `at`; its end is `at` if none does.
Number numberAt(std::string_view text, std::size_t at) {
  Number number{at, at};
  std::size_t k = at;
  if (text.substr(k).starts_with(kMinus))
    k += kMinus.size();
  else if (k < text.size() && (text[k] == '-' || text[k] == '+'))
    ++k;
  const std::size_t first = k;
  bool has_begun = false;
  for (; k < text.size(); ++k) {
    if (text[k] == '.' && number.is_whole && k + 1 < text.size() && isDigit(text[k + 1])) {
      number.is_whole = false;
      continue;
    }
    if (!isDigit(text[k])) break;
    has_begun = has_begun || text[k] != '0';
    number.digits += has_begun ? 1 : 0;
  }
  if (k == first) return number;
  const std::size_t sign = k + 1 < text.size() && (text[k + 1] == '-' || text[k + 1] == '+') ? 2 : 1;
  if (k + sign < text.size() && text[k] == 'e' && isDigit(text[k + sign])) {
    for (k += sign; k < text.size() && isDigit(text[k]);) ++k;
    number.is_whole = false;
  }
  number.end = k;
  return number;
}

/// Words after which "in" is the unit of the number before it.
constexpr std::array<std::string_view, 14> kAfterInches{"to",   "and", "or", "is",   "are",   "than",  "beyond",
                                                        "from", "by",  "as", "more", "after", "along", "around"};

/// Returns true unless "in" that ends at `end` may be the word.
bool isInches(std::string_view text, std::size_t end) {
  if (end >= text.size() || text[end] != ' ') return true;
  const std::string_view following = text.substr(end + 1);
  if (following.starts_with('(')) return true;
  return std::ranges::find(kAfterInches, following.substr(0, following.find_first_of(" ,;:.)"))) != kAfterInches.end();
}

/// Returns the unit that begins at `at`, such as "mm" or "1/(lbf*in)"; empty if none does.
std::string_view unitAt(std::string_view text, std::size_t at, const TargetUnits& target) {
  std::size_t end = at;
  int open = 0;
  for (; end < text.size() && std::string_view(" ,;:\n").find(text[end]) == std::string_view::npos; ++end) {
    open += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
    if (open < 0) break;
  }
  while (end > at && text[end - 1] == '.') --end;
  const std::string_view unit = text.substr(at, end - at);
  if (unit.empty() || !convertedUnit(unit, target)) return {};
  return unit == "in" && !isInches(text, end) ? std::string_view() : unit;
}

/// Returns a value with as many significant digits, but at least three; zero and whole numbers have no decimals.
std::string withDigits(double value, int digits) {
  constexpr int kLeastDigits = 3, kMostDecimals = 9;
  const int decimals = std::max(digits, kLeastDigits) - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (value == 0 || decimals > kMostDecimals) return fmt::format("{:.3g}", value);
  return fmt::format("{:.{}f}", value, std::max(decimals, 0));
}

/// Text whose numbers are converted clause by clause.
class ConvertedText {
 public:
  ConvertedText(std::string_view text, const TargetUnits& target) : text_(text), target_(target) {}

  std::string convert() {
    for (std::size_t at = 0; at < text_.size();) {
      if (isEndOfClause(at)) endClause();
      const Number number = mayBegin(at) ? numberAt(text_, at) : Number{at, at};
      at = number.end > at ? take(number) : at + 1;
    }
    endClause();
    return std::move(result_).append(text_.substr(written_));
  }

 private:
  [[nodiscard]] bool isEndOfClause(std::size_t at) const {
    const char c = text_[at];
    if (c == ';' || c == '(' || c == ')' || c == '\n') return true;
    return (c == '.' || c == ':') && (at + 1 >= text_.size() || text_[at + 1] == ' ');
  }

  [[nodiscard]] bool mayBegin(std::size_t at) const { return at == 0 || !isWordPart(text_[at - 1]); }

  /// Notes a number with what follows it, and returns the place after both.
  std::size_t take(Number number) {
    const std::string_view following = text_.substr(number.end);
    std::size_t end = number.end;
    for (const std::string_view link : {" ± ", " to "})
      if (following.starts_with(link) && numberAt(text_, number.end + link.size()).end > number.end + link.size()) {
        number.is_joined = true;
        end += link.size();
      }
    if (!number.is_joined && following.starts_with(' ')) {
      number.unit = unitAt(text_, number.end + 1, target_);
      if (!number.unit.empty()) end = number.end + 1 + number.unit.size();
    }
    is_shared_ = is_shared_ || mayShare(number, following);
    if (end < text_.size() && isWordPart(text_[end]) && end == number.end) {  // part of a name such as 12a
      return end;
    }
    numbers_.push_back(number);
    return end;
  }

  /// Returns true if a number without a unit may have that of a later one, as in "x 1.2, y 3.4 mm".
  static bool mayShare(const Number& number, std::string_view following) {
    if (number.is_joined || !number.unit.empty()) return false;
    for (const char* behind : {" %", "%", " times "})
      if (following.starts_with(behind)) return false;
    return !number.is_whole || following.starts_with(',') || following.starts_with(" and ") ||
           following.starts_with(" x ");
  }

  void endClause() {
    for (auto number = numbers_.rbegin(); number != numbers_.rend(); ++number)
      if (number->is_joined && number != numbers_.rbegin()) number->unit = std::prev(number)->unit;
    if (!is_shared_)
      for (const Number& number : numbers_) write(number);
    numbers_.clear();
    is_shared_ = false;
  }

  void write(const Number& number) {
    if (number.unit.empty()) return;
    const ConvertedUnit unit = *convertedUnit(number.unit, target_);
    if (unit.name == number.unit) return;
    std::string digits(text_.substr(number.begin, number.end - number.begin));
    if (digits.starts_with(kMinus)) digits.replace(0, kMinus.size(), "-");
    const double value = tubesheets::parseNumber(digits).value_or(0) * unit.factor;
    result_ += text_.substr(written_, number.begin - written_);
    result_ += withDigits(value, number.digits);
    written_ = number.end;
    if (number.is_joined) return;
    result_ += " " + unit.name;
    written_ += 1 + number.unit.size();
  }

  std::string_view text_;
  const TargetUnits& target_;
  std::string result_;
  std::size_t written_ = 0;  ///< end of the text that the result covers
  std::vector<Number> numbers_;
  bool is_shared_ = false;
};

}  // namespace

std::string textInUnits(std::string_view text, const TargetUnits& target) {
  return ConvertedText(text, target).convert();
}

}  // namespace tubeplan::app
