// Reading sets of a session: read from files or text, read again under other assumptions, and extended by readings from
// a running arm.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// Reads a source and returns its readings, with suspected mistakes and the assumptions made. An assumption may make
/// the base of `cell` unknown. Throws InputError.
[[nodiscard]] std::shared_ptr<ReadingSet> readSet(ReadingSource source, const std::string& name, Cell& cell);

/// Returns the readings in `files`, in order. Throws InputError, also for a duplicate id.
[[nodiscard]] std::shared_ptr<ReadingSet> openReadings(const std::vector<std::string>& files, Cell cell);

/// Copies the marks "set aside" and "held out" from `before` to the readings of `again` with equal ids.
void keepMarks(const ReadingSet& before, ReadingSet& again);

/// Returns the readings of `before` (null: none) and the arrived readings, processed like one file: duplicates and
/// mistakes are detected among all readings and can be corrected. If processing fails, the readings are merged
/// unprocessed, and later requests report the reason.
[[nodiscard]] std::shared_ptr<ReadingSet> joinedSet(const ReadingSet* before,
                                                    const std::vector<calibration::Measurement>& arrived, Cell cell);

/// Returns the set without the readings that were added last.
[[nodiscard]] std::shared_ptr<ReadingSet> partedSet(const ReadingSet& joined, Cell cell);

/// Returns the number of readings that were added last and are still in the set.
[[nodiscard]] std::size_t joinedCount(const ReadingSet& set);

/// Returns the assumptions under which the readings were read; empty if none were made.
[[nodiscard]] std::vector<std::string> assumedOf(const ReadingSet& set);

/// Queue of readings from a running arm that have not been added to the session yet.
class Arrivals {
 public:
  static constexpr std::size_t kMost = 20000;  ///< maximum number of readings, including those loaded already

  /// Queues readings and returns the length of the queue. Readings whose ids are in `known` or already queued are
  /// skipped if `passes_known`, otherwise refused. Throws InputError for refused ids and for too many readings.
  std::size_t take(std::vector<calibration::Measurement> readings, const ReadingSet* known, bool passes_known);

  [[nodiscard]] bool isEmpty() const;

  /// Returns all queued readings and empties the queue.
  [[nodiscard]] std::vector<calibration::Measurement> hand();

 private:
  mutable std::mutex mutex_;
  std::vector<calibration::Measurement> waiting_;
};

}  // namespace tubeplan::app
