// Readings predicted one by one, on all cores.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>

#include "calibration/hooks.hpp"
#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

/// Calls `each(predictor, k)` for every reading, on all cores; false as soon as one call is, or where it was asked to
/// stop.
template <class Each>
bool predictAll(const PlacedArm& placed, std::size_t readings, const StopQuestion& stop, const Each& each) {
  constexpr std::size_t kAtOnce = 16;  // readings that share what is prepared of the arm
  std::atomic<bool> ok = true;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, readings, kAtOnce), [&](const auto& range) {
    if (shouldStop(stop)) ok = false;
    if (!ok) return;
    ReadingPredictor predictor(placed.arm);
    for (std::size_t k = range.begin(); k != range.end(); ++k)
      if (!each(predictor, k)) ok = false;
  });
  return ok;
}

}  // namespace tubeplan::calibration
