// The random numbers of a simulated campaign: one stream per purpose, so that changing the noise, for example, does not
// change the postures.
#pragma once

#include <boost/random/seed_seq.hpp>

#include "calibration/random_stream.hpp"

namespace tubeplan::calibration {

class CampaignRandom : public RandomStream {
 public:
  enum class Stream : std::uint32_t { kTruth = 1, kPostures, kConditions, kNoise, kSplit, kPushes, kSideChains };

  CampaignRandom(std::uint64_t seed, Stream stream) : RandomStream(sourceOf(seed, stream)) {}

 private:
  static boost::random::mt19937_64 sourceOf(std::uint64_t seed, Stream stream) {
    boost::random::seed_seq seeds(
        {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), static_cast<std::uint32_t>(stream)});
    return boost::random::mt19937_64(seeds);
  }
};

}  // namespace tubeplan::calibration
