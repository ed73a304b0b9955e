// A hash of numbers and strings that is the same on every machine.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace tubeplan::tubesheets {

/// 64-bit FNV-1a hash. Numbers are added byte by byte, the least significant first, so that the hash does not depend on
/// the byte order of the machine.
class Fingerprint {
 public:
  void add(std::int64_t number) {
    for (int byte = 0; byte < 8; ++byte)
      addByte(static_cast<std::uint8_t>(static_cast<std::uint64_t>(number) >> (8 * byte)));
  }
  void add(std::string_view text) {
    addBytes(text);
    addByte(0);
  }
  /// Adds bytes without a terminator: adding "ab" and then "c" gives the same hash as adding "a" and then "bc".
  void addBytes(std::string_view bytes) {
    for (const char c : bytes) addByte(static_cast<std::uint8_t>(c));
  }
  void addLength(double metres) {
    add(std::isfinite(metres) ? std::llround(std::clamp(metres, -1e6, 1e6) * 1e9) : INT64_MIN);
  }

  /// Returns the hash as 16 hexadecimal digits.
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  void addByte(std::uint8_t byte) { hash_ = (hash_ ^ byte) * 0x100000001b3ULL; }

  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

}  // namespace tubeplan::tubesheets
