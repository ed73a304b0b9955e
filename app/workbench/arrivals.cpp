#include "app/workbench/arrivals.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "app/files/input_error.hpp"

namespace tubeplan::app {

std::size_t Arrivals::take(std::vector<calibration::Measurement> readings, const ReadingSet* known, bool passes_known) {
  const std::lock_guard lock(mutex_);
  std::set<std::string> ids;
  if (known)
    for (const auto& reading : known->readings) ids.insert(reading.id);
  for (const auto& reading : waiting_) ids.insert(reading.id);
  std::vector<calibration::Measurement> fresh;
  for (auto& reading : readings) {
    if (!ids.contains(reading.id))
      fresh.push_back(std::move(reading));
    else if (!passes_known)
      throw InputError("id", inQuotes(reading.id), "one that no reading has yet");
  }
  if (ids.size() + fresh.size() > kMost)
    throw InputError("readings", fmt::format("{}", ids.size() + fresh.size()),
                     fmt::format("at most {} in the workbench", kMost));
  for (auto& reading : fresh) waiting_.push_back(std::move(reading));
  return waiting_.size();
}

bool Arrivals::isEmpty() const {
  const std::lock_guard lock(mutex_);
  return waiting_.empty();
}

std::vector<calibration::Measurement> Arrivals::hand() {
  const std::lock_guard lock(mutex_);
  return std::exchange(waiting_, {});
}

}  // namespace tubeplan::app
