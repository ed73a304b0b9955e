// Tallies as sequences of 64-bit words, for messages between workers and for checkpoints.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace tubeplan::app {

using TallyWords = std::vector<std::uint64_t>;

// 128-bit integer for sums of squares. It is not part of ISO C++, but every supported compiler has it.
__extension__ using WideCount = unsigned __int128;

inline void putWide(TallyWords& words, WideCount value) {
  words.push_back(static_cast<std::uint64_t>(value >> 64));
  words.push_back(static_cast<std::uint64_t>(value));
}

/// Sequential reader of words. Missing words are read as zero and recorded.
class WordReader {
 public:
  explicit WordReader(const TallyWords& words) : words_(words) {}

  std::uint64_t next() {
    if (at_ < words_.size()) return words_[at_++];
    is_short_ = true;
    return 0;
  }
  WideCount nextWide() {
    const WideCount high = next();
    return high << 64 | next();
  }
  /// Returns the number of items that follow, each of at least one word. A number that exceeds the remaining words is
  /// read as zero and recorded.
  std::size_t nextSize() {
    const std::uint64_t size = next();
    if (size <= words_.size() - at_) return static_cast<std::size_t>(size);
    is_short_ = true;
    return 0;
  }

  /// Returns true if all words were read and none was missing.
  [[nodiscard]] bool isWhole() const { return !is_short_ && at_ == words_.size(); }
  [[nodiscard]] bool isShort() const { return is_short_; }

 private:
  const TallyWords& words_;
  std::size_t at_ = 0;
  bool is_short_ = false;
};

}  // namespace tubeplan::app
