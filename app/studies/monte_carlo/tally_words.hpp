// Tallies as rows of 64-bit words: what workers send and checkpoints keep.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace tubeplan::app {

using TallyWords = std::vector<std::uint64_t>;

// ISO C++ has no such integer, every compiler of ours has; a sum of squares needs it.
__extension__ using WideCount = unsigned __int128;

inline void putWide(TallyWords& words, WideCount value) {
  words.push_back(static_cast<std::uint64_t>(value >> 64));
  words.push_back(static_cast<std::uint64_t>(value));
}

/// Reads words one after the other; what is not there reads as zero and is noted.
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
  /// A count of things that follow, each of one word at least: more than are there is noted and read as none.
  std::size_t nextSize() {
    const std::uint64_t size = next();
    if (size <= words_.size() - at_) return static_cast<std::size_t>(size);
    is_short_ = true;
    return 0;
  }

  /// Whether all words were read and none was missing.
  [[nodiscard]] bool isWhole() const { return !is_short_ && at_ == words_.size(); }
  [[nodiscard]] bool isShort() const { return is_short_; }

 private:
  const TallyWords& words_;
  std::size_t at_ = 0;
  bool is_short_ = false;
};

}  // namespace tubeplan::app
