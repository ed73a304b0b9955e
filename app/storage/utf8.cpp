#include "app/storage/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tubeplan::app {

namespace {

unsigned char byteAt(std::string_view text, std::size_t at) { return static_cast<unsigned char>(text[at]); }

/// Returns the length in bytes of a UTF-8 sequence with this first byte; 0 if no sequence starts with it.
std::size_t lengthBy(unsigned char first) {
  return first < 0x80                    ? 1
         : first >= 0xC2 && first < 0xE0 ? 2
         : first >= 0xE0 && first < 0xF0 ? 3
         : first >= 0xF0 && first < 0xF5 ? 4
                                         : 0;
}

/// Returns true if `second` may follow `first` in a UTF-8 sequence; this excludes overlong forms, surrogates and code
/// points above U+10FFFF.
bool isSecond(unsigned char first, unsigned char second) {
  const unsigned char least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned char most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  return second >= least && second <= most;
}

unsigned codePointOf(std::string_view sequence) {
  unsigned point = byteAt(sequence, 0);
  if (sequence.size() > 1) point &= 0x7Fu >> sequence.size();
  for (std::size_t k = 1; k < sequence.size(); ++k) point = (point << 6) | (byteAt(sequence, k) & 0x3Fu);
  return point;
}

/// Returns true for a Unicode control mark that changes the writing direction of the text after it.
bool turnsDirection(unsigned point) {
  return point == 0x061C || point == 0x200E || point == 0x200F || (point >= 0x202A && point <= 0x202E) ||
         (point >= 0x2066 && point <= 0x2069);
}

std::string shown(std::string_view sequence) {
  const unsigned point = codePointOf(sequence);
  if (isControl(sequence)) return fmt::format("\\x{:02X}", point);
  return turnsDirection(point) ? fmt::format("\\u{:04X}", point) : std::string(sequence);
}

}  // namespace

std::size_t sequenceLength(std::string_view text, std::size_t at) {
  const std::size_t length = lengthBy(byteAt(text, at));
  if (length == 0 || at + length > text.size()) return 0;
  if (length > 1 && !isSecond(byteAt(text, at), byteAt(text, at + 1))) return 0;
  for (std::size_t k = 2; k < length; ++k)
    if ((byteAt(text, at + k) & 0xC0) != 0x80) return 0;
  return length;
}

bool isControl(std::string_view sequence) {
  const unsigned point = codePointOf(sequence);
  return point < 0x20 || (point >= 0x7F && point < 0xA0);
}

std::optional<std::size_t> findNonText(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequenceLength(text, at);
    if (length == 0) return at;
    const std::string_view sequence = text.substr(at, length);
    const bool ends_line = sequence == "\n" || text.substr(at).starts_with("\r\n") || text.substr(at) == "\r";
    if (isControl(sequence) && !ends_line && sequence != "\t") return at;
    at += length;
  }
  return std::nullopt;
}

bool isPlainText(std::string_view text) { return !findNonText(text); }

std::string printable(std::string_view text, std::size_t longest) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    if (at >= longest) return out + "...";
    const std::size_t length = sequenceLength(text, at);
    out += length > 0 ? shown(text.substr(at, length)) : fmt::format("\\x{:02X}", byteAt(text, at));
    at += std::max<std::size_t>(length, 1);
  }
  return out;
}

}  // namespace tubeplan::app
