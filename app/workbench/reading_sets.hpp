// Sets of readings for a session: read from files or text, read otherwise, and joined by others, which came from a
// running arm.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// The readings of a source, with what looks wrong with them beside what is taken to be so. The base of `cell` is not
/// known afterwards where that is said of it. Throws InputError.
[[nodiscard]] std::shared_ptr<ReadingSet> readSet(ReadingSource source, const std::string& name, Cell& cell);

/// The readings of these files for a cell, one after another. Throws InputError, also for an id that stands twice.
[[nodiscard]] std::shared_ptr<ReadingSet> openReadings(const std::vector<std::string>& files, Cell cell);

/// What was set aside or held out by hand stays so where the same readings are read again.
void keepMarks(const ReadingSet& before, ReadingSet& again);

/// Those of a set (none: null) and these as if all had come in one file: copies and mistakes show in all, and can be
/// mended. Where they cannot be read so they join as they are, and what is asked of them next says why.
[[nodiscard]] std::shared_ptr<ReadingSet> joinedSet(const ReadingSet* before,
                                                    const std::vector<calibration::Measurement>& arrived, Cell cell);

/// A set without those that joined it last.
[[nodiscard]] std::shared_ptr<ReadingSet> partedSet(const ReadingSet& joined, Cell cell);

/// How many of its readings joined the others last; copies that are counted once are not among them.
[[nodiscard]] std::size_t joinedCount(const ReadingSet& set);

/// What the readings are taken with, otherwise than their source says.
[[nodiscard]] std::vector<std::string> assumedOf(const ReadingSet& set);

/// Readings that came from a running arm and wait to join the others.
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
