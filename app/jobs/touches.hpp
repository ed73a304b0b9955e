// What to measure next, from files named in a request to proposals in memory: holes that place the base, and readings
// that sharpen the free numbers.
#pragma once

#include <vector>

#include "app/documents/touch_outcome.hpp"

namespace tubeplan::app {

/// Throws InputError for bad input.
[[nodiscard]] TouchOutcome proposeTouches(const TouchRequest& request);

/// The same for a cell and readings at hand, in the place of the request's files.
[[nodiscard]] TouchOutcome proposeTouches(const TouchRequest& request, const Cell& cell,
                                          const std::vector<calibration::Measurement>& readings);

}  // namespace tubeplan::app
