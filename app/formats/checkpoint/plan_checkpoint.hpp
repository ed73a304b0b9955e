// The files that keep what a plan found out: progress.json while it is made, memory.json beside the plan that came of
// it. Two lines: the question with a checksum, and the memory.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "app/formats/checkpoint/plan_key.hpp"
#include "planner/plan_cache.hpp"

namespace tubeplan::app {

inline constexpr const char* kProgressFile = "progress.json";
inline constexpr const char* kCacheFile = "memory.json";

class PlanCheckpoint {
 public:
  /// `folder` is where the plan is made. `from`: the folder of an earlier plan, or empty. Throws InputError where that
  /// has no memory, or a damaged one.
  PlanCheckpoint(std::filesystem::path folder, bool must_resume, const std::string& from);

  /// Of the plan to begin from; empty without.
  [[nodiscard]] const std::string& fromFingerprint() const { return from_fingerprint_; }

  /// Takes up what there is to this question: a stopped plan in the folder, else the earlier plan's memory; says on
  /// standard error what it takes up and what it does not. Throws
  /// InputError for a stopped plan of another question where one must be resumed, and for an earlier plan of another
  /// sheet.
  void begin(const PlanKey& question);

  [[nodiscard]] planner::PlanCache& cache() { return cache_; }

  /// Writes progress.json if the last time is half a second ago, or longer where writing takes long.
  void saveNowAndThen();
  void save();

  /// Removes progress.json: the question has its answer.
  void discard();

  /// "the reach of 312 tubes, 40 travels and 80 proofs"; empty where there is nothing.
  [[nodiscard]] std::string summary() const;

  /// What memory.json is to hold.
  [[nodiscard]] std::string text() const;

 private:
  using Clock = std::chrono::steady_clock;

  void takeFrom(const PlanKey& question);
  [[nodiscard]] bool takeStopped(const PlanKey& question);
  [[nodiscard]] bool takeDone(const PlanKey& question);

  std::filesystem::path folder_;
  bool must_resume_;
  std::string from_, from_fingerprint_;
  PlanKey from_question_, question_;
  planner::PlanCache from_cache_, cache_;
  Clock::time_point saved_ = Clock::now();
  Clock::duration pause_ = std::chrono::milliseconds(500);
};

}  // namespace tubeplan::app
