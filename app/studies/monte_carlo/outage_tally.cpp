#include "app/studies/monte_carlo/outage_tally.hpp"

namespace tubeplan::app {

void ChangeTally::add(const OutageTrial& trial) {
  ++runs;
  alarms += trial.is_alarm;
  early += trial.is_early;
  named += trial.is_named;
  alone += trial.is_only_answer;
  before.add(trial.before.all_steps, trial.before.visits);
  if (trial.is_early || trial.change == 0) return;
  after.add(trial.after.all_steps, trial.after.visits);
  lost.add(trial.after.visits - trial.after.all_steps);
  if (trial.is_alarm) delays.add(trial.delay);
}

void ChangeTally::merge(const ChangeTally& other) {
  runs += other.runs;
  alarms += other.alarms;
  early += other.early;
  named += other.named;
  alone += other.alone;
  before.merge(other.before);
  after.merge(other.after);
  delays.merge(other.delays);
  lost.merge(other.lost);
}

void ChangeTally::put(TallyWords& words) const {
  words.insert(words.end(), {runs, alarms, early, named, alone});
  before.put(words);
  after.put(words);
  delays.put(words);
  lost.put(words);
}

ChangeTally ChangeTally::read(WordReader& reader) {
  ChangeTally tally;
  for (auto* count : {&tally.runs, &tally.alarms, &tally.early, &tally.named, &tally.alone}) *count = reader.next();
  tally.before = RunSums::read(reader);
  tally.after = RunSums::read(reader);
  tally.delays = CountHistogram::read(reader);
  tally.lost = CountHistogram::read(reader);
  return tally;
}

OutageTally::OutageTally() : changes_(calibration::hiddenChanges().size()) {}

void OutageTally::add(const OutageTrial& trial, std::uint64_t run) {
  failures_[static_cast<std::size_t>(trial.failure)].merge({1, run});
  if (trial.is_watched)
    changes_[static_cast<std::size_t>(trial.change)].add(trial);
  else if (trial.failure == TrialFailure::kNone)
    unwatched_.merge({1, run});
}

void OutageTally::put(TallyWords& words) const {
  words.push_back(changes_.size());
  for (const auto& failure : failures_) failure.put(words);
  unwatched_.put(words);
  for (const auto& change : changes_) change.put(words);
}

bool OutageTally::merge(const TallyWords& words) {
  WordReader reader(words);
  if (reader.next() != changes_.size()) return false;
  for (auto& failure : failures_) failure.merge(FailureCount::read(reader));
  unwatched_.merge(FailureCount::read(reader));
  for (auto& change : changes_) change.merge(ChangeTally::read(reader));
  return reader.isWhole();
}

ChangeTally OutageTally::changed() const {
  ChangeTally sum;
  for (std::size_t k = 1; k < changes_.size(); ++k) sum.merge(changes_[k]);
  return sum;
}

}  // namespace tubeplan::app
