// Random numbers of one run: normal values and shuffles from any source of random bits.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace tubeplan::app {

/// A source whose place is its key alone: as good as any at its first number, and free to make (Steele, Lea and Flood,
/// "Fast splittable pseudorandom number generators", OOPSLA 2014).
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

/// One key out of several numbers: a campaign's seed, the index of a run, what is drawn, of which hole.
inline std::uint64_t keyOf(std::initializer_list<std::uint64_t> numbers) {
  std::uint64_t key = 0;
  for (const std::uint64_t number : numbers) key = SplitMix::mixed(SplitMix(key ^ SplitMix::mixed(number + 1))());
  return key;
}

template <class Source>
class DrawFrom {
 public:
  explicit DrawFrom(std::uint64_t seed) : random_(seed) {}
  double normal(double sigma) { return sigma * normal_(random_); }
  Eigen::Vector3d vector(double sigma) {
    const double x = normal(sigma), y = normal(sigma), z = normal(sigma);
    return {x, y, z};
  }
  std::uint64_t seed() { return random_(); }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t k = items.size(); k > 1; --k) std::swap(items[k - 1], items[random_() % k]);
  }

  /// The first `count` items become a random choice in random order; the others are left in some order.
  template <class T>
  void choose(std::vector<T>& items, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) std::swap(items[k], items[k + random_() % (items.size() - k)]);
  }

 private:
  Source random_;
  std::normal_distribution<double> normal_{0, 1};
};

}  // namespace tubeplan::app
