// Files with intermediate results of a plan: progress.json during planning, memory.json next to the finished plan. Both
// have two lines: the inputs of the plan with checksums, and the results.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "app/formats/checkpoint/plan_cache_text.hpp"
#include "app/formats/checkpoint/plan_key.hpp"
#include "planner/plan_cache.hpp"

namespace tubeplan::app {

inline constexpr const char* kProgressFile = "progress.json";
inline constexpr const char* kCacheFile = "memory.json";

class PlanCheckpoint {
 public:
  /// Prepares the cache of a plan in `folder`; `from` is the folder of an earlier plan, or empty. If `folder` is empty,
  /// nothing is saved during planning, and no stopped plan is continued. Throws InputError if memory.json of the
  /// earlier plan is missing or damaged.
  PlanCheckpoint(std::filesystem::path folder, bool must_resume, const std::string& from);

  /// Returns the fingerprint of memory.json of the earlier plan; empty if there is no earlier plan.
  [[nodiscard]] const std::string& fromFingerprint() const { return from_fingerprint_; }

  /// Returns true if intermediate results are to be saved during planning.
  [[nodiscard]] bool savesProgress() const { return !folder_.empty(); }

  /// Returns the posture in which the earlier plan visits a tube (index in the sheet); std::nullopt if it does not, or
  /// if there is no earlier plan.
  [[nodiscard]] std::optional<Eigen::VectorXd> postureAt(int tube) const;

  /// Loads the results for these inputs and tubes (indices in the sheet) from a stopped plan in the folder, otherwise
  /// from the earlier plan. Reports on standard error which results are used and which are not. Throws InputError for a
  /// stopped plan with other inputs if the plan must be resumed, and for an earlier plan of another sheet.
  void begin(const PlanKey& question, const std::vector<int>& tubes);

  [[nodiscard]] planner::PlanCache& cache() { return cache_; }

  /// Returns the differences from the earlier plan's inputs because of which only its order is reused; set by begin().
  [[nodiscard]] const std::vector<std::string>& modelDifferences() const { return model_differences_; }

  /// Writes progress.json if the last write was at least half a second ago, or longer ago if writing is slow.
  void saveNowAndThen();
  void save();

  /// Removes progress.json, after the plan is complete.
  void discard();

  /// Returns a summary of the results, "the reach of 312 tubes, 40 travels and 80 proofs"; empty if there are no
  /// results.
  [[nodiscard]] std::string summary() const;

  /// Returns the text of memory.json.
  [[nodiscard]] std::string text() const;

 private:
  using Clock = std::chrono::steady_clock;

  void takeFrom(const PlanKey& question, const std::vector<int>& tubes);
  [[nodiscard]] bool takeStopped(const PlanKey& question);
  [[nodiscard]] bool takeDone(const PlanKey& question);

  std::filesystem::path folder_;
  bool must_resume_;
  std::string from_, from_fingerprint_;
  PlanKey from_question_, question_;
  PlanCacheText from_text_;  ///< results of the earlier plan
  PlanCacheText text_;       ///< results of the earlier plan that are still valid, for all its tubes
  planner::PlanCache cache_;
  std::vector<std::string> model_differences_;
  Clock::time_point saved_ = Clock::now();
  Clock::duration pause_ = std::chrono::milliseconds(500);
};

}  // namespace tubeplan::app
