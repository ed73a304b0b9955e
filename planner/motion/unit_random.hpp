// Numbers by chance that are the same on every machine.
#pragma once

#include <random>

namespace tubeplan::planner {

/// The next number in [0, 1), with 53 random bits.
inline double unitRandom(std::mt19937_64& generator) { return static_cast<double>(generator() >> 11) * 0x1.0p-53; }

}  // namespace tubeplan::planner
