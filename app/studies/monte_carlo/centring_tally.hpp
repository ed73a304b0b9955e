// Results of many runs, hole by hole and in total. They are whole numbers only: tallies merged in any order are the
// same to the last bit.
#pragma once

#include <vector>

#include "app/studies/monte_carlo/centring_trial.hpp"
#include "app/studies/monte_carlo/confidence.hpp"
#include "app/studies/monte_carlo/error_sketch.hpp"

namespace tubeplan::app {

/// Results of one hole and one way of compensation.
struct HoleTally {
  ErrorSketch errors;
  std::vector<std::uint64_t> at_least;  ///< visits that took 1, 2, ... steps or more; empty if there was none
  std::uint64_t missed = 0;             ///< visits without a posture
};

/// Results of all holes and one way of compensation.
struct WayTally {
  std::vector<HoleTally> holes;
  RunSums errors;                        ///< sums in units of ErrorSketch
  std::vector<RunSums> at_least;         ///< 1, 2, ... steps or more
  std::vector<std::uint64_t> all_holes;  ///< runs in which all holes took so many

  [[nodiscard]] ErrorSketch allErrors() const;
  [[nodiscard]] std::uint64_t missed() const;
};

struct FailureCount {
  std::uint64_t runs = 0, first_run = 0;  ///< first_run: index of the first such run
};

struct SettingTally {
  std::uint64_t runs = 0;
  std::array<FailureCount, kTrialFailures> failures;  ///< counts by TrialFailure; at kNone the runs that were scored
  FailureCount misfits;  ///< scored runs whose touches do not fit, by chi-square
  std::array<WayTally, kWays.size()> ways;
};

class CentringTally {
 public:
  /// `holes`: number that may be visited; `steps`: number of the tool's.
  CentringTally(std::size_t settings, std::size_t holes, std::size_t steps);

  /// Adds the trials of one run, one for each setting.
  void add(const std::vector<Trial>& trials, std::uint64_t run);

  void put(TallyWords& words) const;

  /// Merges the words of a tally of the same shape. Returns false, with an invalid tally, if they are not.
  [[nodiscard]] bool merge(const TallyWords& words);

  [[nodiscard]] const std::vector<SettingTally>& settings() const { return settings_; }

 private:
  void addVisits(const Trial& trial, SettingTally& setting) const;

  std::size_t steps_;
  std::vector<SettingTally> settings_;
};

}  // namespace tubeplan::app
