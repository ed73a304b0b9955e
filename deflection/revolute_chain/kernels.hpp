// The kernels for this processor: the same shapes, bit for bit, for several postures at a time.
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

/// Returns the kernels that this processor can run, narrow ones first; the first has one lane, the last is the fastest.
std::span<const Kernel> kernels();

/// Returns the narrowest kernel that takes `count` at once, or the widest.
const Kernel& kernelFor(int count);

}  // namespace tubeplan::deflection::simd
