// What the routes that begin a job have in common.
#pragma once

#include <functional>
#include <string>

#include "app/formats/measurements/reading_input.hpp"
#include "app/jobs/comparison.hpp"
#include "app/jobs/diagnosis.hpp"
#include "app/jobs/identification.hpp"
#include "app/studies/job_steps.hpp"
#include "app/workbench/exchange.hpp"
#include "app/workbench/workbench.hpp"
#include "calibration/hooks.hpp"
#include "planner/visit_plan.hpp"

namespace tubeplan::app {

/// 202 with the job, or 409.
[[nodiscard]] Answer beginJob(Workbench& workbench, const std::string& kind, const std::string& label, JobWork work);

/// What a job's answer is found from: an answer from others is not wanted any more.
enum class JobInput { kModel, kModelAndReadings };

/// A job whose document becomes the result of its own kind, of the model that it began with.
using ResultWork = std::function<nlohmann::json(const Session& began, JobContext&)>;
[[nodiscard]] Answer beginResultJob(Workbench& workbench, const std::string& kind, const std::string& label,
                                    JobInput input, ResultWork work);

/// The comparison of what is there as a job; with the ladder over the stack, which is sent as soon as it is there: the
/// current model is fitted once for both.
[[nodiscard]] Answer beginComparison(Workbench& workbench, const ComparisonRequest& asked, bool with_ladder);

/// The diagnosis of what is there as a job.
[[nodiscard]] Answer beginDiagnosis(Workbench& workbench, const DiagnosisRequest& asked);

/// Progress of the work becomes the job's stages; a job asked to stop ends wherever it is.
[[nodiscard]] WorkHooks hooksOf(JobContext& context);

/// The same for the planner.
[[nodiscard]] planner::PlanHooks planHooksOf(JobContext& context);

/// The current model with the readings, checked against its formulas. Throws InputError where there are no readings.
[[nodiscard]] CellReadings inputOf(const Session& session);

/// Changes the situation at the end of a job. Throws InputError where the current model is another than that which the
/// job began with; JobStopped where its readings have given way to others: nobody waits for an answer on those before.
void finishJob(Workbench& workbench, const Session& began, JobInput input, const std::function<void(Session&)>& step);

/// The cell as an export would leave it after a fit, or with other effects: written and read again, so that what
/// follows is what the commands would give on the files.
[[nodiscard]] Cell fittedCell(const Cell& cell, const IdentificationOutcome& outcome);
[[nodiscard]] Cell rereadCell(const Cell& cell, const std::string& text);

}  // namespace tubeplan::app
