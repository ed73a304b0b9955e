#include "app/workbench/reading_sets.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "app/files/assumptions.hpp"
#include "app/files/input_error.hpp"
#include "app/files/measurements_writer.hpp"
#include "app/files/reading_input.hpp"

namespace tubeplan::app {

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

std::shared_ptr<const ReadingSet> openReadings(const std::vector<std::string>& files, Cell cell) {
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

std::shared_ptr<const ReadingSet> joinedSet(const ReadingSet* before,
                                            const std::vector<calibration::Measurement>& arrived, Cell cell) {
  ReadingSet all = before ? *before : ReadingSet();
  if (all.name.empty()) all.name = "live";
  all.readings.insert(all.readings.end(), arrived.begin(), arrived.end());
  ++all.change;
  ReadingSource source{{}, measurementsCsv(all.readings, cell.arm, cell.units), 0, {}};
  if (std::ranges::count(assumedOf(all), kAsIs) > 0) source.assumed = {kAsIs};
  try {
    auto joined = readSet(std::move(source), all.name, cell);
    keepMarks(all, *joined);
    joined->change = all.change;
    return joined;
  } catch (const InputError&) {
    all.source.reset();  // it has not all of them
    return std::make_shared<const ReadingSet>(std::move(all));
  }
}

std::vector<std::string> assumedOf(const ReadingSet& set) {
  return set.source ? set.source->assumed : std::vector<std::string>();
}

}  // namespace tubeplan::app
