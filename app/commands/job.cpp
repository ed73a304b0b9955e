// `tubeplan job`: the record of an outage's work, from the job file to the last tube.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/commands/job_actions.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

struct JobOptions {
  std::string action, file, tube, out, from, start, csv, mark, read_back, leg;
  std::vector<double> position;
  EventEntry entry;
  JobPart part;
  std::int64_t event = 0, after = -1;
  std::uint64_t seed = 1;
  FiguresTarget figures;
};

/// Returns the tube of the command line. Throws InputError if it is missing.
TubeAddress tubeOf(const JobOptions& options) {
  if (options.tube.empty())
    throw InputError::saying("TUBE", "the tube is missing", "name it in full, such as A/hot/R12C40");
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
    throw InputError::saying("--out", "the option is missing",
                             "name the file that keeps the record, such as spring.job");
  JobStore::create(readJobFile(options.file), options.out);
  JobStore store(options.out);
  return showStatus(options, store);
}

int status(const JobOptions& options) {
  JobStore store(options.file);
  return showStatus(options, store);
}

int next(const JobOptions& options) {
  JobStore store(options.file);
  const nlohmann::json figures = nextJson(store, partOf(options, store.job()));
  const bool is_left = !figures["tube"].is_null();
  showFigures(options.figures, figures, is_left ? nextText(figures) : "nothing is left to visit\n");
  return is_left ? kDone : kNegativeAnswer;
}

int confirm(const JobOptions& options) {
  JobStore store(options.file);
  ConfirmationRequest request{tubeOf(options), options.part.package, options.read_back, std::nullopt, options.entry};
  if (options.read_back.empty() == options.position.empty())
    throw InputError::saying("--read-back, --position", "one of these options is needed",
                             "say which tube another person reads, or where an independent measurement finds the tool");
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
    throw InputError::saying("--as", "the option is missing", "write --as done, or another mark");
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
  JobStore store(options.file);
  if (!options.csv.empty()) writeFileAtomically(options.csv, logCsv(store), "--csv");
  const nlohmann::json figures = logJson(store.events());
  showFigures(options.figures, figures, logText(figures));
  return kDone;
}

int exportPackage(const JobOptions& options) {
  JobStore store(options.file);
  const JobPart part = partOf(options, store.job());
  if (part.package.empty() || part.generator.empty() || !part.leg || options.csv.empty())
    throw InputError::saying("--package, --sg, --leg, --csv", "all four options are needed",
                             "a list is of one package on one leg");
  writeFileAtomically(options.csv, packageCsv(store, part.package, part.generator, *part.leg), "--csv");
  say("wrote {}\n", options.csv);
  return kDone;
}

int plan(const JobOptions& options) {
  if (options.out.empty())
    throw InputError::saying("--out", "the option is missing", "name the folder for the plans of the packages");
  noteStopSignals();
  JobStore store(options.file);
  const JobPlanRequest asked{options.seed, partOf(options, store.job()), options.start,
                             options.from.empty() ? options.out : options.from};
  const auto keep = [&](const std::string& name, const PlanRequest& request, const PlanOutcome& outcome,
                        const PlanCheckpoint& checkpoint) {
    OutputFolder folder(std::filesystem::path(options.out) / name, "--out");
    folder.requireOwn({"plan.json"}, {std::begin(kPlanFiles), std::end(kPlanFiles)});
    folder.write(kCacheFile, checkpoint.text());
    writePlan(request, outcome, folder);
  };
  const JobPlan plan = planJob(store, asked, terminalHooks(), keep);
  if (plan.is_stopped) {
    remark("stopped; the packages planned so far are kept\n");
    return kStoppedExitCode;
  }
  const nlohmann::json figures = jobPlanJson(plan, store.job());
  showFigures(options.figures, figures, plan.legs.empty() ? "nothing is left to plan\n" : jobPlanText(figures));
  return plan.legs.empty() ? kNegativeAnswer : kDone;
}

/// One action of the command: its name, its words for --help, the options it has beside --json and --format, and the
/// function that runs it.
struct JobAction {
  const char* name;
  const char* words;
  std::vector<std::string> options;
  int (*run)(const JobOptions&);
};

