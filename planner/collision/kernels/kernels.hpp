// The clearance kernels for this processor: the same numbers, bit for bit, for several postures at a time.
#pragma once

#include <span>

#include "planner/collision/kernels/plain_cell.hpp"

namespace tubeplan::planner::kernels {

struct Kernel {
  int lanes;
  void (*nearest)(const PlainScene&, const double* frames, const FoundPairs&);
};

/// Returns the kernels, as many as deflection/revolute_chain/kernels.hpp has and of the same widths.
std::span<const Kernel> kernels();

/// Returns the kernel of that width.
const Kernel& kernelOf(int lanes);

}  // namespace tubeplan::planner::kernels
