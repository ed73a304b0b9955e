// Proposals of the next measurements, from the files of a request to results in memory: holes that place the base, and
// readings that improve the free numbers.
#pragma once

#include <vector>

#include "app/documents/touch_outcome.hpp"

namespace tubeplan::app {

/// Proposes measurements. Throws InputError for bad input.
[[nodiscard]] TouchOutcome proposeTouches(const TouchRequest& request);

/// Proposes measurements for a given cell and readings, instead of the request's files.
[[nodiscard]] TouchOutcome proposeTouches(const TouchRequest& request, const Cell& cell,
                                          const std::vector<calibration::Measurement>& readings);

}  // namespace tubeplan::app
