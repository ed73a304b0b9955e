#include "app/workbench/measurement_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "app/formats/measurements/assumptions.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

/// Returns the measurements of a set, checked as if they came from one file, with the marks of the set.
std::shared_ptr<MeasurementSet> checkedAgain(MeasurementSet set, Cell cell) {
  MeasurementSource source{{}, measurementsCsv(set.measurements, cell.arm, cell.units), 0, {}};
  if (std::ranges::count(assumedOf(set), kAsIs) > 0) source.assumed = {kAsIs};
  try {
    auto again = readSet(std::move(source), set.name, cell);
    keepMarks(set, *again);
    again->joined = std::move(set.joined);
    return again;
  } catch (const InputError&) {
    set.source.reset();  // the source no longer matches the measurements
    return std::make_shared<MeasurementSet>(std::move(set));
  }
}

}  // namespace

std::shared_ptr<MeasurementSet> readSet(MeasurementSource source, const std::string& name, Cell& cell) {
  MeasurementOptions options;
  options.sigma = source.sigma;
  options.assume = source.assumed;
  auto [measurements, checks] = source.files.empty() ? parseAndCheck(source.text, name, cell, options)
                                                     : readAndCheck(source.files, cell, options);
  auto set = std::make_shared<MeasurementSet>();
  set->name = name;
  set->measurements = std::move(measurements);
  set->checks = std::move(checks);
  set->source = std::make_shared<MeasurementSource>(std::move(source));
  return set;
}

std::shared_ptr<MeasurementSet> openMeasurements(const std::vector<std::string>& files, Cell cell) {
  std::string name;
  for (const auto& file : files) name += (name.empty() ? "" : " + ") + std::filesystem::path(file).filename().string();
  return readSet({files, "", 0, {}}, name, cell);
}

void keepMarks(const MeasurementSet& before, MeasurementSet& after) {
  std::map<std::string, bool> held_out;
  for (const auto& measurement : before.measurements) held_out[measurement.id] = measurement.is_held_out;
  for (auto& measurement : after.measurements) {
    const auto known = held_out.find(measurement.id);
    if (known == held_out.end()) continue;
    measurement.is_held_out = known->second;
    if (before.set_aside.contains(measurement.id)) after.set_aside.insert(measurement.id);
  }
}

std::shared_ptr<MeasurementSet> joinedSet(const MeasurementSet* before,
                                          const std::vector<calibration::Measurement>& arrived, Cell cell) {
  MeasurementSet all = before ? *before : MeasurementSet();
  if (all.name.empty()) all.name = "live";
  all.measurements.insert(all.measurements.end(), arrived.begin(), arrived.end());
  all.joined.clear();
  if (before)
    for (const auto& measurement : arrived) all.joined.insert(measurement.id);
  return checkedAgain(std::move(all), std::move(cell));
}

std::shared_ptr<MeasurementSet> partedSet(const MeasurementSet& joined, Cell cell) {
  MeasurementSet remaining = joined;
  std::erase_if(remaining.measurements,
                [&](const auto& measurement) { return joined.joined.contains(measurement.id); });
  for (const auto& id : joined.joined) remaining.set_aside.erase(id);
  remaining.joined.clear();
  return checkedAgain(std::move(remaining), std::move(cell));
}

std::size_t joinedCount(const MeasurementSet& set) {
  return static_cast<std::size_t>(std::ranges::count_if(
      set.measurements, [&](const auto& measurement) { return set.joined.contains(measurement.id); }));
}

std::vector<std::string> assumedOf(const MeasurementSet& set) {
  return set.source ? set.source->assumed : std::vector<std::string>();
}

std::size_t Arrivals::take(std::vector<calibration::Measurement> measurements, const MeasurementSet* known,
                           bool passes_known) {
  const std::lock_guard lock(mutex_);
  std::set<std::string> ids;
  if (known)
    for (const auto& measurement : known->measurements) ids.insert(measurement.id);
  for (const auto& measurement : waiting_) ids.insert(measurement.id);
  std::vector<calibration::Measurement> fresh;
  for (auto& measurement : measurements) {
    if (!ids.contains(measurement.id))
      fresh.push_back(std::move(measurement));
    else if (!passes_known)
      throw InputError::problem("id", "there is a reading " + inQuotes(measurement.id) + " already",
                                "give every reading an id of its own");
  }
  if (ids.size() + fresh.size() > kMost)
    throw InputError("readings", fmt::format("{} readings", ids.size() + fresh.size()),
                     fmt::format("at most {} in the workbench", kMost));
  for (auto& measurement : fresh) waiting_.push_back(std::move(measurement));
  return waiting_.size();
}

bool Arrivals::isEmpty() const {
  const std::lock_guard lock(mutex_);
  return waiting_.empty();
}

std::vector<calibration::Measurement> Arrivals::drain() {
  const std::lock_guard lock(mutex_);
  return std::exchange(waiting_, {});
}

}  // namespace tubeplan::app
