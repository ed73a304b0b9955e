// Proposals of further measurements: holes to touch for calibrating the base, and measurements that improve the free
// parameters.
#pragma once

#include <vector>

#include "app/documents/touch_outcome.hpp"

namespace tubeplan::app {

/// Proposes measurements from the files named in the request. Throws InputError for bad input.
[[nodiscard]] TouchOutcome proposeTouches(const TouchRequest& request);

/// Proposes measurements for the given cell and measurements; the request's files are not read.
[[nodiscard]] TouchOutcome proposeTouches(const TouchRequest& request, const Cell& cell,
                                          const std::vector<calibration::Measurement>& measurements);

}  // namespace tubeplan::app
