// Random numbers that are identical on every machine.
#pragma once

#include <random>

namespace tubeplan::planner {

/// Returns the next random number in [0, 1), with 53 random bits.
inline double unitRandom(std::mt19937_64& generator) { return static_cast<double>(generator() >> 11) * 0x1.0p-53; }

/// Returns the next random number in [low, high).
inline double randomBetween(double low, double high, std::mt19937_64& generator) {
  return low + (high - low) * unitRandom(generator);
}

}  // namespace tubeplan::planner
