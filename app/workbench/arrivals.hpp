// Readings that came from a running arm and wait to join the others.
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

class Arrivals {
 public:
  static constexpr std::size_t kMost = 20000;  ///< with those that are there

  /// How many wait then. Ids of `known`, or that wait already, are passed over or refused. Throws InputError for these,
  /// and for too many.
  std::size_t take(std::vector<calibration::Measurement> readings, const ReadingSet* known, bool passes_known);

  [[nodiscard]] bool isEmpty() const;

  /// All that wait; none waits any more.
  [[nodiscard]] std::vector<calibration::Measurement> hand();

 private:
  mutable std::mutex mutex_;
  std::vector<calibration::Measurement> waiting_;
};

}  // namespace tubeplan::app
