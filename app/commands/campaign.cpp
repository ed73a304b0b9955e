// `tubeplan campaign`: simulates many calibrations, diagnoses or outages, each with a random true arm.
#include "app/commands/campaign/campaign.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/commands/campaign/campaign_options.hpp"
#include "app/commands/option_groups.hpp"
#include "app/formats/checkpoint/tally_checkpoint.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/named_entry.hpp"
#include "app/storage/origin.hpp"
#include "app/studies/monte_carlo/repeat_runs.hpp"
#include "app/studies/monte_carlo/run_workers.hpp"

namespace tubeplan::app {

namespace {

struct CampaignOptions {
  CampaignRequest request;
  std::string kind = "centre", out;
  FiguresTarget figures;
  std::int64_t runs = 0;
  int jobs = 0;
  bool resume = false;
};

const CampaignKind& campaignKindOf(const std::string& name) { return entryNamed(campaignKinds(), name, "--kind"); }

/// Checkpoint and output of a campaign. Only the first rank uses it.
class CampaignDesk {
 public:
  CampaignDesk(const CampaignOptions& options, const Campaign& campaign)
      : options_(options), campaign_(campaign), runs_(static_cast<std::uint64_t>(options.runs)) {
    checkFigures(options.figures);
    if (options.resume && options.out.empty())
      throw InputError::problem("--resume", "the folder to continue in is missing",
                                "add --out with the folder of the stopped campaign");
    RunSet done;
    noteStopSignals();  // installed before the first folder is created, so that a stop removes the folder
    if (!options.out.empty()) {
      folder_.emplace(options.out, "--out");
      folder_->requireOwn({kTallyFile, "campaign.json"}, {"holes.csv", "outcomes.csv", "changes.csv", "report.html"});
      keeper_.emplace(folder_->path(), options.resume);
      if (const auto kept = keeper_->begin(campaign.question, runs_)) {
        if (!campaign.experiment->add(kept->total))
          throw InputError(keeper_->path().string(), "a tally of another format", "the format of this campaign",
                           "remove that file to start again");
        done = kept->done;
      }
    }
    schedule_.emplace(runs_, chunkFor(runs_, campaign.largest_chunk), done);
  }

  int run(int workers, Ranks* ranks) {
    const auto begun = schedule_->done().size();
    auto progress = std::make_unique<Progress>("runs", static_cast<std::size_t>(runs_ - begun));
    RepeatHooks hooks;
    hooks.progress = [&](std::uint64_t done) { progress->update(static_cast<std::size_t>(done - begun)); };
    hooks.stop = stopCondition();
    hooks.keep = [&](bool must) { keep(must); };
    const RepeatStatus status = repeatRuns(*campaign_.experiment, *schedule_, workers, hooks, ranks);
    progress.reset();
    if (status == RepeatStatus::kStopped && keeper_) return explainStop();
    report();
    return status == RepeatStatus::kStopped ? kStoppedExitCode : kDone;
  }

 private:
  void keep(bool must) {
    if (keeper_) keeper_->save([&] { return TallySoFar{schedule_->done(), campaign_.experiment->total()}; }, must);
  }

  int explainStop() {
    keep(true);
    remark("stopped; {} of {} runs are kept in {}: the same command continues from there\n", schedule_->done().size(),
           runs_, keeper_->path().string());
    return kStoppedExitCode;
  }

  void report() {
    auto figures = campaign_.figures({runs_, schedule_->done().size()});
    stateOrigin(figures);
    if (folder_) {
      keep(true);
      folder_->write("campaign.json", figures.dump(2) + "\n");
      for (const auto& file : campaign_.files(figures)) folder_->write(file.name, file.content);
      folder_->commit();
    }
    writeFigures(options_.figures, figures);
    if (!printsText(options_.figures)) return;
    output("{}", campaign_.text(figures));
    if (folder_) output("wrote {}\n", (folder_->path() / "campaign.json").string());
  }

