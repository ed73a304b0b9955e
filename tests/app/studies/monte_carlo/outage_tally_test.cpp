// Tallies of outages: what counts as a false alarm, as found and as lost, and sums that do not depend on the grouping.
#include "app/studies/monte_carlo/outage_tally.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tubeplan::app {
namespace {

/// Returns the outage of a run without a change, whose watch is quiet.
OutageTrial quietTrial() {
  OutageTrial trial;
  trial.is_watched = true;
  trial.before = {100, 90};
  return trial;
}

/// Returns the outage of a run whose change is found after 3 of 20 visits.
OutageTrial foundTrial() {
  OutageTrial trial = quietTrial();
  trial.change = 1;
  trial.is_alarm = trial.is_named = true;
  trial.delay = 3;
  trial.after = {3, 1};
  return trial;
}

std::vector<OutageTrial> trialsOfAllKinds() {
  OutageTrial false_alarm = quietTrial(), early = foundTrial(), missed = foundTrial(), refused, unwatched;
  false_alarm.is_alarm = true;
  early.is_early = true;
  missed.is_alarm = missed.is_named = false;
  missed.after = {20, 5};
  refused.failure = TrialFailure::kUntouchable;
  return {quietTrial(), false_alarm, foundTrial(), early, missed, refused, unwatched};
}

TallyWords wordsOf(const OutageTally& tally) {
  TallyWords words;
  tally.put(words);
  return words;
}

TEST(OutageTally, CountsAlarmsByWhatWasHidden) {
  OutageTally tally;
  const auto trials = trialsOfAllKinds();
  for (std::size_t k = 0; k < trials.size(); ++k) tally.add(trials[k], k);
  const ChangeTally &none = tally.changes()[0], &change = tally.changes()[1];
  EXPECT_EQ(none.runs, 2u);
  EXPECT_EQ(none.alarms, 1u);
  EXPECT_EQ(none.before.count(), 200u);
  EXPECT_EQ(none.lost.count(), 0u);
  EXPECT_EQ(change.runs, 3u);
  EXPECT_EQ(change.alarms, 2u);
  EXPECT_EQ(change.early, 1u);
  EXPECT_EQ(change.delays.count(), 1u);
  EXPECT_EQ(change.delays.quantile(0.5), 3);
  EXPECT_EQ(change.lost.count(), 2u);
  EXPECT_EQ(change.lost.quantile(0.5), 2);
  EXPECT_EQ(change.lost.quantile(0.9), 15);
  EXPECT_EQ(tally.failures()[static_cast<std::size_t>(TrialFailure::kUntouchable)].first_run, 5u);
  EXPECT_EQ(tally.unwatched().first_run, 6u);
  EXPECT_EQ(tally.changed(), change);
}

TEST(OutageTally, MergesToTheSameBytesInAnyGrouping) {
  OutageTally sequential, forward, backward;
  std::vector<TallyWords> parts;
  const auto trials = trialsOfAllKinds();
  for (std::uint64_t k = 0; k < trials.size(); ++k) {
    OutageTally part;
    part.add(trials[k], k);
    sequential.add(trials[k], k);
    parts.push_back(wordsOf(part));
  }
  for (std::size_t k = 0; k < parts.size(); ++k) {
    EXPECT_TRUE(forward.merge(parts[k]));
    EXPECT_TRUE(backward.merge(parts[parts.size() - 1 - k]));
  }
  EXPECT_EQ(wordsOf(sequential), wordsOf(forward));
  EXPECT_EQ(wordsOf(sequential), wordsOf(backward));
}

TEST(OutageTally, RefusesWordsThatAreMissing) {
  TallyWords words = wordsOf(OutageTally());
  words.pop_back();
  OutageTally tally;
  EXPECT_FALSE(tally.merge(words));
}

TEST(CountHistogram, GivesQuantilesThatItsValuesReach) {
  CountHistogram counts;
  EXPECT_TRUE(std::isnan(counts.quantile(0.5)));
  EXPECT_TRUE(std::isnan(counts.mean()));
  for (const std::size_t value : {4u, 0u, 4u, 9u}) counts.add(value);
  EXPECT_EQ(counts.quantile(0.25), 0);
  EXPECT_EQ(counts.quantile(0.5), 4);
  EXPECT_EQ(counts.quantile(1), 9);
  EXPECT_EQ(counts.mean(), 17. / 4);
}

}  // namespace
}  // namespace tubeplan::app
