// Readings predicted on all cores.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>

#include "calibration/hooks.hpp"
#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

/// Calls `each(first, count)` for blocks of readings, on all cores; false as soon as one call is, or where it was asked
/// to stop.
template <class Each>
bool inBlocks(std::size_t readings, std::size_t at_once, const StopQuestion& stop, const Each& each) {
  std::atomic<bool> ok = true;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, readings, at_once), [&](const auto& range) {
    if (ok && (shouldStop(stop) || !each(range.begin(), range.size()))) ok = false;
  });
  return ok;
}

/// Calls `each(predictor, k)` for every reading; false as soon as one call is, or where it was asked to stop.
template <class Each>
bool predictAll(const PlacedArm& placed, std::size_t readings, const StopQuestion& stop, const Each& each) {
  constexpr std::size_t kAtOnce = 16;  // readings that share what is prepared of the arm
  return inBlocks(readings, kAtOnce, stop, [&](std::size_t first, std::size_t count) {
    ReadingPredictor predictor(placed.arm);
    for (std::size_t k = first; k < first + count; ++k)
      if (!each(predictor, k)) return false;
    return true;
  });
}

}  // namespace tubeplan::calibration
