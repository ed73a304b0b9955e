// `tubeplan campaign` writes the same bytes for any number of workers and processes, resumes after a stop, refuses
// wrong input, and agrees with `score --runs`.
#include <signal.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

using nlohmann::json;

class CampaignCommand : public ProgramTest {
 protected:
  static std::string mockup(const std::string& more) { return "campaign " + shipped("mockup.yaml") + " " + more; }

  [[nodiscard]] json figuresOf(const std::string& arguments) const {
    const Outcome outcome = run(arguments + " --json -");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
  }

  void expectRefused(const std::string& arguments, const std::string& word) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    expectSays(outcome.err, word);
    EXPECT_TRUE(outcome.out.empty()) << outcome.out;
  }

  void expectSameFiles(const std::string& one, const std::string& other) const {
    for (const char* file : {"campaign.json", "holes.csv", "report.html", "tally.json"})
      EXPECT_EQ(contentOf(folder / one / file), contentOf(folder / other / file)) << file;
  }

  /// Runs a shell command in the folder and returns its wait status. Once a tally file exists, sends the signal to the
  /// process whose id `find` prints, or to the command itself if `find` is empty.
  [[nodiscard]] int stopped(const std::string& line, const std::string& out, int signal_number,
                            const std::string& find = "") const {
    const std::string command = "cd '" + folder.string() + "' && exec " + line + " --out " + out + " >stopped.txt 2>&1";
    const pid_t child = ::fork();
    if (child == 0) {
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
    int status = 0;
    while (!std::filesystem::exists(folder / out / "tally.json")) {
      if (::waitpid(child, &status, WNOHANG) == child) return status;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    if (find.empty()) {
      ::kill(child, signal_number);
    } else {
      const std::string kill = find + " > pid.txt";
      (void)std::system(("cd '" + folder.string() + "' && " + kill).c_str());
      const int found = std::atoi(contentOf(folder / "pid.txt").c_str());
      EXPECT_GT(found, 1) << "no process to end";
      if (found > 1) ::kill(found, signal_number);
    }
    ::waitpid(child, &status, 0);
    return status;
  }

  [[nodiscard]] static bool hasMpirun() {
    return std::system("command -v mpirun >/dev/null 2>&1") == 0 &&
           std::system("'" TUBEPLAN_PROGRAM "' campaign --help | grep -q mpirun") == 0;
  }
  static std::string mpirun(int ranks) {
    const std::string root = ::getuid() == 0 ? "--allow-run-as-root " : "";
    // Open MPI itself leaks memory, which a build with the address sanitizer would report.
    return "env ASAN_OPTIONS=detect_leaks=0 OMPI_MCA_rmaps_base_oversubscribe=1 mpirun " + root +
           "--oversubscribe -n " + std::to_string(ranks) + " '" TUBEPLAN_PROGRAM "' ";
  }
};

const std::string kQuestion = "--runs 90 --tubes spread:40 --touches 3,4 --choice best,random --seed 5";

TEST_F(CampaignCommand, WritesTheSameBytesForAnyNumberOfWorkers) {
  for (const std::string jobs : {"1", "2", "5"})
    ASSERT_EQ(run(mockup(kQuestion + " --jobs " + jobs + " --out by" + jobs)).exit_code, 0);
  expectSameFiles("by1", "by2");
  expectSameFiles("by1", "by5");
  const json figures = json::parse(contentOf(folder / "by1/campaign.json"));
  EXPECT_EQ(figures["status"], "done");
  ASSERT_EQ(figures["settings"].size(), 4u);
  for (const auto& setting : figures["settings"]) {
    EXPECT_EQ(setting["runs"], 90);
    const auto scored = setting["scored"].get<int>();
    int refused = 0;
    for (const auto& reason : setting["refused"]) refused += reason["runs"].get<int>();
    EXPECT_EQ(scored + refused, 90);
    for (const char* way : {"none", "compensated"})
      EXPECT_EQ(setting[way]["visits"].get<int>() + setting[way]["missed"].get<int>(), 10 * scored);
    EXPECT_LT(setting["compensated"]["mean"]["value"], setting["none"]["mean"]["value"]);
    EXPECT_LE(setting["compensated"]["quantiles"]["50"], setting["compensated"]["quantiles"]["99"]);
  }
}

TEST_F(CampaignCommand, ASettingDoesNotDependOnTheOthersAskedWithIt) {
  const json both = figuresOf(mockup("--runs 20 --tubes spread:40 --touches 3,6"));
  const json one = figuresOf(mockup("--runs 20 --tubes spread:40 --touches 6"));
  EXPECT_EQ(both["settings"][1], one["settings"][0]);
}

TEST_F(CampaignCommand, WithoutNoiseCompensationCentres) {
  const json figures =
      figuresOf(mockup("--runs 12 --tubes spread:30 --touch-sigma 0 --encoder-sigma 0 --unmodelled 0 --stiffness 0"));
  const auto& setting = figures["settings"][0];
  EXPECT_EQ(setting["scored"], 12);                // the holes to touch are within reach for every base drawn
  EXPECT_LT(setting["compensated"]["max"], 1e-6);  // [in]
  // In every hole reached, at least one step enters; the tool's tilt may keep the third step out.
  EXPECT_EQ(setting["compensated"]["steps"][0]["probability"]["value"], 1);
  // A run lacks a step in some hole only if the true arm cannot reach that hole.
  const double missed = setting["compensated"]["missed"], visits = setting["compensated"]["visits"];
  EXPECT_EQ(missed + visits, 120);
  EXPECT_GE(setting["compensated"]["steps"][0]["in_all_holes"]["value"].get<double>(), 1 - missed / 12 - 1e-9);
  EXPECT_GT(setting["none"]["mean"]["value"], 0.01);
}

TEST_F(CampaignCommand, MoreNoiseMeansLargerErrorsAndMoreTouchesSmaller) {
  const json noise = figuresOf(mockup("--runs 60 --tubes spread:40 --unmodelled 0 --touch-sigma 0.002,0.02"));
  const json touches = figuresOf(mockup("--runs 60 --tubes spread:40 --touches 3,12"));
  const auto mean = [](const json& figures, int setting) {
    return figures["settings"][setting]["compensated"]["mean"]["value"].get<double>();
  };
  EXPECT_LT(1.5 * mean(noise, 0), mean(noise, 1));
  EXPECT_LT(1.1 * mean(touches, 1), mean(touches, 0));
}

/// Returns the mean over runs of the fraction of ten holes that take at least `at_least` steps, and its standard error.
std::pair<double, double> shareOfSteps(const json& counts_by_run, std::size_t at_least) {
  double sum = 0, squares = 0;
  const auto runs = static_cast<double>(counts_by_run.size());
  for (const auto& counts : counts_by_run) {
    double share = 0;
    for (std::size_t k = at_least; k < counts.size(); ++k) share += counts[k].get<double>() / 10;
    sum += share;
    squares += share * share;
  }
  return {sum / runs, std::sqrt((squares - sum * sum / runs) / (runs - 1) / runs)};
}

TEST_F(CampaignCommand, AgreesWithScoreOnTheSameSettings) {
  const Outcome score = run("score " + shipped("mockup.yaml") + " --truth " + shipped("mockup-true.yaml") +
                            " --runs 120 --seed 3 --json -");
  ASSERT_EQ(score.exit_code, 0) << score.err;
  const json scored = json::parse(score.out);
  const json figures =
      figuresOf(mockup("--truth " + shipped("mockup-true.yaml") + " --runs 300 --choice tested --seed 4"));
  const std::pair<const char*, const char*> ways[] = {{"none", "none"}, {"goal_point", "compensated"}};
  for (const auto& [mode, way] : ways) {
    const auto& setting = figures["settings"][0][way];
    for (std::size_t k = 1; k <= 3; ++k) {
      const auto [share, error] = shareOfSteps(scored[mode]["counts_by_run"], k);
      const auto& chance = setting["steps"][k - 1]["probability"];
      const double sigma = std::hypot(error, (chance["high"].get<double>() - chance["low"].get<double>()) / 3.92);
      EXPECT_NEAR(chance["value"].get<double>(), share, 4 * sigma + 1e-9) << way << ", " << k << " steps";
    }
    // The mean of `score` over 120 runs has a standard error sqrt(300 / 120) times that of the campaign over 300 runs.
    const double sigma = setting["mean"]["sigma"].get<double>() * std::hypot(1, std::sqrt(300. / 120));
    EXPECT_NEAR(setting["mean"]["value"].get<double>(), scored[mode]["mean_centring_error"].get<double>(), 4 * sigma);
  }
}

TEST_F(CampaignCommand, GoesOnAfterAStopToTheSameBytesAndToMoreRuns) {
  const std::string question = mockup("--tubes spread:40 --seed 8 --jobs 2 --runs ");
  const int status = stopped("'" TUBEPLAN_PROGRAM "' " + question + "1200", "stopped", SIGINT);
  ASSERT_TRUE(WIFEXITED(status));
  ASSERT_EQ(WEXITSTATUS(status), 130) << contentOf(folder / "stopped.txt");
  expectSays(contentOf(folder / "stopped.txt"), "the same command continues from there");
  EXPECT_FALSE(std::filesystem::exists(folder / "stopped/campaign.json"));
  const std::string kept = contentOf(folder / "stopped/tally.json");

  // With other arguments, the campaign is refused if --resume is given; otherwise it prints a message and starts again.
  expectRefused(mockup("--tubes spread:40 --seed 9 --runs 1200 --resume --out stopped"), "another seed (8, now 9)");
  expectRefused(mockup("--tubes spread:41 --seed 8 --runs 1200 --resume --out stopped"), "another list of tubes");
  expectRefused(question + "1 --resume --out stopped", "more runs");
  EXPECT_EQ(contentOf(folder / "stopped/tally.json"), kept);
  std::filesystem::create_directories(folder / "other");
  (void)write("other/tally.json", kept);
  const Outcome anew = run(mockup("--tubes spread:40 --seed 9 --runs 5 --out other"));
  EXPECT_EQ(anew.exit_code, 0);
  expectSays(anew.err, "started again: ");
  expectSays(anew.err, "renamed to tally-1.json");
  EXPECT_EQ(contentOf(folder / "other/tally-1.json"), kept);
  ASSERT_EQ(run(mockup("--tubes spread:40 --seed 10 --runs 5 --out other")).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "other/tally-2.json"));

  const Outcome resumed = run(question + "1200 --resume --out stopped");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  expectSays(resumed.err, "continuing from ");
  ASSERT_EQ(run(question + "1200 --out whole").exit_code, 0);
  expectSameFiles("stopped", "whole");
  ASSERT_EQ(run(question + "1250 --resume --out stopped").exit_code, 0);
  ASSERT_EQ(run(question + "1250 --out more").exit_code, 0);
  expectSameFiles("stopped", "more");
}

