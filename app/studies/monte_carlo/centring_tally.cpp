#include "app/studies/monte_carlo/centring_tally.hpp"

#include <algorithm>
#include <cmath>

namespace tubeplan::app {

namespace {

void putHole(std::uint64_t index, const HoleTally& hole, TallyWords& words) {
  words.push_back(index);
  hole.errors.put(words);
  words.push_back(hole.missed);
  words.push_back(hole.at_least.size());
  words.insert(words.end(), hole.at_least.begin(), hole.at_least.end());
}

bool mergeHole(WordReader& reader, std::size_t steps, std::vector<HoleTally>& holes) {
  const std::uint64_t index = reader.next();
  if (index >= holes.size()) return false;
  HoleTally& hole = holes[index];
  hole.errors.merge(ErrorSketch::read(reader));
  hole.missed += reader.next();
  const std::size_t counts = reader.nextSize();
  if (counts != 0 && counts != steps) return false;
  if (counts) hole.at_least.resize(steps, 0);
  for (std::size_t k = 0; k < counts; ++k) hole.at_least[k] += reader.next();
  return !reader.isShort();
}

void putWay(const WayTally& way, TallyWords& words) {
  way.errors.put(words);
  for (const auto& sums : way.at_least) sums.put(words);
  words.insert(words.end(), way.all_holes.begin(), way.all_holes.end());
  const auto is_used = [](const HoleTally& hole) { return hole.errors.count() > 0 || hole.missed > 0; };
  words.push_back(static_cast<std::uint64_t>(std::count_if(way.holes.begin(), way.holes.end(), is_used)));
  for (std::size_t k = 0; k < way.holes.size(); ++k)
    if (is_used(way.holes[k])) putHole(k, way.holes[k], words);
}

bool mergeWay(WordReader& reader, WayTally& way) {
  way.errors.merge(RunSums::read(reader));
  for (auto& sums : way.at_least) sums.merge(RunSums::read(reader));
  for (auto& runs : way.all_holes) runs += reader.next();
  const std::size_t used = reader.nextSize();
  for (std::size_t k = 0; k < used; ++k)
    if (!mergeHole(reader, way.at_least.size(), way.holes)) return false;
  return !reader.isShort();
}

}  // namespace

ErrorSketch WayTally::allErrors() const {
  ErrorSketch all;
  for (const auto& hole : holes) all.merge(hole.errors);
  return all;
}

std::uint64_t WayTally::missed() const {
  std::uint64_t sum = 0;
  for (const auto& hole : holes) sum += hole.missed;
  return sum;
}

CentringTally::CentringTally(std::size_t settings, std::size_t holes, std::size_t steps)
    : steps_(steps), settings_(settings) {
  for (auto& setting : settings_)
    for (auto& way : setting.ways) {
      way.holes.resize(holes);
      way.at_least.resize(steps);
      way.all_holes.resize(steps, 0);
    }
}

void CentringTally::add(const std::vector<Trial>& trials, std::uint64_t run) {
  for (std::size_t k = 0; k < trials.size(); ++k) {
    ++settings_[k].runs;
    settings_[k].failures[static_cast<std::size_t>(trials[k].failure)].merge({1, run});
    if (trials[k].is_misfit) settings_[k].misfits.merge({1, run});
    if (trials[k].failure == TrialFailure::kNone) addVisits(trials[k], settings_[k]);
  }
}

void CentringTally::addVisits(const Trial& trial, SettingTally& setting) const {
  for (std::size_t w = 0; w < kWays.size(); ++w) {
    WayTally& way = setting.ways[w];
    std::uint64_t sum = 0, count = 0;
    std::vector<std::uint64_t> at_least(steps_, 0);
    for (const auto& visit : trial.visits) {
      HoleTally& hole = way.holes[static_cast<std::size_t>(visit.hole)];
      const auto& centring = visit.centring[w];
      if (!centring || !std::isfinite(centring->error)) {
        ++hole.missed;
        continue;
      }
      const std::uint64_t units = ErrorSketch::unitsOf(centring->error);
      hole.errors.add(units);
      hole.at_least.resize(steps_, 0);
      sum += units;
      ++count;
      for (std::size_t k = 0; k < steps_ && static_cast<int>(k) < centring->steps; ++k) {
        ++hole.at_least[k];
        ++at_least[k];
      }
    }
    way.errors.add(sum, count);
    for (std::size_t k = 0; k < steps_; ++k) {
      way.at_least[k].add(at_least[k], count);
      way.all_holes[k] += at_least[k] == trial.visits.size();
    }
  }
}

void CentringTally::put(TallyWords& words) const {
  words.push_back(settings_.size());
  for (const auto& setting : settings_) {
    words.push_back(setting.runs);
    for (const auto& failure : setting.failures) failure.put(words);
    setting.misfits.put(words);
    for (const auto& way : setting.ways) putWay(way, words);
  }
}

bool CentringTally::merge(const TallyWords& words) {
  WordReader reader(words);
  if (reader.next() != settings_.size()) return false;
  for (auto& setting : settings_) {
    setting.runs += reader.next();
    for (auto& failure : setting.failures) failure.merge(FailureCount::read(reader));
    setting.misfits.merge(FailureCount::read(reader));
    for (auto& way : setting.ways)
      if (!mergeWay(reader, way)) return false;
  }
  return reader.isWhole();
}

}  // namespace tubeplan::app
