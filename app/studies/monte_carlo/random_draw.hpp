// Random number generator for one run among many, determined by a key.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>

#include "calibration/random_stream.hpp"

namespace tubeplan::app {

/// Random bit generator whose whole state is a 64-bit key. It is cheap to create and needs no warm-up (Steele, Lea and
/// Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014).
class SplitMix {
 public:
  using result_type = std::uint64_t;
  explicit SplitMix(std::uint64_t key) : state_(key) {}
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }
  result_type operator()() { return mixed(state_ += kStep); }

  static constexpr result_type mixed(result_type z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

 private:
  static constexpr result_type kStep = 0x9e3779b97f4a7c15ULL;
  result_type state_;
};

/// Combines several numbers into one key, such as a campaign's seed, the index of a run, the drawn quantity and the
/// hole.
inline std::uint64_t keyOf(std::initializer_list<std::uint64_t> numbers) {
  std::uint64_t key = 0;
  for (const std::uint64_t number : numbers) key = SplitMix::mixed(SplitMix(key ^ SplitMix::mixed(number + 1))());
  return key;
}

}  // namespace tubeplan::app