TEST_F(CampaignCommand, RefusesDamagedTallies) {
  const std::string question = mockup("--tubes spread:30 --runs 4 --out made");
  expectRefused(question + " --resume", "no campaign (tally.json) in ");
  expectRefused(question + "1 --design bench", "--kind diagnose");
  expectRefused(mockup("--kind diagnose --runs 1 --holes 4"), "--kind centre");
  ASSERT_EQ(run(question).exit_code, 0);
  const std::string tally = contentOf(folder / "made/tally.json");
  std::string altered = tally;
  altered[altered.find("\"total\":[") + 9] ^= 1;
  for (const std::string& damaged : {altered, tally.substr(0, tally.size() / 2), std::string("{}\n{}\n")}) {
    (void)write("made/tally.json", damaged);
    expectRefused(question, "remove that file to start again");
  }
  (void)write("made/tally.json", changed(tally, R"(["seed","1"])", R"(["seed","2"])"));
  expectRefused(question + " --seed 2 --resume", "first line does not match its checksum");
}

TEST_F(CampaignCommand, RefusesBadInputWithOneMessage) {
  for (const char* runs : {"0", "-3", "1000000001", "99999999999999999999", "nan", "1e4", "''"})
    expectRefused(mockup(std::string("--runs ") + runs), "runs");
  const std::string some = "--runs 5 --tubes spread:30 ";
  for (const char* sigma : {"nan", "inf", "-0.1", "1e300", "0.01,0.01"})
    expectRefused(mockup(some + "--touch-sigma=" + sigma), "--touch-sigma");
  for (const char* option : {"--unmodelled", "--base-shift", "--base-turn", "--stiffness", "--encoder-sigma"})
    for (const char* value : {"nan", "-1", "1e9"}) expectRefused(mockup(some + option + "=" + value), option);
  for (const char* touches : {"2", "0", "-4", "500", "3,3"})
    expectRefused(mockup(some + "--touches=" + touches), "--touches");
  expectRefused(mockup(some + "--touches 30 --choice best"), "can be touched");
  expectRefused(mockup(some + "--touches 11 --choice tested"), "visited in a run");
  expectRefused(mockup(some + "--choice bst"), "did you mean");
  expectRefused(mockup(some + "--kind center"), "centre");
  expectRefused(mockup(some + "--holes 0"), "--holes");
  expectRefused(mockup(some + "--holes 31"), "reachable holes");
  expectRefused(mockup(some + "--jobs=-1"), "--jobs");
  expectRefused(mockup(some + "--resume"), "--out");
  expectRefused(mockup(some + "--truth " + shipped("bench.yaml")), "bench");
  expectRefused("campaign " + shipped("bench.yaml") + " --runs 5", "bench");
  expectRefused("campaign " + shipped("bench.yaml") + " --kind diagnose --runs 5 --nothing 1.5", "--nothing");
  expectRefused("campaign " + shipped("bench.yaml") + " --kind diagnose --runs 5 --hide backlas", "did you mean");
  expectRefused("campaign " + shipped("bench.yaml") + " --kind diagnose --runs 5 --readings 0", "--readings");
}

