// A campaign's tally on disk: what a stopped campaign goes on from, and a finished one when more runs are asked for.
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
inline constexpr CheckpointFormat kTallyFormat{"tubeplan campaign tally 1", "a file written by tubeplan campaign",
                                               "remove it to start again"};

/// Which runs are done and what they come to.
struct TallySoFar {
  RunSet done;
  TallyWords total;
};

class TallyCheckpoint {
 public:
  TallyCheckpoint(std::filesystem::path folder, bool must_resume);

  /// What there is in the folder to this question, of `runs` runs at most; says on standard error what is taken up and
  /// what is not. Throws InputError for another question where one must be resumed, and for a damaged file.
  [[nodiscard]] std::optional<TallySoFar> begin(const PlanKey& question, std::uint64_t runs);

  /// Writes the tally if the last time is a second ago, or longer where writing takes long; always where it must.
  void save(const std::function<TallySoFar()>& tally, bool must);

  [[nodiscard]] std::filesystem::path path() const { return folder_ / kTallyFile; }

 private:
  using Clock = std::chrono::steady_clock;

  std::filesystem::path folder_;
  bool must_resume_;
  PlanKey question_;
  Clock::time_point saved_ = Clock::now() - std::chrono::seconds(1);  // the first chunk is kept at once
  Clock::duration pause_ = std::chrono::seconds(1);
};

}  // namespace tubeplan::app
