// Results of many runs, for each hole and in total. All results are sums of integers, so that tallies merged in any
// order are identical.
#pragma once

#include <vector>

#include "app/studies/monte_carlo/centring_trial.hpp"
#include "app/studies/monte_carlo/confidence.hpp"
#include "app/studies/monte_carlo/error_sketch.hpp"
#include "app/studies/monte_carlo/failure_count.hpp"

namespace tubeplan::app {

/// Results at one hole with one compensation method.
struct HoleTally {
  ErrorSketch errors;
  /// Number of visits in which at least k + 1 steps entered, at index k; empty without visits.
  std::vector<std::uint64_t> at_least;
  std::uint64_t missed = 0;  ///< number of visits without a posture
};

/// Results at all holes with one compensation method.
struct WayTally {
  std::vector<HoleTally> holes;
  RunSums errors;                 ///< sums of centring errors, in units of ErrorSketch::kUnit
  std::vector<RunSums> at_least;  ///< number of visits in which at least k + 1 steps entered, at index k
  /// Number of runs in which at least k + 1 steps entered every visited hole, at index k.
  std::vector<std::uint64_t> all_holes;

  [[nodiscard]] ErrorSketch allErrors() const;
  [[nodiscard]] std::uint64_t missed() const;
};

struct SettingTally {
  std::uint64_t runs = 0;
  std::array<FailureCount, kTrialFailures> failures;  ///< indexed by TrialFailure; kNone counts the scored runs
  FailureCount misfits;                               ///< scored runs whose touches the chi-square test rejects
  std::array<WayTally, kWays.size()> ways;
};

class CentringTally {
 public:
  /// Creates an empty tally for this number of settings, of holes that may be visited and of steps of the tool.
  CentringTally(std::size_t settings, std::size_t holes, std::size_t steps);

  /// Adds the trials of the run with index `run`, one for each setting.
  void add(const std::vector<Trial>& trials, std::uint64_t run);

  void put(TallyWords& words) const;

  /// Merges a tally written by put(). Returns false if its dimensions differ or words are missing; this tally is then
  /// invalid.
  [[nodiscard]] bool merge(const TallyWords& words);

  [[nodiscard]] const std::vector<SettingTally>& settings() const { return settings_; }

 private:
  void addVisits(const Trial& trial, SettingTally& setting) const;

  std::size_t steps_;
  std::vector<SettingTally> settings_;
};

}  // namespace tubeplan::app