TEST_F(CampaignCommand, SaysHowManyDiagnosesWereWithoutAVerdict) {
  const std::string few =
      "campaign " + shipped("bench.yaml") + " --kind diagnose --runs 3 --seed 1 --nothing 0 --readings ";
  const Outcome undecided = run(few + "3"), impossible = run(few + "1");
  expectSays(undecided.out, "an effect hidden: 3 runs inconclusive");
  expectSays(impossible.out, "an effect hidden: 3 runs not made");
}

TEST_F(CampaignCommand, CountsWhatDiagnosesSay) {
  const std::string question = "campaign " + shipped("bench.yaml") + " --kind diagnose --runs 6 --readings 60 --seed 2";
  ASSERT_EQ(run(question + " --jobs 1 --out one").exit_code, 0);
  ASSERT_EQ(run(question + " --jobs 2 --out two").exit_code, 0);
  for (const char* file : {"campaign.json", "outcomes.csv", "report.html", "tally.json"})
    EXPECT_EQ(contentOf(folder / "one" / file), contentOf(folder / "two" / file)) << file;
  const json figures = json::parse(contentOf(folder / "one/campaign.json"));
  int sum = 0;
  for (const auto& counts : {figures["nothing_hidden"]["outcomes"], figures["hidden"]["outcomes"]})
    for (const auto& count : counts) sum += count.get<int>();
  EXPECT_EQ(sum, 6);
  const json one_kind = figuresOf("campaign " + shipped("bench.yaml") +
                                  " --kind diagnose --runs 4 --readings 60 --nothing 0 --hide scale-error --seed 3");
  EXPECT_EQ(one_kind["by_effect"].size(), 1u);
  EXPECT_EQ(one_kind["nothing_hidden"]["false_alarms"]["of"], 0);
}

