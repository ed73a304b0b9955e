// The clearance kernels for this processor: the same numbers, bit for bit, some postures at a time.
#pragma once

#include <span>

#include "planner/collision/kernels/plain_cell.hpp"

namespace tubeplan::planner::kernels {

struct Kernel {
  int lanes;
  void (*nearest)(const PlainScene&, const double* frames, const FoundPairs&);
};

/// As many as deflection/revolute_chain/kernels.hpp has, of the same widths.
std::span<const Kernel> kernels();

/// The one of that width.
const Kernel& kernelOf(int lanes);

}  // namespace tubeplan::planner::kernels
