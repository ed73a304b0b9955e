// A campaign's tally on disk, from which a stopped campaign continues, and a finished one with more runs.
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
                                               "remove it to start again"};

/// Finished runs and their total.
struct TallySoFar {
  RunSet done;
  TallyWords total;
};

class TallyCheckpoint {
 public:
  TallyCheckpoint(std::filesystem::path folder, bool must_resume);

  /// Returns the tally in the folder for this question with at most `runs` runs; reports on standard error the results
  /// it uses and those it does not. Throws InputError for another question if one must be resumed, and for a damaged
  /// file.
  [[nodiscard]] std::optional<TallySoFar> begin(const PlanKey& question, std::uint64_t runs);

  /// Writes the tally if the last write was at least a second ago, or longer if writing is slow; always writes with
  /// `must`.
  void save(const std::function<TallySoFar()>& tally, bool must);

  [[nodiscard]] std::filesystem::path path() const { return folder_ / kTallyFile; }

 private:
  using Clock = std::chrono::steady_clock;

  std::filesystem::path folder_;
  bool must_resume_;
  PlanKey question_;
  Clock::time_point saved_ = Clock::now() - std::chrono::seconds(1);  // the first chunk is saved at once
  Clock::duration pause_ = std::chrono::seconds(1);
};

}  // namespace tubeplan::app
