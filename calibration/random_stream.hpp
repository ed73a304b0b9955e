// Portable random numbers, selections and shuffles: identical on every machine and with every standard library.
#pragma once

#include <Eigen/Core>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cstdint>
#include <utility>
#include <vector>

namespace tubeplan::calibration {

template <class Source>
class RandomStreamFrom {
 public:
  explicit RandomStreamFrom(const Source& source) : source_(source) {}
  explicit RandomStreamFrom(std::uint64_t seed) : source_(seed) {}

  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * share_(source_); }
  [[nodiscard]] double normal(double sigma) { return sigma * normal_(source_); }
  [[nodiscard]] Eigen::Vector3d vector(double sigma) {
    const double x = normal(sigma), y = normal(sigma), z = normal(sigma);
    return {x, y, z};
  }

  /// Returns a random integer from 0 to count - 1.
  [[nodiscard]] int index(int count) { return boost::random::uniform_int_distribution<int>(0, count - 1)(source_); }

  /// Returns a seed for another stream.
  [[nodiscard]] std::uint64_t seed() { return source_(); }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t k = items.size(); k > 1; --k) std::swap(items[k - 1], items[below(k)]);
  }

  /// Reorders `items` so that the first `count` are a random selection in random order; the order of the others is
  /// arbitrary.
  template <class T>
  void choose(std::vector<T>& items, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) std::swap(items[k], items[k + below(items.size() - k)]);
  }

 private:
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(index(static_cast<int>(count))); }

  Source source_;
  boost::random::uniform_01<double> share_;
  boost::random::normal_distribution<double> normal_;
};

using RandomStream = RandomStreamFrom<boost::random::mt19937_64>;

}  // namespace tubeplan::calibration
