// A plan's cache as text: entries are parsed only on request, and are otherwise written back unchanged.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "planner/plan_cache.hpp"

namespace tubeplan::app {

class PlanCacheText {
 public:
  PlanCacheText() = default;

  /// Divides the JSON of cacheJson() into its entries. Throws nlohmann::json::exception for any other text.
  explicit PlanCacheText(const std::string& json);

  /// Returns the entries of the given tubes and of travels between them, and all data not tied to a single tube. A
  /// travel from or to a start or end posture counts as one of its tube. Throws nlohmann::json::exception for an entry
  /// that cacheJson() does not write.
  [[nodiscard]] planner::PlanCache read(const std::set<int>& tubes) const;

  /// Returns the whole cache.
  [[nodiscard]] planner::PlanCache readAll() const;

  /// Returns the tubes in the order of the last completed plan.
  [[nodiscard]] std::vector<int> visitingOrder() const;

  /// Removes the entries of travels from and to start and end postures.
  void dropEnds();

  /// Returns the JSON of `cache`, with the entries that only this text has. Common entries are taken from this text.
  [[nodiscard]] std::string with(const planner::PlanCache& cache) const;

 private:
  std::map<int, std::string> reach_;
  std::map<planner::MotionEnds, std::string> travels_, proofs_;
  std::string other_members_ = "{}";  ///< JSON of all data not tied to a single tube
};

}  // namespace tubeplan::app