const std::vector<JobAction>& jobActions() {
  static const std::vector<JobAction> kActions{
      {"create", "makes the record from a job file", {"--out"}, create},
      {"status", "shows the totals of all packages, and warnings", {}, status},
      {"plan",
       "plans all that is left, and the schedule of the arms",
       {"--out", "--from", "--start", "--package", "--sg", "--leg", "--seed"},
       plan},
      {"next", "names the tube to visit next", {"--package", "--sg", "--leg"}, next},
      {"confirm",
       "records which tube the tool is at",
       {"TUBE", "--package", "--read-back", "--position", "--by", "--at"},
       confirm},
      {"mark",
       "records what became of a visit",
       {"TUBE", "--package", "--as", "--by", "--at", "--reason", "--after"},
       mark},
      {"undo", "undoes a mark, with the reason", {"--event", "--by", "--at", "--reason"}, undo},
      {"log", "lists all events", {"--csv"}, log},
      {"export", "writes a package of one leg as a work list", {"--package", "--sg", "--leg", "--csv"}, exportPackage},
  };
  return kActions;
}

/// Throws InputError for an option of another action, because the option would have no effect.
void requireOptionsOf(const JobAction& action, const CLI::App& cli) {
  const std::set<std::string> always{"ACTION", "FILE", "--json", "--format", "--help"};
  for (const CLI::Option* option : cli.get_options()) {
    const std::string name = option->get_lnames().empty() ? option->get_name() : "--" + option->get_lnames().front();
    if (option->count() == 0 || always.contains(name) ||
        std::ranges::find(action.options, name) != action.options.end())
      continue;
    throw InputError::saying(name, fmt::format("`job {}` does not have this option", action.name), "leave it out");
  }
}

int run(const JobOptions& options, const CLI::App& cli) {
  keepFile(options);
  checkFigures(options.figures);
  requireOptionsOf(cli, options.action, {jobActions().begin(), jobActions().end()});
  for (const JobAction& action : jobActions())
    if (options.action == action.action) return action.run(options);
  throw std::logic_error("an action that its check let pass");
}

std::vector<std::string> actionNames() {
  std::vector<std::string> names;
  for (const JobAction& action : jobActions()) names.push_back(action.action);
  return names;
}

std::vector<std::string> legNames() {
  std::vector<std::string> names;
  for (const tubesheets::Leg leg : tubesheets::legs()) names.emplace_back(tubesheets::legName(leg));
  return names;
}

std::string actionWords() {
  std::vector<std::string> words;
  for (const JobAction& action : jobActions()) words.push_back(fmt::format("{}: {}", action.action, action.words));
  return fmt::format("{}", fmt::join(words, "; "));
}

std::string markWords() {
  std::vector<std::string> words;
  for (const Mark& mark : marks()) words.push_back(fmt::format("{} ({})", mark.name, mark.words));
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

Run configureJob(CLI::App& cli) {
  const auto options = std::make_shared<JobOptions>();
  cli.add_option("ACTION", options->action, actionWords())->required()->check(oneOf(actionNames()));
  cli.add_option("FILE", options->file, "the job file (create) or the record of the job (all others)")->required();
  cli.add_option("TUBE", options->tube, "confirm, mark: the tube with steam generator and leg, such as A/hot/R12C40");
  cli.add_option("--out", options->out, "create: the file that keeps the record; plan: the folder for the plans");
  cli.add_option("--from", options->from,
                 "plan: the folder of an earlier plan of the job, to reuse what is still valid of it (that of --out)");
  cli.add_option(
      "--start", options->start,
      "plan: where the arm stands: joint readings, --start=A,B,..., `park`, or the tube, by its earlier plan");
  cli.add_option("--package", options->part.package,
                 "the package, where the tube is in several, or to see only this one");
  cli.add_option("--sg", options->part.generator, "plan, next, export: only this steam generator");
  cli.add_option("--leg", options->leg, "plan, next, export: only this leg")->check(oneOf({"hot", "cold", "full"}));
  cli.add_option("--as", options->mark, "mark: " + markWords());
  cli.add_option("--by", options->entry.who, "the person who confirms, marks or undoes");
  cli.add_option("--reason", options->entry.reason, "why a tube is excluded, marked again or undone");
  cli.add_option("--at", options->entry.at, "time of the event in UTC, 2027-04-02T06:15:30Z (now)");
  cli.add_option("--after", options->after, "mark: refuse if the tube has a later event than this one of `job next`");
  cli.add_option("--read-back", options->read_back, "confirm: the tube that another person reads at the tool");
  cli.add_option("--position", options->position,
                 "confirm: X,Y of the tool in the sheet frame, measured apart from the arm's encoders")
      ->type_name("LENGTH")
      ->delimiter(',')
      ->expected(2);
  cli.add_option("--event", options->event, "undo: the number of the mark, as `job log` lists it");
  cli.add_option("--csv", options->csv, "log, export: write a table to this file");
  addSeed(cli, options->seed, "plan: seed of the random numbers");
  addFigures(cli, options->figures);
  return [options, &cli] { return run(*options, cli); };
}

}  // namespace tubeplan::app
