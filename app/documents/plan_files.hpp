// What a plan leaves behind: plan.json, path.csv, cell.yaml, touches.csv, worklist.csv, report.html.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/documents/plan_outcome.hpp"
#include "app/storage/atomic_file.hpp"

namespace tubeplan::app {

/// plan.json as the contract has it.
[[nodiscard]] nlohmann::json planJson(const PlanRequest& request, const PlanOutcome& outcome);

/// How many steps are expected to enter at visit `k`: the likeliest number, or by the predicted error where no chances
/// are known.
[[nodiscard]] int expectedSteps(const PlanOutcome& outcome, std::size_t k);

/// plan.json's text: planJson() with the fingerprint of the path's numbers, by which `verify` knows them again.
[[nodiscard]] nlohmann::json planFileJson(const PlanRequest& request, const PlanOutcome& outcome);
[[nodiscard]] std::string planFileText(const PlanRequest& request, const PlanOutcome& outcome);

/// Returns path.csv: `time_s,segment,kind,<joint>_<angle>...,leg,row,column`, the tube that the row leads to or from.
[[nodiscard]] std::string pathCsv(const PlanOutcome& outcome);

/// What the report page shows.
[[nodiscard]] nlohmann::json reportJson(const PlanRequest& request, const PlanOutcome& outcome);

/// All that a plan may write into its folder.
inline constexpr const char* kPlanFiles[] = {"plan.json",    "path.csv",    "cell.yaml",      "touches.csv",
                                             "worklist.csv", "report.html", "trajectory.yaml"};

/// All files of a plan, into a folder that appears whole.
void writePlan(const PlanRequest& request, const PlanOutcome& outcome, OutputFolder& folder);

}  // namespace tubeplan::app
