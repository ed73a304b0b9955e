// Output files of a plan: plan.json, path.csv, cell.yaml, touches.csv, worklist.csv, report.html.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/documents/plan_outcome.hpp"
#include "app/storage/atomic_file.hpp"

namespace tubeplan::app {

/// Returns the content of plan.json, but without the fingerprint of the path.
[[nodiscard]] nlohmann::json planJson(const PlanRequest& request, const PlanOutcome& outcome);

/// Returns the number of tool steps expected to enter at visit `k`: the most probable number or, if there are no
/// probabilities, the number that enters with the predicted centring error.
[[nodiscard]] int expectedSteps(const PlanOutcome& outcome, std::size_t k);

/// Returns planJson() with the fingerprint of the path's numbers added, with which `verify` recognises the path file.
[[nodiscard]] nlohmann::json planFileJson(const PlanRequest& request, const PlanOutcome& outcome);
[[nodiscard]] std::string planFileText(const PlanRequest& request, const PlanOutcome& outcome);

/// Returns the content of path.csv: `time_s,segment,kind,<joint>_<angle>...,leg,row,column`. Leg, row and column name
/// the tube that the path row leads to or away from.
[[nodiscard]] std::string pathCsv(const PlanOutcome& outcome);

/// Returns the data for renderPlanReport().
[[nodiscard]] nlohmann::json reportJson(const PlanRequest& request, const PlanOutcome& outcome);

/// Names of all files that a plan may write to its folder.
inline constexpr const char* kPlanFiles[] = {"plan.json",    "path.csv",    "cell.yaml",      "touches.csv",
                                             "worklist.csv", "report.html", "trajectory.yaml"};

/// Writes the files of a plan, except the trajectory, to the folder and commits them, so that all appear together.
void writePlan(const PlanRequest& request, const PlanOutcome& outcome, OutputFolder& folder);

}  // namespace tubeplan::app
