// The random numbers of a simulated campaign: the same on every machine, and one stream for each purpose, so that more
// noise or another arm does not mean another series of postures.
#pragma once

#include <Eigen/Core>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/seed_seq.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cstdint>
#include <utility>
#include <vector>

namespace tubeplan::calibration {

class CampaignRandom {
 public:
  enum class Stream : std::uint32_t { kTruth = 1, kPostures, kConditions, kNoise, kSplit };

  CampaignRandom(std::uint64_t seed, Stream stream) {
    boost::random::seed_seq seeds(
        {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), static_cast<std::uint32_t>(stream)});
    engine_.seed(seeds);
  }

  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * share_(engine_); }
  [[nodiscard]] double normal(double sigma) { return sigma * normal_(engine_); }
  [[nodiscard]] Eigen::Vector3d vector(double sigma) {
    const double x = normal(sigma), y = normal(sigma), z = normal(sigma);
    return {x, y, z};
  }

  /// 0 ... count - 1.
  [[nodiscard]] int index(int count) { return boost::random::uniform_int_distribution<int>(0, count - 1)(engine_); }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t k = items.size(); k > 1; --k) std::swap(items[k - 1], items[index(static_cast<int>(k))]);
  }

 private:
  boost::random::mt19937_64 engine_;
  boost::random::uniform_01<double> share_;
  boost::random::normal_distribution<double> normal_;
};

}  // namespace tubeplan::calibration
