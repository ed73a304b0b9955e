// Routes of the calibration loop: compare, diagnose, identify, add, remove, ladder, improve, and simulate measurements
// for practice. Each route begins a job.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/documents/improvement_json.hpp"
#include "app/documents/measurement_checks_json.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/formats/cell/simulation_input.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/jobs/comparison.hpp"
#include "app/jobs/diagnosis.hpp"
#include "app/jobs/effect_addition.hpp"
#include "app/jobs/identification.hpp"
#include "app/jobs/improvement.hpp"
#include "app/jobs/ladder.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/named_entry.hpp"
#include "app/workbench/job_routes.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/routes.hpp"

namespace tubeplan::app {

namespace {

constexpr int kMostSimulated = 5000;

Answer diagnose(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  return beginDiagnosis(workbench,
                        {integerOf(body, "effects", 3, 1, 4), integerOf(body, "next", 6, 1, 50), seedOf(body)});
}

bool givesWay(const deflection::Arm& arm) {
  return std::any_of(arm.rows.begin(), arm.rows.end(),
                     [](const auto& row) { return row.beam || !row.joint_stiffness.array().isInf().all(); });
}

struct NamedCell {
  std::string label;
  Cell cell;
};

/// Returns the models from the first to the current one, preceded by a rigid version of the first model if the first
/// model is flexible.
std::vector<NamedCell> stackOf(const Session& session) {
  std::vector<NamedCell> stack;
  const auto& models = session.models;
  const Cell& first = models.front()->cell;
  if (givesWay(first.arm)) stack.push_back({models.front()->label + ", rigid", rigidOf(first)});
  for (std::size_t k = 0; k <= session.current; ++k) stack.push_back({models[k]->label, models[k]->cell});
  return stack;
}

/// Returns the JSON of a comparison (ladder) of the models. `set_aside`: ids of known outliers; `top`: existing fit of
/// the last model without these outliers, or null.
nlohmann::json ladderOver(const std::vector<NamedCell>& stack, const Session& began, std::uint64_t seed,
                          const WorkHooks& hooks, std::vector<std::string> set_aside = {},
                          const calibration::Identification* top = nullptr) {
  std::vector<LadderModel> models;
  for (const auto& [label, cell] : stack) {
    models.push_back(
        {label,
         {cell, began.measurements->name, measurementsInUse(*began.measurements), began.measurements->checks},
         nullptr});
    requireDefinedFormulas(models.back().input.measurements, cell, models.back().input.file);
  }
  models.back().fit = top;
  LadderRequest ladder_request;
  ladder_request.truth = began.truth;
  ladder_request.holes = 300;
  ladder_request.seed = seed;
  ladder_request.set_aside = std::move(set_aside);
  return runLadder(models, ladder_request, hooks).figures;
}

Answer ladder(Workbench& workbench, const Request& request) {
  const std::uint64_t seed = seedOf(objectOf(request));
  return beginResultJob(workbench, "ladder", "Errors of the models", JobInput::kModelAndMeasurements,
                        [seed](const Session& began, JobContext& context) {
                          (void)inputOf(began);
                          return ladderOver(stackOf(began), began, seed, hooksOf(context));
                        });
}

/// Compares all models of stackOf() on the measurements that the comparison of the current model used, and stores the
/// result as the ladder.
void putLadder(Workbench& workbench, const Session& began, std::uint64_t seed, const RefitOfMeasurements& refit,
               JobContext& context) {
  const auto climbed = ladderOver(stackOf(began), began, seed, hooksOf(context), refit.set_aside, &refit.fit);
  finishJob(workbench, began, JobInput::kModelAndMeasurements,
            [&](Session& session) { putResult(session, "ladder", currentModel(began).id, climbed); });
}

/// Begins a comparison, for the request {"folds"?, "ladder"?: true}.
Answer compare(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  return beginComparison(workbench, {integerOf(body, "folds", 5, 0, 100), seedOf(body)},
                         booleanOf(body, "ladder", false));
}

void requireFitted(const IdentificationOutcome& outcome, const CellMeasurements& input) {
  if (outcome.fit.status == calibration::IdentificationStatus::kNotRun)
    throw InputError::problem(input.file, outcome.fit.reason, "correct the readings, or confirm that they are right");
  if (outcome.fit.status != calibration::IdentificationStatus::kDone)
    throw InputError::problem(input.file, "the fit did not converge: " + outcome.fit.reason,
                              "fit fewer numbers, or add readings that determine them");
}

/// Job that fits the current model and puts the fitted model on the stack under `name`.
struct FitJob {
  std::string kind, label, name, origin;
  IdentificationRequest request;
  /// Returns the text of the cell to fit; if empty, the current cell is fitted.
  std::function<std::string(const Cell&)> changed = {};
};

/// Begins a fit that puts the fitted model on the stack, stores its results, and compares all models on the stack.
Answer beginFit(Workbench& workbench, const FitJob& fit) {
  return beginJob(workbench, fit.kind, fit.label, [fit, &workbench](JobContext& context) {
    const Session began = workbench.session();
    CellMeasurements input = inputOf(began);
    if (fit.changed) {
      input.cell = rereadCell(input.cell, fit.changed(input.cell));
      requireDefinedFormulas(input.measurements, input.cell, input.file);
    }
    const auto outcome = identifyModel(input, fit.request, hooksOf(context));
    requireFitted(outcome, input);
    auto stack = stackOf(began);
    stack.push_back({fit.name, fittedCell(input.cell, outcome)});
    const auto climbed = ladderOver(stack, began, fit.request.seed, hooksOf(context));
    finishJob(workbench, began, JobInput::kModelAndMeasurements, [&](Session& session) {
      const int id = pushModel(session, fit.name, fit.origin, stack.back().cell);
      putResult(session, "identify", id, outcome.figures);
      putResult(session, "ladder", id, climbed);
    });
    return "identify";
  });
}

Answer identify(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  IdentificationRequest identification_request;
  identification_request.free = textsOf(body, "free");
  identification_request.seed = seedOf(body);
  return beginFit(workbench, {"identify", "Fit", "fitted", "fit", identification_request});
}

/// Returns the causes of {"causes": ["base-slip@base:time=90", ...]} or the formula of {"formula"}, in the notation of
/// AdditionRequest.
AdditionRequest additionRequestOf(const nlohmann::json& body) {
  constexpr std::size_t kMostAtOnce = 8;
  AdditionRequest addition_request{textsOf(body, "causes"), textOf(body, "formula")};
  const std::size_t count = addition_request.causes.size() + (addition_request.formula.empty() ? 0 : 1);
  if (count == 0 || count > kMostAtOnce)
    throw InputError("request (causes)", fmt::format("{} causes", count),
                     fmt::format("1 to {} causes, or a formula", kMostAtOnce));
  return addition_request;
}

Answer add(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const AdditionRequest addition_request = additionRequestOf(body);
  IdentificationRequest fit;
  fit.seed = seedOf(body);
  const Addition first =
      addToCell(currentModel(workbench.session()).cell, addition_request);  // refuses bad input before the job
  const std::string label =
      addition_request.formula.empty() ? causesLabel("+", first.names) : fmt::format("+ {}", addition_request.formula);
  return beginFit(workbench, {"add", label, label, addition_request.formula.empty() ? "effect" : "formula", fit,
                              [addition_request](const Cell& cell) {
                                return cellTextWith(cell, addToCell(cell, addition_request), cell.path);
                              }});
}

/// Fits the model without the listed effects and with the listed parameters held fixed, for the request {"causes":
/// ["hysteresis@theta4", "free@tool.tip"]}.
Answer remove(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const auto causes = textsOf(body, "causes");
  IdentificationRequest fit;
  fit.seed = seedOf(body);
  (void)withoutCauses(currentModel(workbench.session()).cell, causes);  // refuses bad input before the job begins
  const std::string label = causesLabel("\u2212", causes);
  return beginFit(workbench, {"remove", label, label, "without", fit, [causes](const Cell& cell) {
                                const Cell without = withoutCauses(cell, causes);
                                return cellTextWithEffects(without, without.arm, {}, without.path);
                              }});
}

Answer improve(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const ImprovementRequest improvement_request{integerOf(body, "steps", 6, 1, 20), seedOf(body), {}};
  return beginJob(
      workbench, "improve", "diagnose and add until no further effect is found",
      [&workbench, improvement_request](JobContext& context) {
        const Session began = workbench.session();
        const CellMeasurements input = inputOf(began);
        const auto outcome = improveModel(input, improvement_request, hooksOf(context));
        if (!outcome.isUsable())
          throw InputError::problem(input.file,
                                    "no verdict is possible on these readings: " +
                                        (outcome.steps.empty() ? outcome.models.front().fit.reason
                                                               : reasonText(outcome.steps.back(), input.cell.units)),
                                    "correct the readings, or add more");
        std::vector<NamedCell> improved;  // one model for each step, so that each step can be undone
        for (const auto& model : outcome.models)
          improved.push_back(
              {model.name == "as given" ? "fitted" : model.name,
               improvedCell(input.cell, model.cell, model.fit,
                            calibration::withoutMeasurements(input.measurements, model.set_aside), input.cell.path)
                   .reread()});
        finishJob(workbench, began, JobInput::kModelAndMeasurements, [&](Session& session) {
          int id = 0;
          for (std::size_t k = 0; k < improved.size(); ++k)
            id = pushModel(session, improved[k].label, k == 0 ? "fit" : "effect", improved[k].cell);
          putResult(session, "improve", id, improvementJson(outcome, input.measurements, input.cell.units));
        });
        return "improve";
      });
}

SimulationRequest simulationRequestOf(const nlohmann::json& body) {
  SimulationRequest simulation_request;
  simulation_request.design = textOf(body, "design", "bench");
  (void)entryNamed(calibration::campaignDesigns(), simulation_request.design,
                   "design");  // a request must not open a design file
  simulation_request.measurements = integerOf(body, "readings", 60, 1, kMostSimulated);
  simulation_request.hide = textsOf(body, "hide");
  if (body.contains("loads") && !body["loads"].is_null()) simulation_request.loads = numbersOf(body, "loads");
  simulation_request.spread = numberOf(body, "spread", 0);
  simulation_request.seed = seedOf(body);
  return simulation_request;
}

/// Returns the simulated measurements as a reader of the written measurement file would see them.
std::shared_ptr<MeasurementSet> measurementsOf(const calibration::SimulatedCampaign& campaign, const Cell& cell,
                                               const std::string& name) {
  auto set = std::make_shared<MeasurementSet>();
  set->name = name;
  set->measurements = parseMeasurementText(measurementsCsv(campaign.measurements, cell.arm, cell.units), name, cell);
  return set;
}

Answer simulate(Workbench& workbench, const Request& request) {
  const SimulationRequest simulation_request = simulationRequestOf(objectOf(request));
  const Session now = workbench.session();
  (void)prepareSimulation(now.models.front()->cell, simulation_request);  // refuses bad input before the job
  return beginJob(workbench, "simulate", "Simulation", [&workbench, simulation_request](JobContext& context) {
    const Session began = workbench.session();
    const Cell& cell = began.models.front()->cell;
    const SimulationTask task = prepareSimulation(cell, simulation_request);
    const auto campaign =
        simulateMeasurements(cell, task, simulation_request.seed,
                             {[&](std::size_t done, std::size_t total) { context.progress("readings", done, total); },
                              [&] { return context.stopRequested(); }});
    if (campaign.status == calibration::CampaignStatus::kStopped) throw JobStopped{};
    if (campaign.status != calibration::CampaignStatus::kDone)
      throw InputError::problem("design", campaign.reason, "choose another design or seed, or fewer readings");
    const auto set = measurementsOf(
        campaign, cell, fmt::format("simulated-{}-{}.csv", simulation_request.design, simulation_request.seed));
    finishJob(workbench, began, JobInput::kModelAndMeasurements, [&](Session& session) {
      putMeasurements(session, set);
      putResult(session, "simulate", currentModel(session).id,
                {{"design", simulation_request.design},
                 {"readings", set->measurements.size()},
                 {"hidden", simulation_request.hide},
                 {"seed", simulation_request.seed}});
    });
    return "simulate";
  });
}

constexpr Route kLoopRoutes[] = {
    {"POST", "compare", compare}, {"POST", "diagnose", diagnose}, {"POST", "identify", identify},
    {"POST", "add", add},         {"POST", "remove", remove},     {"POST", "ladder", ladder},
    {"POST", "improve", improve}, {"POST", "simulate", simulate},
};

}  // namespace

Answer beginComparison(Workbench& workbench, const ComparisonRequest& request, bool with_ladder) {
  return beginResultJob(workbench, "compare", "Comparison", JobInput::kModelAndMeasurements,
                        [=, &workbench](const Session& began, JobContext& context) {
                          const CellMeasurements input = inputOf(began);
                          if (!with_ladder) return compareModel(input, request, hooksOf(context)).figures;
                          beginStage(context, "fit");
                          const auto refit = refitMeasurements(input, request, hooksOf(context));
                          putLadder(workbench, began, request.seed, refit, context);
                          return compareModel(input, request, hooksOf(context), &refit).figures;
                        });
}

Answer beginDiagnosis(Workbench& workbench, const DiagnosisRequest& request) {
  return beginResultJob(workbench, "diagnose", "Diagnosis", JobInput::kModelAndMeasurements,
                        [request](const Session& began, JobContext& context) {
                          return diagnoseModel(inputOf(began), request, hooksOf(context)).figures;
                        });
}

std::span<const Route> loopRoutes() { return kLoopRoutes; }

}  // namespace tubeplan::app
