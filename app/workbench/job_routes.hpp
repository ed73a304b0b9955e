// Functions shared by the routes that begin a job.
#pragma once

#include <functional>
#include <string>

#include "app/formats/measurements/measurement_input.hpp"
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

/// Begins a job. Returns status 202 with the job, or 409 if the queue refuses the job.
[[nodiscard]] Answer beginJob(Workbench& workbench, const std::string& kind, const std::string& label, JobWork work);

/// Inputs of a job. The result of the job is discarded if these inputs have changed since the job began.
enum class JobInput { kModel, kModelAndMeasurements };

/// Work of a job that returns the result document for the model that was current when the job began.
using ResultWork = std::function<nlohmann::json(const Session& began, JobContext&)>;
[[nodiscard]] Answer beginResultJob(Workbench& workbench, const std::string& kind, const std::string& label,
                                    JobInput input, ResultWork work);

/// Begins the comparison of the current model with the measurements. With `with_ladder`, also compares all models on
/// the stack with each other (the ladder), reusing the fit of the current one.
[[nodiscard]] Answer beginComparison(Workbench& workbench, const ComparisonRequest& request, bool with_ladder);

/// Begins the diagnosis of the current model.
[[nodiscard]] Answer beginDiagnosis(Workbench& workbench, const DiagnosisRequest& request);

/// Returns hooks that report progress as stages of the job, and that stop the work when the job is cancelled.
[[nodiscard]] WorkHooks hooksOf(JobContext& context);

/// Returns planner hooks that report progress and stop the work as hooksOf() does.
[[nodiscard]] planner::PlanHooks planHooksOf(JobContext& context);

/// Returns the error for a request that needs measurements when none are loaded.
[[nodiscard]] InputError withoutMeasurements();

/// Returns the current model with the measurements in use. Throws InputError without measurements, and for measurements
/// at which a formula of the model has no value.
[[nodiscard]] CellMeasurements inputOf(const Session& session);

/// Applies the result of a job to the session. Throws InputError if the current model is no longer the model at the
/// beginning of the job, and JobStopped if the measurements have been replaced, so that the result is obsolete.
void finishJob(Workbench& workbench, const Session& began, JobInput input, const std::function<void(Session&)>& step);

/// Returns the cell after a fit as read back from its exported file, so that later results agree with those of the
/// commands. rereadCell() does so for a cell with the given text.
[[nodiscard]] Cell fittedCell(const Cell& cell, const IdentificationOutcome& outcome);
[[nodiscard]] Cell rereadCell(const Cell& cell, const std::string& text);

/// Throws InputError with the reason if planning failed, and JobStopped if it was stopped.
void requirePlanned(const PlanOutcome& outcome);

}  // namespace tubeplan::app
