// Sets of readings for a session: read from files or text, read again with other assumptions, and extended by readings
// from a running arm.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// Returns the readings of a source, with the suspected mistakes and the assumptions made. An assumption may make the
/// base of `cell` unknown. Throws InputError.
[[nodiscard]] std::shared_ptr<ReadingSet> readSet(ReadingSource source, const std::string& name, Cell& cell);

/// Returns the readings of these files for a cell, in their order. Throws InputError, also for a duplicate id.
[[nodiscard]] std::shared_ptr<ReadingSet> openReadings(const std::vector<std::string>& files, Cell cell);

/// Copies the marks "set aside" and "held out" from `before` to the same readings of `again`.
void keepMarks(const ReadingSet& before, ReadingSet& again);

/// Returns the readings of a set (null: none) and these, processed as one file: duplicates and mistakes are detected in
/// all of them, and can be mended. If that is impossible, they are joined unprocessed, and later requests on them give
/// the reason.
[[nodiscard]] std::shared_ptr<ReadingSet> joinedSet(const ReadingSet* before,
                                                    const std::vector<calibration::Measurement>& arrived, Cell cell);

/// Returns a set without the readings that joined it last.
[[nodiscard]] std::shared_ptr<ReadingSet> partedSet(const ReadingSet& joined, Cell cell);

/// Returns the number of readings that joined last, without duplicates that count once.
[[nodiscard]] std::size_t joinedCount(const ReadingSet& set);

/// Returns the assumptions about the readings that differ from their source.
[[nodiscard]] std::vector<std::string> assumedOf(const ReadingSet& set);

/// Queue of readings from a running arm that wait to join the others.
class Arrivals {
 public:
  static constexpr std::size_t kMost = 20000;  ///< including the existing readings

  /// Queues readings and returns the number queued. Ids that are in `known` or already queued are skipped or refused.
  /// Throws InputError for these, and for too many.
  std::size_t take(std::vector<calibration::Measurement> readings, const ReadingSet* known, bool passes_known);

  [[nodiscard]] bool isEmpty() const;

  /// Returns all queued readings and empties the queue.
  [[nodiscard]] std::vector<calibration::Measurement> hand();

 private:
  mutable std::mutex mutex_;
  std::vector<calibration::Measurement> waiting_;
};

}  // namespace tubeplan::app
