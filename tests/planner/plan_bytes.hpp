// A plan as text, for exact comparison.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

#include "planner/visit_plan.hpp"

namespace tubeplan::planner::testing {

/// Returns all values of a plan as text without rounding.
inline std::string bytesOf(const VisitPlan& plan) {
  std::string text =
      fmt::format("{} {} {:a} {:a} {:a} {:a} {:a} {:a} {} {}\n", static_cast<int>(plan.status), plan.reason,
                  plan.travel_time, plan.lower_bound, plan.optimality_gap, plan.row_by_row_time, plan.total_time,
                  plan.min_margin, plan.tightest.body, plan.detours);
  for (const auto& visit : plan.visits)
    text += fmt::format("visit {} {:a} {:a}\n", visit.tube, visit.branch.tilt, visit.branch.path_deviation);
  for (const auto& missed : plan.unreachable) text += fmt::format("missed {} {}\n", missed.tube, missed.reason);
  for (const auto& segment : plan.segments) {
    text += fmt::format("{} {} {:a} {}\n", nameOf(segment.kind), segment.visit, segment.margin, segment.tightest.other);
    for (const auto& q : segment.waypoints) text += fmt::format(" {:a}", fmt::join(q, " "));
  }
  return text;
}

}  // namespace tubeplan::planner::testing
