// Measurement sets of a session: read from files or text, read again under other assumptions, and extended by
// measurements from a running arm.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// Reads a source and returns its measurements, with suspected mistakes and the assumptions made. An assumption may
/// make the base of `cell` unknown. Throws InputError.
[[nodiscard]] std::shared_ptr<MeasurementSet> readSet(MeasurementSource source, const std::string& name, Cell& cell);

/// Returns the measurements in `files`, in order. Throws InputError, also for a duplicate id.
[[nodiscard]] std::shared_ptr<MeasurementSet> openMeasurements(const std::vector<std::string>& files, Cell cell);

/// Copies the marks "set aside" and "held out" from `before` to the measurements of `after` with equal ids.
void keepMarks(const MeasurementSet& before, MeasurementSet& after);

/// Returns the measurements of `before` (null if none) and the arrived measurements, processed like one file:
/// duplicates and mistakes are detected among all measurements and can be corrected. If processing fails, the
/// measurements are merged unprocessed, and later requests report the reason.
[[nodiscard]] std::shared_ptr<MeasurementSet> joinedSet(const MeasurementSet* before,
                                                        const std::vector<calibration::Measurement>& arrived,
                                                        Cell cell);

/// Returns the set without the measurements that were added last.
[[nodiscard]] std::shared_ptr<MeasurementSet> partedSet(const MeasurementSet& joined, Cell cell);

/// Returns the number of measurements that were added last and are still in the set.
[[nodiscard]] std::size_t joinedCount(const MeasurementSet& set);

/// Returns the assumptions under which the measurements were read; empty if none were made.
[[nodiscard]] std::vector<std::string> assumedOf(const MeasurementSet& set);

/// Queue of measurements from a running arm that have not been added to the session yet.
class Arrivals {
 public:
  static constexpr std::size_t kMost = 20000;  ///< maximum number of measurements, including those loaded already

  /// Queues measurements and returns the length of the queue. Measurements whose ids are in `known` or already queued
  /// are skipped if `passes_known`, otherwise refused. Throws InputError for refused ids and for too many measurements.
  std::size_t take(std::vector<calibration::Measurement> measurements, const MeasurementSet* known, bool passes_known);

  [[nodiscard]] bool isEmpty() const;

  /// Returns all queued measurements and empties the queue.
  [[nodiscard]] std::vector<calibration::Measurement> drain();

 private:
  mutable std::mutex mutex_;
  std::vector<calibration::Measurement> waiting_;
};

}  // namespace tubeplan::app
