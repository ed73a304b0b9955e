// `tubeplan job`: the record of an outage's work, from the job file to the last tube.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "app/cli/command.hpp"
#include "app/commands/job_actions.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

/// Throws InputError if an output would replace the file that the action reads, such as the record of the job.
void keepFile(const JobOptions& options) {
  std::error_code none;
  for (const auto& [option, path] : {std::pair<const char*, std::string>{"--out", options.out},
                                     {"--pdf", options.pdf},
                                     {"--csv", options.csv},
                                     {"--json", options.figures.json}})
    if (!path.empty() && std::filesystem::equivalent(path, options.file, none))
      throw InputError::problem(option, fmt::format("this command reads {}, which would be overwritten", options.file),
                                "choose another name");
}

int run(const JobOptions& options, const CLI::App& cli) {
  keepFile(options);
  checkFigures(options.figures);
  requireOptionsOf(cli, options.action, {jobActions().begin(), jobActions().end()});
  for (const JobAction& action : jobActions())
    if (options.action == action.action) return action.run(options);
  throw std::logic_error("an action that the option check should have rejected");
}

std::vector<std::string> legNames() {
  std::vector<std::string> names;
  for (const tubesheets::Leg leg : tubesheets::legs()) names.emplace_back(tubesheets::legName(leg));
  return names;
}

std::string markWords() {
  std::vector<std::string> words;
  for (const Mark& mark : marks()) words.push_back(fmt::format("{} ({})", mark.name, mark.words));
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

Run configureJob(CLI::App& cli) {
  const auto options = std::make_shared<JobOptions>();
  addAction(cli, options->action, {jobActions().begin(), jobActions().end()});
  cli.add_option("FILE", options->file, "create: the job file; all others: the record of the job")->required();
  cli.add_option("TUBE", options->tube, "confirm, mark: the tube with steam generator and leg, such as A/hot/R12C40");
  cli.add_option("--out", options->out,
                 "create: the file that keeps the record; plan: the folder for the plans; report: the page");
  cli.add_option("--pdf", options->pdf, "report: also print the page to this file, by headless Chromium");
  cli.add_option("--shift", options->hand_over.shift, "report: the shift, as the job file names it (the latest)");
  cli.add_option("--date", options->hand_over.date,
                 "report: the day on which the shift began, 2025-04-02 (the latest)");
  cli.add_option("--from", options->from,
                 "plan: the folder of an earlier plan of the job, to reuse what is still valid of it (that of --out)");
  cli.add_option("--start", options->start,
                 "plan: where the arm is: joint readings, --start=A,B,..., `park`, or the tube, by its earlier plan")
      ->type_name("POSTURE");
  cli.add_option("--package", options->part.package,
                 "package, if the tube is in several packages, or to show only this one");
  cli.add_option("--sg", options->part.generator, "plan, next, export: only this steam generator");
  cli.add_option("--leg", options->leg, "plan, next, export: only this leg")->check(oneOf(legNames()));
  cli.add_option("--as", options->mark, "mark: " + markWords());
  cli.add_option("--by", options->entry.person, "the person who confirms, marks or undoes");
  cli.add_option("--reason", options->entry.reason, "why a tube is excluded, marked again or undone");
  cli.add_option("--at", options->entry.at, "time of the event in UTC, 2025-04-02T06:15:30Z (now)");
  cli.add_option("--after", options->after, "mark: refuse if the tube has a later event than this one of `job next`");
  cli.add_option("--read-back", options->read_back, "confirm: the tube that another person reads at the tool");
  cli.add_option("--position", options->position,
                 "confirm: X,Y of the tool in the sheet frame, measured independently of the arm's encoders")
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
