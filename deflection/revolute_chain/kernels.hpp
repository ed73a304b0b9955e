// The kernels for this processor: they compute bit-identical shapes, for different numbers of postures at a time.
#pragma once

#include <span>

#include "deflection/revolute_chain/plain_rows.hpp"
#include "deflection/revolute_chain/revolute_arm.hpp"

namespace tubeplan::deflection::simd {

struct Kernel {
  int lanes;
  SolveShapes solve;
  PlaceRows place;
  MeetGoals meet;
};

/// Returns the kernels that this processor can run, narrowest first; the first has one lane, the last is the fastest.
std::span<const Kernel> kernels();

/// Returns the narrowest kernel with at least `count` lanes, or the widest kernel if no kernel has that many.
const Kernel& kernelFor(int count);

}  // namespace tubeplan::deflection::simd
