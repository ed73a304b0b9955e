// Common parts of the routes that begin a job.
#pragma once

#include <functional>
#include <string>

#include "app/formats/measurements/reading_input.hpp"
#include "app/jobs/comparison.hpp"
#include "app/jobs/diagnosis.hpp"
#include "app/jobs/identification.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/job_steps.hpp"
#include "app/workbench/exchange.hpp"
#include "app/workbench/workbench.hpp"
#include "calibration/hooks.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

/// Begins a job. Returns 202 with the job, or 409 if it is refused.
[[nodiscard]] Answer beginJob(Workbench& workbench, const std::string& kind, const std::string& label, JobWork work);

/// Inputs of a job; its answer is discarded if they have changed meanwhile.
enum class JobInput { kModel, kModelAndReadings };

/// Work whose document becomes the result of the job's kind, for the model at its beginning.
using ResultWork = std::function<nlohmann::json(const Session& began, JobContext&)>;
[[nodiscard]] Answer beginResultJob(Workbench& workbench, const std::string& kind, const std::string& label,
                                    JobInput input, ResultWork work);

/// Begins the comparison of the current model with the readings. `with_ladder` adds the ladder over the stack, which
/// reuses the fit of the current model; the comparison is sent first.
[[nodiscard]] Answer beginComparison(Workbench& workbench, const ComparisonRequest& asked, bool with_ladder);

/// Begins the diagnosis of the current model.
[[nodiscard]] Answer beginDiagnosis(Workbench& workbench, const DiagnosisRequest& asked);

/// Returns hooks that report progress as the job's stages and stop the work on request.
[[nodiscard]] WorkHooks hooksOf(JobContext& context);

/// Returns such hooks for the planner.
[[nodiscard]] planner::PlanHooks planHooksOf(JobContext& context);

/// Returns the error of a request that needs readings where none are loaded.
[[nodiscard]] InputError withoutReadings();

/// Returns the current model with the readings, checked against its formulas. Throws InputError without readings.
[[nodiscard]] CellReadings inputOf(const Session& session);

/// Changes the session at the end of a job. Throws InputError if the current model is not that of the job's beginning;
/// JobStopped if the readings have been replaced, so that the answer is obsolete.
void finishJob(Workbench& workbench, const Session& began, JobInput input, const std::function<void(Session&)>& step);

/// Returns the cell as an export after a fit, or with other effects, would write it: written and read again, so that
/// later results agree with the commands on the files.
[[nodiscard]] Cell fittedCell(const Cell& cell, const IdentificationOutcome& outcome);
[[nodiscard]] Cell rereadCell(const Cell& cell, const std::string& text);

}  // namespace tubeplan::app
