// File with the tally of a campaign of simulated runs. A stopped campaign continues from the file, and a finished one
// can be extended with more runs.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>

#include "app/formats/checkpoint/checkpoint_file.hpp"
#include "app/formats/checkpoint/plan_key.hpp"
#include "app/studies/monte_carlo/run_schedule.hpp"

namespace tubeplan::app {

inline constexpr const char* kTallyFile = "tally.json";
inline constexpr CheckpointFormat kTallyFormat{"tubeplan campaign tally 2", "a file written by tubeplan campaign",
                                               "remove that file to start again"};

/// Number of runs finished so far, and the sum of their results.
struct TallySoFar {
  RunSet done;
  TallyWords total;
};

class TallyCheckpoint {
 public:
  TallyCheckpoint(std::filesystem::path folder, bool must_resume);

  /// Returns the stored tally if it was made with these inputs and has at most `runs` runs; otherwise std::nullopt.
  /// Reports on standard error which results are used. Throws InputError for a damaged file and, if the campaign must
  /// be resumed, for a missing tally or a tally with other inputs.
  [[nodiscard]] std::optional<TallySoFar> begin(const PlanKey& question, std::uint64_t runs);

  /// Writes the tally if the last write was at least a second ago, or longer ago if writing is slow; always writes if
  /// `must` is true.
  void save(const std::function<TallySoFar()>& tally, bool must);

  [[nodiscard]] std::filesystem::path path() const { return folder_ / kTallyFile; }

 private:
  using Clock = std::chrono::steady_clock;

  std::filesystem::path folder_;
  bool must_resume_;
  PlanKey question_;
  // Set in the past, so that the first results are saved at once.
  Clock::time_point saved_ = Clock::now() - std::chrono::seconds(1);
  Clock::duration pause_ = std::chrono::seconds(1);
};

}  // namespace tubeplan::app