TEST_F(CampaignCommand, SeveralProcessesWriteTheSameBytes) {
  if (!hasMpirun()) GTEST_SKIP() << "no mpirun here, or a program built without MPI: nothing of MPI was tested";
  const std::string question = mockup(kQuestion);
  ASSERT_EQ(run(question + " --jobs 1 --out alone").exit_code, 0);
  for (const int ranks : {1, 2, 3}) {
    const std::string out = "by" + std::to_string(ranks);
    const std::string command = "cd '" + folder.string() + "' && " + mpirun(ranks) + question + " --jobs 1 --out " +
                                out + " >said.txt 2>&1 </dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0) << contentOf(folder / "said.txt");
    expectSameFiles("alone", out);
  }
  // If the input is bad, only one of the processes reports it.
  const std::string bad = "cd '" + folder.string() + "' && " + mpirun(2) + mockup("--runs 0") + " >said.txt 2>&1";
  EXPECT_NE(std::system(bad.c_str()), 0);
  const std::string said = contentOf(folder / "said.txt");
  EXPECT_NE(said.find("tubeplan: --runs"), std::string::npos) << said;
  EXPECT_EQ(said.find("tubeplan: --runs"), said.rfind("tubeplan: --runs")) << said;
}

TEST_F(CampaignCommand, AProcessThatIsKilledLosesLittle) {
  if (!hasMpirun()) GTEST_SKIP() << "no mpirun here, or a program built without MPI: nothing of MPI was tested";
  const std::string question = mockup("--tubes spread:40 --seed 8 --jobs 1 --runs 2000");
  // This shell command prints the process id of rank 1, found by the environment variable that mpirun sets.
  const std::string second =
      "for p in $(pgrep -x tubeplan); do tr '\\0' '\\n' 2>/dev/null </proc/$p/environ | grep -qx "
      "OMPI_COMM_WORLD_RANK=1 "
      "&& [ \"$(readlink /proc/$p/cwd)\" = \"$(pwd -P)\" ] && echo $p; done";
  const int status = stopped(mpirun(2) + question, "killed", SIGKILL, second);
  EXPECT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << contentOf(folder / "stopped.txt");
  ASSERT_TRUE(std::filesystem::exists(folder / "killed/tally.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "killed/campaign.json"));
  const Outcome resumed = run(question + " --resume --out killed");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  expectSays(resumed.err, "continuing from ");
  ASSERT_EQ(run(question + " --out whole").exit_code, 0);
  expectSameFiles("killed", "whole");
}

}  // namespace
}  // namespace tubeplan::app
