// Tallies as rows of 64-bit words, the form of workers' messages and checkpoints.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace tubeplan::app {

using TallyWords = std::vector<std::uint64_t>;

// Integer for sums of squares. ISO C++ has no such type, but every supported compiler has.
__extension__ using WideCount = unsigned __int128;

inline void putWide(TallyWords& words, WideCount value) {
  words.push_back(static_cast<std::uint64_t>(value >> 64));
  words.push_back(static_cast<std::uint64_t>(value));
}

/// Reader of words one after the other; missing words read as zero and are noted.
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
  /// Returns a count of items that follow, of at least one word each. A count beyond the remaining words is noted and
  /// read as zero.
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
