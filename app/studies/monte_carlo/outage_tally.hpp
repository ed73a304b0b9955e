// Results of many outages, for each hidden change. All results are sums of integers, so that tallies merged in any
// order are identical.
#pragma once

#include <array>
#include <vector>

#include "app/studies/monte_carlo/confidence.hpp"
#include "app/studies/monte_carlo/count_histogram.hpp"
#include "app/studies/monte_carlo/failure_count.hpp"
#include "app/studies/monte_carlo/outage_trial.hpp"

namespace tubeplan::app {

/// Results of the watched outages with one hidden change, or without any.
struct ChangeTally {
  std::uint64_t runs = 0;
  std::uint64_t alarms = 0;  ///< all alarms; of outages without a change, the false ones
  std::uint64_t early = 0;   ///< alarms before the change
  std::uint64_t named = 0;   ///< alarms after the change whose answers contain the true cause with its course
  std::uint64_t alone = 0;   ///< those without any other answer
  RunSums before, after;     ///< visits in which all steps entered, of all counted ones, before and after the change
  CountHistogram delays;     ///< visits from the change to the alarm, of each outage with an alarm after the change
  CountHistogram lost;  ///< visits after the change and up to the alarm in which not all steps entered, of each outage

  void add(const OutageTrial& trial);
  void merge(const ChangeTally& other);
  void put(TallyWords& words) const;
  static ChangeTally read(WordReader& reader);

  bool operator==(const ChangeTally&) const = default;
};

class OutageTally {
 public:
  OutageTally();

  /// Adds the outage of the run with index `run`.
  void add(const OutageTrial& trial, std::uint64_t run);

  void put(TallyWords& words) const;

  /// Merges a tally written by put(). Returns false if its dimensions differ or words are missing; this tally is then
  /// invalid.
  [[nodiscard]] bool merge(const TallyWords& words);

  /// Runs that were not calibrated, indexed by TrialFailure; kNone counts the calibrated runs.
  [[nodiscard]] const std::array<FailureCount, kTrialFailures>& failures() const { return failures_; }
  [[nodiscard]] const FailureCount& unwatched() const { return unwatched_; }  ///< calibrated runs without a watch

  /// Returns the results for each row of hiddenChanges().
  [[nodiscard]] const std::vector<ChangeTally>& changes() const { return changes_; }
  /// Returns the results for all outages with a change.
  [[nodiscard]] ChangeTally changed() const;

 private:
  std::array<FailureCount, kTrialFailures> failures_;
  FailureCount unwatched_;
  std::vector<ChangeTally> changes_;
};

}  // namespace tubeplan::app
