// The clearance kernels that this processor supports. All return bitwise identical results; they differ in the number
// of postures that they compute at a time.
#pragma once

#include <span>

#include "planner/collision/kernels/plain_cell.hpp"

namespace tubeplan::planner::kernels {

struct Kernel {
  int lanes;
  void (*nearest)(const PlainScene&, const double* frames, const FoundPairs&);
};

/// Returns the clearance kernels, with the same lane counts as the kernels of deflection/revolute_chain/kernels.hpp.
std::span<const Kernel> kernels();

/// Returns the kernel with the given number of lanes, which must be one of those in kernels().
const Kernel& kernelOf(int lanes);

}  // namespace tubeplan::planner::kernels
