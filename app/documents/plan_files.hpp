// Output files of a plan: plan.json, path.csv, cell.yaml, touches.csv, worklist.csv, report.html.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/documents/plan_outcome.hpp"
#include "app/storage/atomic_file.hpp"

namespace tubeplan::app {

/// Returns the content of plan.json, by the contract.
[[nodiscard]] nlohmann::json planJson(const PlanRequest& request, const PlanOutcome& outcome);

/// Returns the number of steps expected to enter at visit `k`: the most probable one, or from the predicted error if no
/// chances are known.
[[nodiscard]] int expectedSteps(const PlanOutcome& outcome, std::size_t k);

/// Returns planJson() with the fingerprint of the path's numbers, by which `verify` recognizes them.
[[nodiscard]] nlohmann::json planFileJson(const PlanRequest& request, const PlanOutcome& outcome);
[[nodiscard]] std::string planFileText(const PlanRequest& request, const PlanOutcome& outcome);

/// Returns path.csv: `time_s,segment,kind,<joint>_<angle>...,leg,row,column`, with the tube that the row leads to or
/// from.
[[nodiscard]] std::string pathCsv(const PlanOutcome& outcome);

/// Returns the data of the report page.
[[nodiscard]] nlohmann::json reportJson(const PlanRequest& request, const PlanOutcome& outcome);

/// Names of all files that a plan may write into its folder.
inline constexpr const char* kPlanFiles[] = {"plan.json",    "path.csv",    "cell.yaml",      "touches.csv",
                                             "worklist.csv", "report.html", "trajectory.yaml"};

/// Writes all files of a plan into a folder that appears complete or not at all.
void writePlan(const PlanRequest& request, const PlanOutcome& outcome, OutputFolder& folder);

}  // namespace tubeplan::app
