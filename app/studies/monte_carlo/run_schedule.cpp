#include "app/studies/monte_carlo/run_schedule.hpp"

#include <algorithm>
#include <cassert>

namespace tubeplan::app {

void RunSet::insert(RunRange runs) {
  if (runs.first >= runs.end) return;
  auto after = std::lower_bound(ranges_.begin(), ranges_.end(), runs.first,
                                [](const RunRange& range, std::uint64_t first) { return range.first < first; });
  assert(after == ranges_.end() || runs.end <= after->first);
  assert(after == ranges_.begin() || std::prev(after)->end <= runs.first);
  if (after != ranges_.end() && after->first == runs.end) {
    runs.end = after->end;
    after = ranges_.erase(after);
  }
  if (after != ranges_.begin() && std::prev(after)->end == runs.first)
    std::prev(after)->end = runs.end;
  else
    ranges_.insert(after, runs);
}

std::uint64_t RunSet::size() const {
  std::uint64_t sum = 0;
  for (const auto& range : ranges_) sum += range.end - range.first;
  return sum;
}

RunSchedule::RunSchedule(std::uint64_t total, std::uint64_t chunk, RunSet done)
    : total_(total), chunk_(chunk), done_(std::move(done)) {
  assert(chunk > 0);
  std::uint64_t at = 0;
  for (const auto& range : done_.ranges()) {
    if (at < range.first) open_.push_back({at, range.first});
    at = range.end;
  }
  if (at < total_) open_.push_back({at, total_});
}

std::optional<RunRange> RunSchedule::next() {
  if (open_.empty()) return std::nullopt;
  RunRange& first = open_.front();
  const RunRange given{first.first, std::min(first.end, first.first + chunk_)};
  first.first = given.end;
  if (first.first == first.end) open_.pop_front();
  return given;
}

std::uint64_t chunkFor(std::uint64_t runs, std::uint64_t largest) {
  constexpr std::uint64_t kChunks = 64;
  return std::clamp<std::uint64_t>(runs / kChunks, 1, largest);
}

}  // namespace tubeplan::app
