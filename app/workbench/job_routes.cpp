#include "app/workbench/job_routes.hpp"

#include "app/formats/cell/cell_writer.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

Answer beginJob(Workbench& workbench, const std::string& kind, const std::string& label, JobWork work) {
  const auto begun = workbench.jobs().begin(kind, label, std::move(work));
  if (!begun.refused.empty())
    return refusal(409, InputError::problem("jobs", begun.refused, "wait until a job finishes, or stop one"));
  workbench.events().stateChanged();
  return answerOf(begun.job, 202);
}

Answer beginResultJob(Workbench& workbench, const std::string& kind, const std::string& label, JobInput input,
                      ResultWork work) {
  return beginJob(workbench, kind, label, [&workbench, kind, input, work = std::move(work)](JobContext& context) {
    const Session began = workbench.session();
    const nlohmann::json document = work(began, context);
    finishJob(workbench, began, input,
              [&](Session& session) { putResult(session, kind, currentModel(began).id, document); });
    return kind;
  });
}

WorkHooks hooksOf(JobContext& context) {
  return {
      [&context](std::string_view stage, std::size_t done, std::size_t total) { context.progress(stage, done, total); },
      [&context] { return context.stopRequested(); }};
}

planner::PlanHooks planHooksOf(JobContext& context) {
  const WorkHooks work_hooks = hooksOf(context);
  planner::PlanHooks hooks;
  hooks.progress = work_hooks.progress;
  hooks.stop = work_hooks.stop;
  return hooks;
}

InputError withoutMeasurements() {
  return InputError::problem("measurements", "no readings are loaded", "open a table of readings, or simulate some");
}

CellMeasurements inputOf(const Session& session) {
  const Cell& cell = currentModel(session).cell;
  if (!session.measurements) throw withoutMeasurements();
  CellMeasurements input{cell, session.measurements->name, measurementsInUse(*session.measurements),
                         session.measurements->checks};
  requireDefinedFormulas(input.measurements, input.cell, input.file);
  return input;
}

void finishJob(Workbench& workbench, const Session& began, JobInput input, const std::function<void(Session&)>& step) {
  bool has_other_measurements = false;
  const bool is_same = workbench.change([&](Session& session) {
    has_other_measurements = input == JobInput::kModelAndMeasurements && session.measurements != began.measurements;
    if (has_other_measurements || currentModel(session).id != currentModel(began).id ||
        session.models.front() != began.models.front())
      return false;
    step(session);
    return true;
  });
  if (has_other_measurements) throw JobStopped{};
  if (!is_same)
    throw InputError::problem("models", "the models have changed since the job started", "start the job again");
}

Cell rereadCell(const Cell& cell, const std::string& text) {
  const std::string& arm = cell.arm_source.text;
  return parseCell(text, cell.path, arm.empty() ? std::nullopt : std::optional(arm));
}

Cell fittedCell(const Cell& cell, const IdentificationOutcome& outcome) {
  return identifiedCell(cell, outcome.fit, outcome.measurements, cell.path).reread();
}

}  // namespace tubeplan::app
