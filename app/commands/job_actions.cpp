#include "app/commands/job_actions.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/documents/plan_files.hpp"
#include "app/documents/printed_page.hpp"
#include "app/outage/hand_over_json.hpp"
#include "app/outage/job_export.hpp"
#include "app/outage/job_json.hpp"
#include "app/outage/job_plan_json.hpp"
#include "app/report/outage_report.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/origin.hpp"

namespace tubeplan::app {

namespace {

/// Returns the tube of the command line. Throws InputError if it is missing.
TubeAddress tubeOf(const JobOptions& options) {
  if (options.tube.empty())
    throw InputError::problem("TUBE", "the tube is missing", "name it in full, such as A/hot/R12C40");
  return parseAddress(options.tube, "TUBE");
}

JobPart partOf(const JobOptions& options, const JobFile& job) {
  JobPart part = options.part;
  if (!options.leg.empty()) part.leg = tubesheets::findLeg(options.leg);
  requirePart(job, part);
  return part;
}

int showStatus(const JobOptions& options, JobStore& store) {
  const nlohmann::json figures = totalsJson(totalsOf(store), store.job());
  showFigures(options.figures, figures, totalsText(figures));
  return kDone;
}

int create(const JobOptions& options) {
  if (options.out.empty())
    throw InputError::problem("--out", "the option is missing",
                              "name the file that keeps the record, such as spring.job");
  for (const std::string& note : JobStore::create(readJobFile(options.file), options.out)) remark("note: {}\n", note);
  JobStore store(options.out);
  return showStatus(options, store);
}

int status(const JobOptions& options) {
  JobStore store(options.file, Database::Mode::kRead);
  return showStatus(options, store);
}

int next(const JobOptions& options) {
  JobStore store(options.file, Database::Mode::kRead);
  const nlohmann::json figures = nextJson(store, partOf(options, store.job()));
  const bool is_left = !figures["tube"].is_null();
  showFigures(options.figures, figures, is_left ? nextText(figures) : "nothing is left to visit\n");
  return is_left ? kDone : kNegativeAnswer;
}

int confirm(const JobOptions& options) {
  JobStore store(options.file);
  ConfirmationRequest request{tubeOf(options), options.part.package, options.read_back, std::nullopt, options.entry};
  if (options.read_back.empty() == options.position.empty())
    throw InputError::problem(
        "--read-back, --position",
        options.position.empty() ? "one of these options is needed" : "both options are given",
        "give the tube that another person reads, or the position of the tool from an independent measurement");
  const double length = store.job().units.factor(dimension::kLength);
  if (!options.position.empty()) request.xy = {options.position[0] * length, options.position[1] * length};
  const IdentityFinding finding = confirmTube(store, request);
  const std::string meant = addressText(request.tube);
  const nlohmann::json figures = findingJson(request.tube, finding);
  showFigures(options.figures, figures,
              finding.is_same ? fmt::format("{} is confirmed\n", meant)
                              : fmt::format("NOT confirmed: {} is meant, but {} was found: {}\nno tool may enter\n",
                                            meant, finding.found.empty() ? "no hole" : finding.found, finding.reason));
  return finding.is_same ? kDone : kNegativeAnswer;
}

int showEvent(const JobOptions& options, std::int64_t event, const std::string& words) {
  showFigures(options.figures, {{"event", event}}, fmt::format("{}: event {}\n", words, event));
  return kDone;
}

int mark(const JobOptions& options) {
  if (options.mark.empty())
    throw InputError::problem("--as", "the option is missing", "write --as done, or another mark");
  JobStore store(options.file);
  const TubeAddress tube = tubeOf(options);
  const auto event = markTube(store, {tube, options.part.package, options.mark, options.entry,
                                      options.after < 0 ? std::nullopt : std::optional(options.after)});
  return showEvent(options, event, fmt::format("{} is marked {}", addressText(tube), options.mark));
}

int undo(const JobOptions& options) {
  JobStore store(options.file);
  return showEvent(options, undoMark(store, options.event, options.entry),
                   fmt::format("event {} is undone", options.event));
}

int log(const JobOptions& options) {
  JobStore store(options.file, Database::Mode::kRead);
  if (!options.csv.empty()) writeFileAtomically(options.csv, logCsv(store), "--csv");
  const nlohmann::json figures = logJson(store.events());
  showFigures(options.figures, figures, logText(figures));
  return kDone;
}

int exportPackage(const JobOptions& options) {
  JobStore store(options.file, Database::Mode::kRead);
  const JobPart part = partOf(options, store.job());
  if (part.package.empty() || part.generator.empty() || !part.leg || options.csv.empty())
    throw InputError::problem("--package, --sg, --leg, --csv", "all four options are needed",
                              "a work list has the tubes of one package on one leg");
  writeFileAtomically(options.csv, packageCsv(store, part.package, part.generator, *part.leg), "--csv");
  output("wrote {}\n", options.csv);
  return kDone;
}

nlohmann::json jobPlanReport(const nlohmann::json& figures) {
  nlohmann::json report = {{"title", figures["job"].get<std::string>() + ": plan"}, {"plan", figures}};
  stateOrigin(report);
  return report;
}

int plan(const JobOptions& options) {
  if (options.out.empty())
    throw InputError::problem("--out", "the option is missing", "name the folder for the plans of the packages");
  const auto page = std::filesystem::path(options.out) / "schedule.html";
  checkWritableFile(page, "--out");
  noteStopSignals();
  JobStore store(options.file);
  const JobPlanRequest plan_request{options.seed, partOf(options, store.job()), options.start,
                                    options.from.empty() ? options.out : options.from};
  const auto keep = [&](const std::string& name, const PlanRequest& request, const PlanOutcome& outcome,
                        const PlanCheckpoint& checkpoint) {
    OutputFolder folder(std::filesystem::path(options.out) / name, "--out");
    folder.requireOwn({"plan.json"}, {std::begin(kPlanFiles), std::end(kPlanFiles)});
    folder.write(kCacheFile, checkpoint.text());
    writePlan(request, outcome, folder);
  };
  const JobPlan plan = planJob(store, plan_request, terminalHooks(), keep);
  if (plan.is_stopped) {
    remark("stopped; the packages planned so far are kept\n");
    return kStoppedExitCode;
  }
  const nlohmann::json figures = jobPlanJson(plan, store.job());
  if (plan.legs.empty()) {
    showFigures(options.figures, figures, "nothing is left to plan\n");
    return kNegativeAnswer;
  }
  if (plan_request.part.isWhole()) store.setPlan(figures.dump());  // a plan of a part does not replace that of the job
  writeFileAtomically(page, renderJobPlanReport(jobPlanReport(figures)), "--out");
  showFigures(options.figures, figures, jobPlanText(figures) + fmt::format("wrote {}\n", page.string()));
  return kDone;
}

int report(const JobOptions& options) {
  if (options.out.empty())
    throw InputError::problem("--out", "the option is missing", "name the page to write, such as handover.html");
  checkWritableFile(options.out, "--out");
  if (!options.pdf.empty()) {
    checkWritableFile(options.pdf, "--pdf");
    requirePrinter();
  }
  JobStore store(options.file, Database::Mode::kRead);
  nlohmann::json figures = handOverJson(store, handOverOf(store, options.hand_over), options.hand_over, presentTime());
  stateOrigin(figures);
  writeFileAtomically(options.out, renderHandOverReport(figures), "--out");
  if (!options.pdf.empty()) printPage(options.out, options.pdf);
  std::string written = fmt::format("wrote {}\n", options.out);
  if (!options.pdf.empty()) written += fmt::format("wrote {}\n", options.pdf);
  showFigures(options.figures, figures, handOverText(figures) + written);
  return kDone;
}

}  // namespace

const std::vector<JobAction>& jobActions() {
  static const std::vector<JobAction> kActions{
      {{"create", "makes the record from a job file", {"--out"}}, create},
      {{"status", "shows the totals of all packages, and warnings", {}}, status},
      {{"plan",
        "plans all that is left, and the schedule of the arms",
        {"--out", "--from", "--start", "--package", "--sg", "--leg", "--seed"}},
       plan},
      {{"next", "names the tube to visit next", {"--package", "--sg", "--leg"}}, next},
      {{"confirm",
        "records which tube the tool is at",
        {"TUBE", "--package", "--read-back", "--position", "--by", "--at"}},
       confirm},
      {{"mark", "records what became of a visit", {"TUBE", "--package", "--as", "--by", "--at", "--reason", "--after"}},
       mark},
      {{"undo", "undoes a mark, with the reason", {"--event", "--by", "--at", "--reason"}}, undo},
      {{"report", "writes the hand-over of a shift as a page", {"--out", "--pdf", "--shift", "--date"}}, report},
      {{"log", "lists all events", {"--csv"}}, log},
      {{"export", "writes a package of one leg as a work list", {"--package", "--sg", "--leg", "--csv"}},
       exportPackage},
  };
  return kActions;
}

}  // namespace tubeplan::app
