#include "app/workbench/reading_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "app/formats/measurements/assumptions.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/formats/measurements/reading_input.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

/// Returns the readings of a set, checked as if they came from one file, with the marks of the set.
std::shared_ptr<ReadingSet> lookedAtAgain(ReadingSet set, Cell cell) {
  ReadingSource source{{}, measurementsCsv(set.readings, cell.arm, cell.units), 0, {}};
  if (std::ranges::count(assumedOf(set), kAsIs) > 0) source.assumed = {kAsIs};
  try {
    auto again = readSet(std::move(source), set.name, cell);
    keepMarks(set, *again);
    again->joined = std::move(set.joined);
    return again;
  } catch (const InputError&) {
    set.source.reset();  // the source no longer contains the same readings
    return std::make_shared<ReadingSet>(std::move(set));
  }
}

}  // namespace

std::shared_ptr<ReadingSet> readSet(ReadingSource source, const std::string& name, Cell& cell) {
  MeasurementOptions options;
  options.sigma = source.sigma;
  options.assume = source.assumed;
  auto [readings, checks] = source.files.empty() ? parseAndCheck(source.text, name, cell, options)
                                                 : readAndCheck(source.files, cell, options);
  auto set = std::make_shared<ReadingSet>();
  set->name = name;
  set->readings = std::move(readings);
  set->checks = std::move(checks);
  set->source = std::make_shared<ReadingSource>(std::move(source));
  return set;
}

std::shared_ptr<ReadingSet> openReadings(const std::vector<std::string>& files, Cell cell) {
  std::string name;
  for (const auto& file : files) name += (name.empty() ? "" : " + ") + std::filesystem::path(file).filename().string();
  return readSet({files, "", 0, {}}, name, cell);
}

void keepMarks(const ReadingSet& before, ReadingSet& again) {
  std::map<std::string, bool> held_out;
  for (const auto& reading : before.readings) held_out[reading.id] = reading.is_held_out;
  for (auto& reading : again.readings) {
    const auto known = held_out.find(reading.id);
    if (known == held_out.end()) continue;
    reading.is_held_out = known->second;
    if (before.set_aside.contains(reading.id)) again.set_aside.insert(reading.id);
  }
}

std::shared_ptr<ReadingSet> joinedSet(const ReadingSet* before, const std::vector<calibration::Measurement>& arrived,
                                      Cell cell) {
  ReadingSet all = before ? *before : ReadingSet();
  if (all.name.empty()) all.name = "live";
  all.readings.insert(all.readings.end(), arrived.begin(), arrived.end());
  all.joined.clear();
  if (before)
    for (const auto& reading : arrived) all.joined.insert(reading.id);
  return lookedAtAgain(std::move(all), std::move(cell));
}

std::shared_ptr<ReadingSet> partedSet(const ReadingSet& joined, Cell cell) {
  ReadingSet left = joined;
  std::erase_if(left.readings, [&](const auto& reading) { return joined.joined.contains(reading.id); });
  for (const auto& id : joined.joined) left.set_aside.erase(id);
  left.joined.clear();
  return lookedAtAgain(std::move(left), std::move(cell));
}

std::size_t joinedCount(const ReadingSet& set) {
  return static_cast<std::size_t>(
      std::ranges::count_if(set.readings, [&](const auto& reading) { return set.joined.contains(reading.id); }));
}

std::vector<std::string> assumedOf(const ReadingSet& set) {
  return set.source ? set.source->assumed : std::vector<std::string>();
}

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
      throw InputError::saying("id", "there is a reading " + inQuotes(reading.id) + " already",
                               "give every reading an id of its own");
  }
  if (ids.size() + fresh.size() > kMost)
    throw InputError("readings", fmt::format("{} readings", ids.size() + fresh.size()),
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