  const CampaignOptions& options_;
  const Campaign& campaign_;
  std::uint64_t runs_;
  std::optional<OutputFolder> folder_;
  std::optional<TallyCheckpoint> keeper_;
  std::optional<RunSchedule> schedule_;
};

void checkOptions(const CampaignOptions& options) {
  constexpr std::int64_t kMostRuns = 1'000'000'000;
  if (options.runs < 1 || options.runs > kMostRuns)
    throw InputError("--runs", std::to_string(options.runs), fmt::format("1 to {}", kMostRuns));
  if (options.jobs < 0 || options.jobs > 1024)
    throw InputError("--jobs", std::to_string(options.jobs), "0 to 1024", "0 means one job for each core");
}

int workersOf(const CampaignOptions& options) {
  return options.jobs > 0 ? options.jobs : usualWorkers(ranksOnThisMachine());
}

int runAlone(const CampaignOptions& options) {
  checkOptions(options);
  const Campaign campaign = campaignKindOf(options.kind).make(options.request);
  return CampaignDesk(options, campaign).run(workersOf(options), nullptr);
}

/// Runs a campaign on several ranks. All ranks read and prepare the same input. Only the first rank reports errors,
/// keeps checkpoints and writes results.
int runRanked(const CampaignOptions& options, Ranks& ranks) {
  std::optional<InputError> wrong;
  std::optional<Campaign> campaign;
  std::optional<CampaignDesk> desk;
  try {
    checkOptions(options);
    campaign = campaignKindOf(options.kind).make(options.request);
    if (ranks.rank() == 0) desk.emplace(options, *campaign);
  } catch (const InputError& error) {
    wrong = error;
  }
  std::string question;
  if (campaign)
    for (const auto& [name, value] : campaign->question) question += name + ": " + value + "\n";
  const bool is_same = ranks.fromFirst(question) == question;
  if (!ranks.isTrueOnAllRanks(is_same && !wrong)) {
    // mpirun stops all ranks at the first nonzero exit code, so only the rank that reports the error may return one.
    if (ranks.rank() > 0) return kDone;
    if (wrong) throw *wrong;
    throw InputError::problem("campaign",
                              "one of the machines has different options or files, or could not read its files",
                              "copy the same program and files to every machine, and give the same options");
  }
  if (desk) return desk->run(workersOf(options), &ranks);
  noteStopSignals();  // signals must not end this rank, because the first rank decides when to stop
  serveRuns(*campaign->experiment, workersOf(options), ranks);
  return kDone;
}

int run(const CampaignOptions& options) {
  if (!areRanksLaunched()) return runAlone(options);
  if (!isBuiltForRanks())
    throw InputError::problem("campaign",
                              "several processes were started together, but this program was built without MPI",
                              "start one process with --jobs, or build the program where CMake finds MPI");
  Ranks ranks;
  return runRanked(options, ranks);
}

std::string kindHelp() {
  std::string text = "kind of study that each run belongs to:";
  for (const auto& kind : campaignKinds()) text += fmt::format("\n{}: {}", kind.name, kind.summary);
  return text;
}

}  // namespace

Run configureCampaign(CLI::App& cli) {
  const auto options = std::make_shared<CampaignOptions>();
  addCell(cli, options->request.cell);
  cli.add_option("--runs", options->runs, "number of runs, up to 1000000000")->required();
  cli.add_option("--kind", options->kind, kindHelp())->capture_default_str();
  addSeed(cli, options->request.seed, "seed of the random numbers");
  cli.add_option(
      "--jobs", options->jobs,
      isBuiltForRanks()
          ? "workers on this machine (default: one for each core); several machines: mpirun -n N tubeplan campaign ..."
          : "workers (default: one for each core); this program was built without MPI, so on one machine only");
  cli.add_option("--out", options->out,
                 "the folder for results and checkpoint: after a stop the same command continues, also with more runs");
  cli.add_flag("--resume", options->resume, "continue the campaign in the folder; refuse if its options differ");
  addFigures(cli, options->figures);
  addKindOptions(cli, options->request);
  return [options, &cli] {
    requireOptionsOf(cli, options->kind);
    return run(*options);
  };
}

}  // namespace tubeplan::app
